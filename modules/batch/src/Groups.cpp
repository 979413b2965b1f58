#include "pellucida/batch/Groups.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include "pellucida/batch/EffectSize.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/FieldCsv.h"
#include "pellucida/core/Statistics.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

using G = GroupRow;
constexpr FieldRange kAnyFigure;
constexpr Field<G> kGroupColumns[] = {
    {"group", "", &G::group, kAnyFigure, "the group"},
    {"quantity", "", &G::quantity, kAnyFigure, "a column of `summary.csv`"},
    {"n", "", &G::count, kAnyFigure, "recordings of the group that were measured to their end and have a number there"},
    {"median", "", &G::median, kAnyFigure, "median of these numbers, in the unit that ends the quantity's name"},
    {"lower_quartile", "", &G::lower_quartile, kAnyFigure, "a quarter of them lies below"},
    {"upper_quartile", "", &G::upper_quartile, kAnyFigure, "a quarter of them lies above"},
    {"hedges_g", "", &G::hedges_g, kAnyFigure,
     "Hedges' g against the first group: difference of the means, this group less the first, over the pooled standard "
     "deviation, corrected for small samples"},
    {"hedges_g_lower", "", &G::hedges_g_lower, kAnyFigure, "lower end of its 95 % bootstrap interval"},
    {"hedges_g_upper", "", &G::hedges_g_upper, kAnyFigure, "upper end of it"},
    {"cliffs_delta", "", &G::cliffs_delta, kAnyFigure,
     "Cliff's delta against the first group: share of pairs in which this group has the larger number less the share "
     "in "
     "which it has the smaller, -1 to 1"},
    {"cliffs_delta_lower", "", &G::cliffs_delta_lower, kAnyFigure, "lower end of its 95 % bootstrap interval"},
    {"cliffs_delta_upper", "", &G::cliffs_delta_upper, kAnyFigure, "upper end of it"},
};

using S = RecordingSummary;
constexpr GroupQuantity kQuantities[] = {
    {"peak_force_uN", "peak force, µN", &S::peak_force_uN},
    {"peak_depth_um", "depth at peak force, µm", &S::peak_depth_um},
    {"peak_stiffness_uN_per_um", "stiffness at peak force, µN/µm", &S::peak_stiffness_uN_per_um},
    {"puncture_force_uN", "puncture force, µN", &S::puncture_force_uN},
    {"puncture_depth_um", "puncture depth, µm", &S::puncture_depth_um},
    {"duration_s", "duration, s", &S::duration_s},
    {"measured_share", "share of frames measured", &S::measured_share},
};

void set_effects(const std::vector<double>& reference, const std::vector<double>& values, GroupRow& row) {
  const EffectSize g = effect_size(hedges_g, reference, values);
  row.hedges_g = g.value;
  row.hedges_g_lower = g.lower;
  row.hedges_g_upper = g.upper;
  const EffectSize delta = effect_size(cliffs_delta, reference, values);
  row.cliffs_delta = delta.value;
  row.cliffs_delta_lower = delta.lower;
  row.cliffs_delta_upper = delta.upper;
}

std::string without_end(std::string line) {
  while (!line.empty() && (line.back() == '\r' || line.back() == '\n')) line.pop_back();
  return line;
}

bool is_called(const Recording& recording, const std::string& word) {
  const fs::path input = recording.input;
  if (word == recording.name || word == recording.input || word == input.filename() || word == input.stem())
    return true;
  std::error_code ignored;
  return fs::exists(word, ignored) && fs::exists(input, ignored) && fs::equivalent(word, input, ignored);
}

}  // namespace

std::span<const Field<GroupRow>> group_columns() noexcept {
  return kGroupColumns;
}

std::span<const GroupQuantity> group_quantities() noexcept {
  return kQuantities;
}

std::vector<std::string> groups_of(std::span<const BatchRow> rows) {
  std::vector<std::string> groups;
  for (const BatchRow& row : rows) {
    if (!row.group.empty() && std::find(groups.begin(), groups.end(), row.group) == groups.end())
      groups.push_back(row.group);
  }
  return groups;
}

