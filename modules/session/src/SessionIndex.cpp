#include "SessionIndex.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <span>

#include "DiskFile.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

// A line of a session's table is a few hundred bytes; longer ones are no such lines.
constexpr std::size_t kMostLineBytes = 1U << 16U;
// A damaged session has some; with more, it is no table of a session.
constexpr std::size_t kMostBadLines = 100000;

double finite_number(std::string_view cell, const char* column) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (cell.empty() || code != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
    throw InputError("\"" + std::string(cell) + "\" in column " + column + " is not a number");
  }
  return value;
}

// Digits alone; a number of a frame is stamped as Int32.
void require_frame_number(std::string_view cell) {
  std::int32_t frame = -1;
  const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), frame);
  if (code != std::errc() || end != cell.data() + cell.size() || frame < 0) {
    throw InputError("\"" + std::string(cell) + "\" in column frame is not a whole number");
  }
}

// What was not measured is an empty cell, never "nan".
void require_digits(std::span<const std::string_view> cells) {
  constexpr std::size_t kState = 2;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i != kState && cells[i].find_first_of("nN") != std::string_view::npos) {
      throw InputError("\"" + std::string(cells[i]) + "\" is not a number");
    }
  }
}

// What a column may hold is written beside its name.
void require_meaning(const Measurement& row) {
  for (const Field<Measurement>& column : measurement_columns()) {
    const double value = row.*std::get<double Measurement::*>(column.member);
    if (std::isnan(value)) continue;
    if (!std::isfinite(value)) throw InputError("column " + std::string(column.name) + " is not a finite number");
    if (const auto fault = range_fault(column.name, value, column.range)) throw InputError(*fault);
  }
}

Measurement parse_measurement(std::span<const std::string_view> cells, const std::vector<Measurement>& before) {
  require_frame_number(cells[0]);
  constexpr double kLongest_s = 1e9;
  if (cells.size() > 1 && std::abs(finite_number(cells[1], "time_s")) > kLongest_s) {
    throw InputError("\"" + std::string(cells[1]) + "\" in column time_s is no time of a session");
  }
  require_digits(cells);
  const Measurement row = measurement_from_cells(cells);
  require_meaning(row);
  if (!before.empty() && row.frame <= before.back().frame) throw InputError("frame number does not rise");
  return row;
}

void require_three(std::span<const std::string_view> cells) {
  if (cells.size() < 3) throw InputError("a row of " + std::to_string(cells.size()) + " cells; 3 are needed");
}

Event parse_event(std::span<const std::string_view> cells, const std::vector<Event>&) {
  require_three(cells);
  return {finite_number(cells[0], "time_s"), std::string(cells[1]), std::string(cells[2])};
}

FileChecksum parse_checksum(std::span<const std::string_view> cells, const std::vector<FileChecksum>&) {
  require_three(cells);
  const auto name = data_name_of(cells[0]);
  if (!name) throw InputError("\"" + std::string(cells[0]) + "\" is no data file of a session");
  FileChecksum file{.name = *name};
  const auto [end, code] = std::from_chars(cells[1].data(), cells[1].data() + cells[1].size(), file.byte_count);
  const auto checksum = crc32_from(cells[2]);
  if (code != std::errc() || end != cells[1].data() + cells[1].size() || !checksum) {
    throw InputError("no size and checksum of a file");
  }
  file.crc32 = *checksum;
  return file;
}

// The first line as a header: the columns this version knows, in their order, as many as there are; at the end, later
// versions' and the checksum.
template <class Row>
void take_header(std::string_view line, std::string_view needed, std::string_view known, SessionTable<Row>& table) {
  const std::string checksum = std::string(",") + kRowChecksum;
  const bool checked = line.ends_with(checksum);
  if (checked) line.remove_suffix(checksum.size());
  const auto found = split_csv(line);
  const auto names = split_csv(known);
  if (found.size() < split_csv(needed).size()) return;
  // A line end that was changed would let the first row pass for names of later columns.
  const auto is_name = [](const std::string& cell) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    return !cell.empty() && is_letter(cell[0]) && std::all_of(cell.begin(), cell.end(), [&](char c) {
      return is_letter(c) || c == '_' || (c >= '0' && c <= '9');
    });
  };
  if (!std::all_of(found.begin(), found.end(), is_name)) return;
  if (!std::equal(found.begin(), found.begin() + static_cast<long>(std::min(found.size(), names.size())),
                  names.begin()))
    return;
  table.header_right = true;
  table.header = line;
  table.checked = checked;
}

