#include "pellucida/session/Annotations.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <sstream>

#include "DiskFile.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAnnotationHeader = "time_s,x_um,y_um,node,text";
constexpr std::size_t kAnnotationCells = 5;
// With what was measured; a session without it has the columns that earlier versions know.
constexpr const char* kMeasuredHeader = "time_s,x_um,y_um,node,text,x2_um,y2_um,x3_um,y3_um";
constexpr std::size_t kMeasuredCells = 9;
// More than a person writes; a stranger's file is refused above.
constexpr std::uint64_t kMostAnnotationBytes = 16U << 20U;

// Nothing for an empty cell.
template <class Number>
std::optional<Number> number_of(const std::string& cell, const std::string& where) {
  if (cell.empty()) return std::nullopt;
  Number value{};
  const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  const bool is_whole = code == std::errc() && end == cell.data() + cell.size();
  if (!is_whole || !std::isfinite(static_cast<double>(value))) {
    throw InputError(where + ": \"" + cell + "\" is no number; mend the line or remove it");
  }
  return value;
}

std::optional<Annotation::Place> place_of(const std::string& x, const std::string& y, const std::string& where) {
  const auto x_um = number_of<double>(x, where), y_um = number_of<double>(y, where);
  if (!x_um || !y_um) return std::nullopt;
  return Annotation::Place{*x_um, *y_um};
}

Annotation annotation_of(const std::string& line, std::size_t cell_count, const std::string& where) {
  const std::vector<std::string> cells = split_csv(line);
  if (cells.size() != cell_count) {
    throw InputError(where + ": " + std::to_string(cells.size()) + " cells in place of " + std::to_string(cell_count) +
                     "; mend the line or remove it");
  }
  Annotation annotation;
  const auto time_s = number_of<double>(cells[0], where);
  if (!time_s) throw InputError(where + ": no time; mend the line or remove it");
  annotation.time_s = *time_s;
  annotation.place_um = place_of(cells[1], cells[2], where);
  annotation.node = number_of<long>(cells[3], where);
  annotation.text = cells[4];
  for (std::size_t k = kAnnotationCells; annotation.place_um && k + 1 < cells.size(); k += 2) {
    const auto further = place_of(cells[k], cells[k + 1], where);
    if (!further) break;
    annotation.further_um.push_back(*further);
  }
  return annotation;
}

// The cells of both further places, each with a comma before it.
std::string further_places(const Annotation& annotation) {
  std::string cells;
  for (std::size_t k = 0; k < 2; ++k) {
    const bool has = k < annotation.further_um.size();
    cells += ',' + (has ? csv_number(annotation.further_um[k].x_um) : "") + ',' +
             (has ? csv_number(annotation.further_um[k].y_um) : "");
  }
  return cells;
}

std::string line_of(const Annotation& annotation, bool measured) {
  std::string text = annotation.text;
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  const auto& place = annotation.place_um;
  return csv_number(annotation.time_s) + ',' + (place ? csv_number(place->x_um) : "") + ',' +
         (place ? csv_number(place->y_um) : "") + ',' + (annotation.node ? std::to_string(*annotation.node) : "") +
         ',' + csv_cell(text) + (measured ? further_places(annotation) : "");
}

bool is_measured(const Annotation& annotation) {
  return !annotation.further_um.empty();
}

void sort_by_time(std::vector<Annotation>& annotations) {
  std::stable_sort(annotations.begin(), annotations.end(),
                   [](const Annotation& one, const Annotation& other) { return one.time_s < other.time_s; });
}

}  // namespace

std::vector<Annotation> read_annotations(const fs::path& session) {
  const fs::path file = session / kAnnotationsFile;
  if (!is_present(file)) return {};
  std::istringstream content(read_whole_file(file, kMostAnnotationBytes));
  std::vector<Annotation> annotations;
  std::string line;
  std::size_t cell_count = kAnnotationCells;
  for (long number = 1; std::getline(content, line); ++number) {
    const std::string where = file.string() + ": line " + std::to_string(number);
    if (number == 1) {
      if (line == kMeasuredHeader) {
        cell_count = kMeasuredCells;
      } else if (line != kAnnotationHeader) {
        throw InputError(where + ": not \"" + kAnnotationHeader + "\"");
      }
      continue;
    }
    if (!line.empty()) annotations.push_back(annotation_of(line, cell_count, where));
  }
  sort_by_time(annotations);
  return annotations;
}

void write_annotations(const fs::path& folder, std::vector<Annotation> annotations) {
  const fs::path file = folder / kAnnotationsFile;
  if (annotations.empty()) {
    std::error_code fault;
    fs::remove(file, fault);
    if (fault) throw disk_error(file, fault.value());
    return;
  }
  sort_by_time(annotations);
  OutputFile output(file, OutputFile::Link::kReplace);
  const bool measured = std::any_of(annotations.begin(), annotations.end(), is_measured);
  output.add(measured ? kMeasuredHeader : kAnnotationHeader);
  for (const Annotation& annotation : annotations) output.add(line_of(annotation, measured));
  output.finish();
}

}  // namespace pellucida