std::vector<double> values_in(std::span<const BatchRow> rows, const std::string& group, const GroupQuantity& quantity) {
  std::vector<double> values;
  for (const BatchRow& row : rows) {
    const double value = row.numbers.*quantity.value;
    if (row.group == group && row.result == batch_result::kMeasured && !std::isnan(value)) values.push_back(value);
  }
  return values;
}

std::vector<GroupRow> compare_groups(std::string_view quantity, std::span<const std::string> groups,
                                     std::vector<std::vector<double>> values) {
  std::vector<GroupRow> result;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    std::sort(values[k].begin(), values[k].end());
    GroupRow row;
    row.group = groups[k];
    row.quantity = quantity;
    row.count = static_cast<int>(values[k].size());
    if (!values[k].empty()) {
      row.median = quantile(values[k], 0.5);
      row.lower_quartile = quantile(values[k], 0.25);
      row.upper_quartile = quantile(values[k], 0.75);
    }
    if (k > 0) set_effects(values.front(), values[k], row);
    result.push_back(std::move(row));
  }
  return result;
}

std::vector<GroupRow> compare_groups(std::span<const BatchRow> rows, std::span<const std::string> groups) {
  std::vector<GroupRow> result;
  for (const GroupQuantity& quantity : kQuantities) {
    std::vector<std::vector<double>> values;
    for (const std::string& group : groups) values.push_back(values_in(rows, group, quantity));
    const auto compared = compare_groups(quantity.name, groups, std::move(values));
    result.insert(result.end(), compared.begin(), compared.end());
  }
  return result;
}

std::string groups_csv(std::span<const GroupRow> groups) {
  std::string text = csv_header(group_columns()) + '\n';
  for (const GroupRow& row : groups) text += csv_row(group_columns(), row) + '\n';
  return text;
}

Conditions take_conditions(const fs::path& table, std::vector<Recording>& recordings) {
  std::ifstream stream(table);
  if (!stream) throw InputError(table.string() + ": can't be opened; check the path and the permission");
  std::string line;
  std::getline(stream, line);
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (line.starts_with(kByteOrderMark)) line.erase(0, kByteOrderMark.size());
  const auto header = split_csv(without_end(line));
  const auto place_of = [&](const char* column) {
    const auto place = std::find(header.begin(), header.end(), column);
    if (place == header.end()) {
      throw InputError(table.string() + ": no column \"" + column + "\"; the header line must be recording,group");
    }
    return static_cast<std::size_t>(place - header.begin());
  };
  const std::size_t recording_place = place_of("recording"), group_place = place_of("group");

  Conditions conditions;
  for (Recording& recording : recordings) recording.group.clear();
  for (int number = 2; std::getline(stream, line); ++number) {
    line = without_end(line);
    if (line.empty()) continue;
    const auto cells = split_csv(line);
    const std::string where = table.string() + ':' + std::to_string(number);
    if (cells.size() != header.size()) {
      throw InputError(where + ": " + std::to_string(cells.size()) + " cells where the header has " +
                       std::to_string(header.size()) + "; correct or remove the line");
    }
    const std::string& group = cells[group_place];
    bool found = false;
    for (Recording& recording : recordings) {
      if (!is_called(recording, cells[recording_place])) continue;
      found = true;
      if (!recording.group.empty() && recording.group != group) {
        throw InputError(where + ": " + recording.input + " is in the group " + recording.group +
                         " already; name each recording once, by its path where names repeat");
      }
      recording.group = group;
    }
    if (!found) conditions.notes.push_back(where + ": no recording is called " + cells[recording_place]);
    if (!group.empty() &&
        std::find(conditions.groups.begin(), conditions.groups.end(), group) == conditions.groups.end())
      conditions.groups.push_back(group);
  }
  const auto rest = std::count_if(recordings.begin(), recordings.end(), [](const auto& r) { return r.group.empty(); });
  if (rest > 0) {
    conditions.notes.push_back(table.string() + ": " + std::to_string(rest) +
                               (rest == 1 ? " recording" : " recordings") + " in no group");
  }
  return conditions;
}

}  // namespace pellucida