// Reads a table line by line; a line that lacks its end was cut off, even where it happens to parse.
template <class Row, class Parse>
SessionTable<Row> read_table(const std::filesystem::path& file, std::string_view needed, std::string_view known,
                             bool checked, Parse parse) {
  SessionTable<Row> table;
  if (!is_present(file)) return table;
  table.present = true;
  table.text = std::make_shared<const std::string>(read_whole_file(file));
  const std::string_view text = *table.text;
  const auto line_count = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  // A row is longer than this, so that the memory asked for is in proportion to the file.
  constexpr std::size_t kLeastRowBytes = 8;
  table.rows.reserve(std::min(line_count, text.size() / kLeastRowBytes));
  table.lines.reserve(table.rows.capacity());
  bool header_checked = false;
  std::size_t number = 0;
  CsvCells cells;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start);
    const bool whole = end != std::string_view::npos;
    std::string_view line = text.substr(start, whole ? end - start : std::string_view::npos);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    start = whole ? end + 1 : text.size();
    if (++number == 1) {
      if (whole && line.size() <= kMostLineBytes) take_header(line, needed, known, table);
      header_checked = table.checked;
      if (table.header_right) continue;
    }
    // Where the header is lost, a right checksum shows that there are some.
    if (number <= 2 && verified_row(line)) table.checked = true;
    table.checked = table.checked || checked;
    try {
      if (!whole) throw InputError("cut off in the middle");
      if (line.size() > kMostLineBytes) throw InputError("a line of " + std::to_string(line.size()) + " bytes");
      if (table.checked) {
        const auto row = verified_row(line);
        if (!row) throw InputError("its checksum is wrong: it was changed after it was written");
        line = *row;
      }
      table.rows.push_back(parse(cells.split(line), table.rows));
      table.lines.push_back(line);
    } catch (const Error& error) {
      table.bad.push_back({number, line, error.what()});
      if (table.bad.size() > kMostBadLines) {
        throw InputError(file.string() + ": more than " + std::to_string(kMostBadLines) +
                         " lines can't be read: no table of a session");
      }
    }
  }
  table.checked = table.checked || checked;
  // Rows with checksums below a header without: its last name is damaged.
  if (table.header_right && table.checked != header_checked) {
    table.header_right = false;
    table.header.clear();
  }
  return table;
}

// Puts rows and lines into the order of what `key` says of a row; rows of the same stay as they are.
template <class Row, class Key>
void sort_table(SessionTable<Row>& table, Key key) {
  const auto rises = [&](const Row& a, const Row& b) { return key(a) < key(b); };
  if (std::is_sorted(table.rows.begin(), table.rows.end(), rises)) return;
  std::vector<std::size_t> order(table.rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return key(table.rows[a]) < key(table.rows[b]); });
  std::vector<Row> rows;
  std::vector<std::string_view> lines;
  rows.reserve(order.size());
  lines.reserve(order.size());
  for (const std::size_t i : order) {
    rows.push_back(std::move(table.rows[i]));
    lines.push_back(table.lines[i]);
  }
  table.rows = std::move(rows);
  table.lines = std::move(lines);
}

}  // namespace

SessionTable<Measurement> read_measurements(const std::filesystem::path& file, bool checked) {
  return read_table<Measurement>(file, measurement_header_start(), measurement_header(), checked, parse_measurement);
}

SessionTable<Event> read_events(const std::filesystem::path& file, bool checked) {
  auto table = read_table<Event>(file, session_name::kEventsHeader, session_name::kEventsHeader, checked, parse_event);
  // Events of frames are known when the frames are measured, others at once: lines come nearly in order only.
  sort_table(table, [](const Event& event) { return event.time_s; });
  return table;
}

