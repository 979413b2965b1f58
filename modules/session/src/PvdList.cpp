#include "PvdList.h"

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkXMLParser.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <string_view>

#include "DiskFile.h"
#include "SessionFolder.h"
#include "pellucida/core/Table.h"
#include "pellucida/vtk_files/Silence.h"

namespace pellucida {
namespace {

// The shortest entry of a list; so many entries at most are worth their memory.
constexpr std::size_t kLeastEntryBytes = 16;

struct PvdEntry {
  DataName name;
  double time_s = 0.0;

  auto operator<=>(const PvdEntry&) const = default;
};

// The time as the file spells it; one that is no number is no time of a step.
double time_from(const char* text) {
  double value = std::numeric_limits<double>::infinity();
  std::from_chars(text, text + std::string_view(text).size(), value);
  return value;
}

// Takes the entries as they come, whatever is around them.
class PvdParser : public vtkXMLParser {
 public:
  static PvdParser* New();
  vtkTypeMacro(PvdParser, vtkXMLParser);

  std::vector<PvdEntry> entries;
  std::vector<std::string> foreign;  ///< files listed that are no data file of a session
  std::size_t foreign_count = 0;

 protected:
  void StartElement(const char* name, const char** pairs) override {
    if (std::string_view(name) != "DataSet") return;
    const char* file = nullptr;
    const char* time = "";
    for (; pairs && pairs[0]; pairs += 2) {
      if (std::string_view(pairs[0]) == "file") file = pairs[1];
      if (std::string_view(pairs[0]) == "timestep") time = pairs[1];
    }
    if (file && std::string_view(file) == session_name::kEmpty) return;
    const auto data = data_name_of(file ? file : "");
    if (data) {
      entries.push_back({*data, time_from(time)});
    } else if (++foreign_count == 1) {
      foreign.emplace_back(std::string_view(file ? file : "an entry without a file").substr(0, 200));
    }
  }
  void EndElement(const char*) override {}
};
vtkStandardNewMacro(PvdParser);

// The whole list, held against the text without a second copy of it.
bool is_same(std::string_view text, const std::vector<SessionStep>& steps, bool frames) {
  const auto take = [&](std::string_view expected) {
    if (!text.starts_with(expected)) return false;
    text.remove_prefix(expected.size());
    return true;
  };
  if (!take(kPvdStart)) return false;
  std::string entry;
  for (const SessionStep& step : steps) {
    entry.clear();
    append_pvd(step, frames, entry);
    if (!take(entry)) return false;
  }
  return text == kPvdEnd;
}

}  // namespace

PvdDifference compare_pvd(const std::filesystem::path& file, const std::vector<SessionStep>& steps, bool frames) {
  const std::string text = read_whole_file(file);
  PvdDifference difference;
  if (is_same(text, steps, frames)) return difference;

  difference.readable = false;
  // A cut-off list or one with declarations is not worth a parser.
  if (text.find("</VTKFile>") == std::string::npos || text.find("<!") != std::string::npos) return difference;
  if (text.size() > std::numeric_limits<unsigned>::max()) return difference;
  vtkNew<PvdParser> parser;
  silence(*parser);
  parser->entries.reserve(std::min(text.size() / kLeastEntryBytes, 4 * steps.size()));
  if (parser->Parse(text.c_str(), static_cast<unsigned>(text.size())) == 0) return difference;
  difference.readable = true;

  std::vector<PvdEntry> expected;
  for (const SessionStep& step : steps) {
    for (const PartNames& names : kParts) {
      // A time as the list has it, rounded like there.
      const std::string time = csv_number(step.time_s);
      if (step.has(names.part)) expected.push_back({data_name(names.part, step.frame_index), time_from(time.c_str())});
    }
  }
  std::vector<PvdEntry>& listed = parser->entries;
  std::sort(listed.begin(), listed.end());
  std::sort(expected.begin(), expected.end());
  std::vector<PvdEntry> only;
  std::set_difference(expected.begin(), expected.end(), listed.begin(), listed.end(), std::back_inserter(only));
  difference.missing_count = only.size();
  if (!only.empty()) difference.first_missing = data_file(only.front().name);
  only.clear();
  std::set_difference(listed.begin(), listed.end(), expected.begin(), expected.end(), std::back_inserter(only));
  difference.extra_count = only.size() + parser->foreign_count;
  if (!only.empty()) difference.first_extra = data_file(only.front().name);
  if (only.empty() && parser->foreign_count > 0) difference.first_extra = parser->foreign.front();
  // Everything is listed, yet it is not the list: something else in it was changed.
  if (difference.none()) difference.readable = false;
  return difference;
}

}  // namespace pellucida
