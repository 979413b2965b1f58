#include "SessionIndex.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numeric>

#include "DiskFile.h"
#include "SessionFolder.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

bool is_whole_number(const std::string& cell) {
  return !cell.empty() && std::all_of(cell.begin(), cell.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

double finite_number(const std::string& cell, const char* column) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (cell.empty() || code != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
    throw InputError("\"" + cell + "\" in column " + column + " is not a number");
  }
  return value;
}

Measurement parse_measurement(const std::string& line, const std::vector<Measurement>& before) {
  const auto cells = split_csv(line);
  if (!is_whole_number(cells[0])) throw InputError("\"" + cells[0] + "\" in column frame is not a whole number");
  if (cells.size() > 1) finite_number(cells[1], "time_s");
  const Measurement row = measurement_from_csv(line);
  if (!before.empty() && row.frame <= before.back().frame) throw InputError("frame number does not rise");
  return row;
}

Event parse_event(const std::string& line, const std::vector<Event>&) {
  const auto cells = split_csv(line);
  if (cells.size() < 3) throw InputError("a row of " + std::to_string(cells.size()) + " cells; 3 are needed");
  return {finite_number(cells[0], "time_s"), cells[1], cells[2]};
}

// Reads a table line by line; a line that lacks its end was cut off, even where it happens to parse.
template <class Row, class Parse>
SessionTable<Row> read_table(const std::filesystem::path& file, std::string_view header, Parse parse) {
  SessionTable<Row> table;
  if (!std::filesystem::exists(file)) return table;
  table.present = true;
  const std::string text = read_whole_file(file);
  std::size_t number = 0;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start);
    const bool whole = end != std::string::npos;
    std::string line = text.substr(start, whole ? end - start : std::string::npos);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    start = whole ? end + 1 : text.size();
    if (++number == 1) {
      table.header_right = whole && line.starts_with(header);
      continue;
    }
    try {
      if (!whole) throw InputError("cut off in the middle");
      table.rows.push_back(parse(line, table.rows));
      table.lines.push_back(std::move(line));
    } catch (const Error& error) {
      table.bad.push_back({number, std::move(line), error.what()});
    }
  }
  return table;
}

}  // namespace

SessionTable<Measurement> read_measurements(const std::filesystem::path& file) {
  return read_table<Measurement>(file, measurement_header_start(), parse_measurement);
}

SessionTable<Event> read_events(const std::filesystem::path& file) {
  SessionTable<Event> table = read_table<Event>(file, session_name::kEventsHeader, parse_event);
  // Events of frames are known when the frames are measured, others at once: lines come nearly in order only.
  std::vector<std::size_t> order(table.rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return table.rows[a].time_s < table.rows[b].time_s; });
  SessionTable<Event> sorted = table;
  for (std::size_t i = 0; i < order.size(); ++i) {
    sorted.rows[i] = std::move(table.rows[order[i]]);
    sorted.lines[i] = std::move(table.lines[order[i]]);
  }
  return sorted;
}

std::uint64_t dropped_frame_count(const Event& event) {
  if (event.kind != event_kind::kDropped) return 0;
  std::uint64_t count = 1;
  std::from_chars(event.detail.data(), event.detail.data() + event.detail.size(), count);
  return count;
}

void sort_events(const std::filesystem::path& file) {
  std::string text = std::string(session_name::kEventsHeader) + '\n';
  for (const std::string& line : read_events(file).lines) text += line + '\n';
  replace_file(file, text);
}

SessionFiles list_files(const std::filesystem::path& session) {
  SessionFiles files;
  const auto look_at = [&](const std::filesystem::path& folder, const auto& take) {
    std::error_code status;
    for (const auto& entry : std::filesystem::directory_iterator(folder, status)) {
      const std::string name = entry.path().filename().string();
      if (name.ends_with(kTemporarySuffix)) {
        files.temporary.push_back(entry.path());
      } else {
        take(name);
      }
    }
  };
  look_at(session, [](const std::string&) {});
  for (const PartNames& names : kParts) {
    look_at(session / names.folder, [&](const std::string& name) {
      const auto index = frame_index_of(names.part, name);
      if (index) files.frames[static_cast<std::size_t>(names.part)].push_back(*index);
    });
  }
  look_at(session / session_name::kHaptics, [&](const std::string& name) {
    if (const auto block = hand_block_of(name)) files.hand_blocks.push_back(*block);
  });
  for (auto& frames : files.frames) std::sort(frames.begin(), frames.end());
  std::sort(files.hand_blocks.begin(), files.hand_blocks.end());
  return files;
}

std::vector<SessionStep> make_steps(const std::vector<Measurement>& rows, const SessionFiles& files) {
  std::vector<SessionStep> steps;
  steps.reserve(rows.size());
  for (const Measurement& row : rows) {
    SessionStep step{.frame_index = row.frame, .time_s = row.time_s};
    for (std::size_t part = 0; part < kSessionPartCount; ++part) {
      step.present[part] = std::binary_search(files.frames[part].begin(), files.frames[part].end(), row.frame);
    }
    steps.push_back(step);
  }
  return steps;
}

}  // namespace pellucida
