#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "pellucida/core/Event.h"
#include "pellucida/core/Table.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/operation/HapticPathBlock.h"
#include "pellucida/pipeline/BatchRun.h"
#include "pellucida/report/PassportReport.h"
#include "pellucida/session/Annotations.h"
#include "pellucida/session/SessionCheck.h"
#include "pellucida/session/SessionExport.h"
#include "pellucida/session/SessionWriter.h"
#include "pellucida/simulation/VirtualMicroscope.h"

// docs/file-format.md against what is written, in both directions: what is written is on the page, and what is on the
// page is written.

namespace pellucida {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

// The page's text from a heading to the next.
std::string section(const std::string& title) {
  static const std::string page = text_of(fs::path(PELLUCIDA_SOURCE_DIR) / "docs/file-format.md");
  const auto begin = page.find("## " + title + "\n");
  if (begin == std::string::npos) return {};
  return page.substr(begin, page.find("\n## ", begin + 1) - begin);
}

// The cells of a section's tables, without heads; every table must have its head and rule, or it isn't shown as one.
std::vector<std::vector<std::string>> table_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  int row = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("|")) {
      row = 0;
      continue;
    }
    ++row;
    if (row == 2) {
      EXPECT_TRUE(line.starts_with("|---")) << "a broken table: " << line;
    }
    if (row <= 2) continue;
    std::vector<std::string> cells;
    std::istringstream parts(line.substr(1));
    for (std::string cell; std::getline(parts, cell, '|');) cells.push_back(cell);
    rows.push_back(cells);
  }
  return rows;
}

// The words in backticks.
Names names_in(const std::string& text) {
  static const std::regex kName("`([^`]+)`");
  Names names;
  for (std::sregex_iterator i(text.begin(), text.end(), kName), end; i != end; ++i) names.insert((*i)[1]);
  return names;
}

// "points: `a` (3, ...), `b`; field data: `c`" as {"points a 3", "points b 1", "field data c 1"}.
Names arrays_in(const std::string& text) {
  static const std::regex kPart(R"re((cells|points|field data):|`(\w+)`( \((\d)[ ,:)])?)re");
  Names arrays;
  std::string on;
  for (std::sregex_iterator i(text.begin(), text.end(), kPart), end; i != end; ++i) {
    if ((*i)[1].matched) {
      on = (*i)[1];
    } else {
      arrays.insert(on + ' ' + (*i)[2].str() + ' ' + ((*i)[4].matched ? (*i)[4].str() : "1"));
    }
  }
  return arrays;
}

void add_arrays(vtkFieldData* data, const std::string& on, Names& arrays) {
  for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    // One value a membrane counts as one component.
    arrays.insert(on + ' ' + array->GetName() + ' ' + std::to_string(array->GetNumberOfComponents()));
  }
}

template <class Reader>
Names arrays_of(const fs::path& folder) {
  Names arrays;
  for (const auto& entry : fs::directory_iterator(folder)) {
    vtkNew<Reader> reader;
    reader->SetFileName(entry.path().c_str());
    reader->Update();
    add_arrays(reader->GetOutput()->GetPointData(), "points", arrays);
    add_arrays(reader->GetOutput()->GetCellData(), "cells", arrays);
    add_arrays(reader->GetOutput()->GetFieldData(), "field data", arrays);
  }
  return arrays;
}

// A session with all that can be in one: a needle that touches a virtual cell, a hand, a plan, a palpation.
class FileFormat : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    auto scenario = load_scenario("default");
    scenario.image.duration_s = 2.0;
    scenario.image.frame_rate_hz = 10.0;
    VirtualMicroscope microscope(scenario);
    SessionInfo info;
    info.source = microscope.info();
    info.plan_json = "{}";
    info.palpation_json = "{}";
    {
      // Cut off and repaired, so that `recovered` is there too.
      SessionWriter writer(session(), info);
      run_batch(microscope, {}, [&](const Scene& scene) { writer.write(scene); });
      const HapticRecord ticks[2] = {};
      writer.write_hand(make_haptic_path_block(ticks, 0.0), 0.0);
    }
    ASSERT_TRUE(check_session(session(), true).repaired);
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static fs::path session() { return *folder_ / "s"; }

  static Names documented_arrays(const std::string& file) {
    // In each file, from the sentence above the table.
    const std::string text = section("Data files");
    Names arrays = arrays_in("field data: " + text.substr(0, text.find("\n|")));
    for (const auto& row : table_of(text)) {
      if (row.size() < 3 || row[0].find('`' + file + '`') == std::string::npos) continue;
      const Names own = arrays_in(row[2]);
      arrays.insert(own.begin(), own.end());
    }
    return arrays;
  }

 private:
  static std::unique_ptr<TemporaryFolder> folder_;
};
std::unique_ptr<TemporaryFolder> FileFormat::folder_;

TEST_F(FileFormat, TheArraysOfEachFileAreThoseOfThePage) {
  EXPECT_EQ(arrays_of<vtkXMLImageDataReader>(session() / "frames"), documented_arrays("frames/*.vti"));
  EXPECT_EQ(arrays_of<vtkXMLPolyDataReader>(session() / "membranes"), documented_arrays("membranes/*.vtp"));
  EXPECT_EQ(arrays_of<vtkXMLPolyDataReader>(session() / "surface"), documented_arrays("surface/*.vtp"));
  EXPECT_EQ(arrays_of<vtkXMLPolyDataReader>(session() / "tools"), documented_arrays("tools/*.vtp"));
}

TEST_F(FileFormat, TheArraysOfTheHandAreThoseOfThePage) {
  Names documented = documented_arrays("haptics/*.vtp");
  for (const auto& row : table_of(section("The hand"))) {
    const Names own = arrays_in("points: " + row[0]);
    documented.insert(own.begin(), own.end());
  }
  EXPECT_EQ(arrays_of<vtkXMLPolyDataReader>(session() / "haptics"), documented);
}