SessionTable<FileChecksum> read_checksums(const std::filesystem::path& file) {
  constexpr const char* kHeader = session_name::kChecksumsHeader;
  auto table = read_table<FileChecksum>(file, kHeader, kHeader, true, parse_checksum);
  sort_table(table, [](const FileChecksum& one) { return one.name; });
  return table;
}

const FileChecksum* find_checksum(const SessionTable<FileChecksum>& table, const DataName& name) {
  // The last one counts, should there be two.
  const auto after = std::upper_bound(table.rows.begin(), table.rows.end(), name,
                                      [](const DataName& one, const FileChecksum& row) { return one < row.name; });
  return after != table.rows.begin() && std::prev(after)->name == name ? &*std::prev(after) : nullptr;
}

std::string to_csv(const FileChecksum& file) {
  return data_file(file.name) + ',' + std::to_string(file.byte_count) + ',' + crc32_text(file.crc32);
}

void count_left_out(const Event& event, SessionCounts& counts) {
  const bool dropped = event.kind == event_kind::kDropped;
  if (!dropped && event.kind != event_kind::kThinned) return;
  std::uint64_t count = 1;
  std::from_chars(event.detail.data(), event.detail.data() + event.detail.size(), count);
  (dropped ? counts.dropped_count : counts.thinned_count) += count;
}

void sort_events(const std::filesystem::path& file) {
  const SessionTable<Event> table = read_events(file);
  replace_file(file, table_text(table, session_name::kEventsHeader));
}

bool SessionFiles::has_data() const noexcept {
  return !hand_blocks.empty() ||
         std::any_of(frames.begin(), frames.end(), [](const auto& one) { return !one.empty(); });
}

SessionFiles list_files(const std::filesystem::path& session) {
  namespace fs = std::filesystem;
  SessionFiles files;
  const auto look_at = [&](const std::string& folder) {
    std::string name = folder.empty() ? "" : folder + '/';
    const std::size_t start = name.size();
    for_each_entry(folder.empty() ? session : session / folder, [&](const char* entry, bool plain) {
      name.resize(start);
      name += entry;
      if (plain && is_own_temporary(name)) files.temporary.push_back(session / name);
      const auto data = data_name_of(name);
      if (!data) return;
      if (!plain) {
        files.strange.push_back(name);
      } else if (data->kind == kHandKind) {
        files.hand_blocks.push_back(data->number);
      } else {
        files.frames[static_cast<std::size_t>(data->kind)].push_back(data->number);
      }
    });
  };
  look_at("");
  for (const char* name : kOwnFiles) {
    if (is_present(session / name) && !is_plain_file(session / name)) files.links.emplace_back(name);
  }
  std::vector<std::string> folders{session_name::kHaptics, session_name::kDamaged};
  for (const PartNames& names : kParts) folders.emplace_back(names.folder);
  for (const std::string& folder : folders) {
    std::error_code code;
    if (!is_present(session / folder)) continue;
    if (fs::symlink_status(session / folder, code).type() != fs::file_type::directory) {
      files.links.push_back(folder);
    } else if (folder != session_name::kDamaged) {
      look_at(folder);
    }
  }
  for (auto& frames : files.frames) std::sort(frames.begin(), frames.end());
  std::sort(files.hand_blocks.begin(), files.hand_blocks.end());
  std::sort(files.strange.begin(), files.strange.end());
  return files;
}

std::vector<SessionStep> make_steps(const std::vector<Measurement>& rows, const SessionFiles& files) {
  std::vector<SessionStep> steps;
  steps.reserve(rows.size());
  std::array<std::size_t, kSessionPartCount> next{};
  for (const Measurement& row : rows) {
    SessionStep step{.frame_index = row.frame, .time_s = row.time_s};
    for (std::size_t part = 0; part < kSessionPartCount; ++part) {
      // Rows and files rise together.
      const std::vector<long>& frames = files.frames[part];
      std::size_t& at = next[part];
      while (at < frames.size() && frames[at] < row.frame) ++at;
      step.present[part] = at < frames.size() && frames[at] == row.frame;
    }
    steps.push_back(step);
  }
  return steps;
}

}  // namespace pellucida
