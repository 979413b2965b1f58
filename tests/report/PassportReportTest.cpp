#include "pellucida/report/PassportReport.h"

#include <gtest/gtest.h>

#include <map>

#include "RecordedSession.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/session/SessionCheck.h"
#include "support/Files.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

class Report : public testing::Test {
 protected:
  Report() {
    test::SyntheticRows rows;
    rows.approach(5);
    rows.push(0.5, 8.0, test::linear);
    rows.push(7.5, 0.5, test::linear);
    rows.approach(3);
    test::write_session(session(), rows);
  }
  fs::path session() const { return folder_ / "s"; }

  // Every file of the session but those of a report, with its content.
  std::map<std::string, std::string> session_files() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(session())) {
      const std::string name = entry.path().lexically_relative(session()).string();
      if (entry.is_regular_file() && !name.starts_with("report/")) files[name] = test::text_of(entry.path());
    }
    return files;
  }

  TemporaryFolder folder_;
};

TEST_F(Report, WithoutAFolderItGoesIntoTheSessionAndDisturbsNothing) {
  const auto before = session_files();
  const PassportReport report = write_report(session(), "");
  EXPECT_EQ(report.cells.size(), 1U);
  EXPECT_TRUE(report.notes.empty());
  ASSERT_EQ(report.files.size(), 3U);
  for (const char* name : {"report.html", "cells.csv", "contacts.csv"}) {
    EXPECT_GT(fs::file_size(session() / "report" / name), 100U) << name;
  }
  EXPECT_EQ(session_files(), before);
  const SessionReport check = check_session(session(), false);
  EXPECT_TRUE(check.fine() && check.notes.empty());
  // Again: the same text in the place of the older one.
  const std::string page = test::text_of(session() / "report/report.html");
  write_report(session(), "");
  EXPECT_EQ(test::text_of(session() / "report/report.html"), page);
}

TEST_F(Report, AFolderOrAPageOfItsOwn) {
  const auto before = session_files();
  write_report(session(), folder_ / "out/there");
  EXPECT_TRUE(fs::exists(folder_ / "out/there/cells.csv"));
  write_report(session(), folder_ / "pages/dish.html");
  for (const char* name : {"dish.html", "dish_cells.csv", "dish_contacts.csv"}) {
    EXPECT_TRUE(fs::exists(folder_ / "pages" / name)) << name;
  }
  EXPECT_FALSE(fs::exists(session() / "report"));
  EXPECT_EQ(session_files(), before);
}

TEST_F(Report, TheSessionIsNeverWrittenInto) {
  const auto before = session_files();
  EXPECT_THROW(write_report(session(), session()), UsageError);
  EXPECT_THROW(write_report(session(), session() / "surface"), UsageError);
  EXPECT_THROW(write_report(session(), session() / "page.html"), UsageError);
  fs::create_directory(folder_ / "o");
  fs::create_hard_link(session() / "measurements.csv", folder_ / "o/cells.csv");
  EXPECT_THROW(write_report(session(), folder_ / "o"), UsageError);
  // A session from a stranger: a link out of it is not followed.
  fs::create_directory(folder_ / "elsewhere");
  fs::create_directory_symlink(folder_ / "elsewhere", session() / "report");
  EXPECT_THROW(write_report(session(), ""), UsageError);
  EXPECT_TRUE(fs::is_empty(folder_ / "elsewhere"));
  fs::remove(session() / "report");
  EXPECT_EQ(session_files(), before);
}

TEST_F(Report, BadInputAndOutputAreNamed) {
  EXPECT_THROW(write_report(folder_ / "nothing", ""), InputError);
  test::put(folder_ / "file", "x");
  EXPECT_THROW(write_report(session(), folder_ / "file"), OutputError);
  test::put(session() / "session.json", "{");
  EXPECT_THROW(write_report(session(), ""), InputError);
}

TEST_F(Report, DamageIsANoteAndTheRestIsReported) {
  fs::path surface;
  for (const auto& entry : fs::directory_iterator(session() / "surface")) surface = std::max(surface, entry.path());
  fs::resize_file(surface, fs::file_size(surface) / 2);
  const PassportReport report = write_report(session(), folder_ / "out");
  ASSERT_EQ(report.notes.size(), 1U);
  EXPECT_NE(report.notes[0].find("1 surface(s) can't be read"), std::string::npos) << report.notes[0];
  EXPECT_NEAR(report.cells.at(0).main_contact().largest_area_strain_percent, 4.04, 1e-3);
  EXPECT_NE(test::text_of(folder_ / "out/report.html").find("1 surface(s) can&#39;t be read"), std::string::npos);
}

}  // namespace
}  // namespace pellucida
