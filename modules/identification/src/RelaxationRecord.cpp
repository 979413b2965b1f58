#include "pellucida/identification/RelaxationRecord.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

/// Fewer samples than this are not enough for a part of the record.
constexpr std::size_t kLeastSamples = 10;

struct Sample {
  double time_s = 0.0;
  double height_um = 0.0;
  double force_uN = 0.0;
};

double number(const std::string& cell, const std::string& where) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (cell.empty() || code != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
    throw InputError(where + ": \"" + cell + "\" is not a number");
  }
  return value;
}

}  // namespace

RelaxationRecord read_relaxation_record(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file.string() + ": can't be opened; check the path and the permission");
  std::string line;
  if (!std::getline(stream, line)) throw InputError(file.string() + ": empty; a record starts with a header line");
  const auto names = split_csv(line);
  const std::array<const char*, 4> wanted{"style", "time_s", "height_um", "force_uN"};
  std::array<std::size_t, 4> at{};
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const auto found = std::find(names.begin(), names.end(), wanted[k]);
    if (found == names.end()) {
      throw InputError(file.string() + ": no column \"" + wanted[k] +
                       "\"; a record has the columns segment,style,time_s,height_um,force_uN");
    }
    at[k] = static_cast<std::size_t>(found - names.begin());
  }

  // Rest, ramp, hold; the rest of the file is of no use here.
  std::vector<Sample> samples;
  std::size_t ramp_begin = 0, hold_begin = 0;
  std::string before = "pause";
  for (int row = 2; std::getline(stream, line); ++row) {
    if (line.empty() || line == "\r") continue;
    const auto cells = split_csv(line);
    const std::string where = file.string() + ":" + std::to_string(row);
    if (cells.size() != names.size()) {
      throw InputError(where + ": " + std::to_string(cells.size()) + " cells where the header has " +
                       std::to_string(names.size()) + "; correct or remove the line");
    }
    const std::string& style = cells[at[0]];
    if (style == "retract") break;
    if (style != "pause" && style != "extend") {
      throw InputError(where + ": style \"" + style + "\"; it is pause, extend or retract");
    }
    if (style != before) {
      if (style == "extend" && ramp_begin == 0) {
        ramp_begin = samples.size();
      } else if (style == "pause" && hold_begin == 0) {
        hold_begin = samples.size();
      } else {
        throw InputError(where + ": a second ramp; give a record with one");
      }
      before = style;
    }
    samples.push_back({number(cells[at[1]], where), number(cells[at[2]], where), number(cells[at[3]], where)});
    if (samples.size() > 1 && !(samples.back().time_s > samples[samples.size() - 2].time_s)) {
      throw InputError(where + ": the time doesn't rise");
    }
  }
  if (ramp_begin < kLeastSamples || hold_begin < ramp_begin + kLeastSamples ||
      samples.size() < hold_begin + kLeastSamples) {
    throw InputError(file.string() + ": a record needs " + std::to_string(kLeastSamples) +
                     " samples at least of each in turn: pause, extend, pause");
  }

  RelaxationRecord record;
  const auto count = static_cast<Eigen::Index>(samples.size());
  record.time_s.resize(count);
  record.height_um.resize(count);
  record.force_uN.resize(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Sample& sample = samples[static_cast<std::size_t>(k)];
    record.time_s[k] = sample.time_s;
    record.height_um[k] = sample.height_um;
    record.force_uN[k] = sample.force_uN;
  }
  record.ramp_begin = static_cast<Eigen::Index>(ramp_begin);
  record.hold_begin = static_cast<Eigen::Index>(hold_begin);
  const auto rest = record.force_uN.head(record.ramp_begin);
  record.baseline_uN = rest.mean();
  record.baseline_sigma_uN = std::sqrt((rest.array() - record.baseline_uN).square().mean());
  record.force_uN.array() -= record.baseline_uN;
  return record;
}

}  // namespace pellucida