TEST_F(FileFormat, TheColumnsOfTheMeasurementsAreThoseOfThePage) {
  Names documented;
  for (const auto& row : table_of(section("measurements.csv"))) documented.merge(names_in(row[0]));
  const auto header = split_csv(measurement_header());
  EXPECT_EQ(Names(header.begin(), header.end()), documented);
}

TEST_F(FileFormat, TheStatesAreThoseOfThePage) {
  for (const auto& row : table_of(section("measurements.csv"))) {
    if (!names_in(row[0]).contains("state")) continue;
    EXPECT_EQ(names_in(row[2]), (Names{"no_cell", "free", "contact", "punctured", "lost"}));
    EXPECT_NE(row[2].find("empty for a frame that was recorded but not measured"), std::string::npos);
    return;
  }
  FAIL() << "no row for the state";
}

TEST_F(FileFormat, TheKindsOfEventsAreThoseOfThePage) {
  std::map<std::string, std::string> documented;
  for (const auto& row : table_of(section("events.csv"))) {
    ASSERT_EQ(row.size(), 2U);
    documented[*names_in(row[0]).begin()] = row[1];
  }
  std::map<std::string, std::string> kinds;
  for (const EventKindInfo& kind : kEventKinds) kinds[std::string(kind.name)] = ' ' + std::string(kind.meaning) + ' ';
  EXPECT_EQ(documented, kinds);
}

// A kind is written by its name in Event.h, so that the table there holds all of them.
TEST_F(FileFormat, NoKindOfEventIsMadeUpOnTheSpot) {
  static const std::regex kLiteral(
      R"re((Event\{|events?_?\.push_back\(\{|(add_)?event\(\{)[^;"]*_s[^;",]*,\s*"(\w+)")re");
  int file_count = 0;
  for (const char* part : {"modules", "app", "ui"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(PELLUCIDA_SOURCE_DIR) / part)) {
      const auto extension = entry.path().extension();
      if (extension != ".cpp" && extension != ".cxx" && extension != ".h") continue;
      ++file_count;
      const std::string text = text_of(entry.path());
      std::smatch match;
      EXPECT_FALSE(std::regex_search(text, match, kLiteral)) << entry.path() << ": " << match[0];
    }
  }
  EXPECT_GT(file_count, 200);
}

TEST_F(FileFormat, TheKeysOfTheHeadAreThoseOfThePage) {
  const auto head = nlohmann::json::parse(text_of(session() / "session.json"));
  Names written, documented;
  for (const auto& [key, value] : head.items()) written.insert(key);
  written.insert("clocks");  // of a live run alone
  std::map<std::string, Names> below;
  for (const auto& row : table_of(section("session.json"))) {
    const Names keys = names_in(row[0]);
    documented.insert(keys.begin(), keys.end());
    below[*keys.begin()] = names_in(row[1]);
  }
  EXPECT_EQ(written, documented);
  for (const char* key : {"software", "source", "profile", "counts"}) {
    Names inside;
    for (const auto& [name, value] : head.at(key).items()) inside.insert(name);
    EXPECT_EQ(inside, below[key]) << key;
  }
  for (const auto& [name, value] : head.at("calibration").items()) EXPECT_TRUE(below["calibration"].contains(name));
}

TEST_F(FileFormat, TheColumnsOfTheExportAreThoseOfThePage) {
  write_annotations(session(), {{.time_s = 0.1, .place_um = {}, .node = {}, .text = "a note"}});
  export_session(session(), session() / "export");
  write_annotations(session(), {});
  std::set<std::string> checked;
  for (const auto& row : table_of(section("Export"))) {
    for (const std::string& file : names_in(row[0])) {
      ASSERT_TRUE(fs::exists(session() / "export" / file)) << file;
      std::ifstream stream(session() / "export" / file);
      std::string header;
      std::getline(stream, header);
      // The tables of the session have sections of their own; of the hand's the page names the fixed columns.
      if (file == "measurements.csv" || file == "events.csv" || file == kAnnotationsFile) continue;
      const Names columns = names_in(row[1]);
      EXPECT_TRUE(std::any_of(columns.begin(), columns.end(),
                              [&](const std::string& named) {
                                return file == "haptics.csv" ? header.starts_with(named + ',') : header == named;
                              }))
          << file << ": " << header;
      checked.insert(file);
    }
  }
  EXPECT_EQ(checked.size(), 3U);
}

// A report's tables by their headers; the columns of both tables of the page, each in one file at least.
TEST_F(FileFormat, TheColumnsOfTheReportAreThoseOfThePage) {
  const PassportReport report = write_report(session(), session().parent_path() / "report");
  const std::string text = section("cells.csv and contacts.csv");
  Names documented, written;
  for (const auto& row : table_of(text)) documented.merge(names_in(row[0]));
  for (const char* file : {"cells.csv", "contacts.csv"}) {
    ASSERT_NE(text.find('`' + std::string(file) + '`'), std::string::npos) << file;
    std::ifstream stream(session().parent_path() / "report" / file);
    std::string header;
    std::getline(stream, header);
    for (const std::string& name : split_csv(header)) written.insert(name);
  }
  EXPECT_EQ(written, documented);
  // The needle of the default scenario touches within two seconds.
  ASSERT_EQ(report.cells.size(), 1U);
  EXPECT_GT(report.cells[0].main_contact().peak_force_uN, 0.1);
  for (const fs::path& file : report.files) {
    const std::string name = file.filename().string();
    EXPECT_NE(text_of(fs::path(PELLUCIDA_SOURCE_DIR) / "docs/file-format.md").find(name), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace pellucida
