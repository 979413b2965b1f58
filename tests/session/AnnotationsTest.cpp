// Notes about a session: kept as they were written, refused with the line where they can't be read, exported.
#include "pellucida/session/Annotations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "TestSession.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/session/SessionExport.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

class Annotations : public testing::Test {
 protected:
  std::string fault_of(const std::string& content) const {
    std::ofstream(folder_ / kAnnotationsFile) << content;
    try {
      read_annotations(folder_.path());
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  TemporaryFolder folder_;
};

TEST_F(Annotations, AreReadAsTheyWereWritten) {
  EXPECT_TRUE(read_annotations(folder_.path()).empty());
  const std::vector<Annotation> written{
      {.time_s = 2.5, .place_um = Annotation::Place{12.25, -3.5}, .node = {}, .text = "A speck, \"dark\""},
      {.time_s = 0.5, .place_um = {}, .node = 17, .text = "Zona dünn µ"},
      {.time_s = 1.0, .place_um = {}, .node = {}, .text = "two\nlines"}};
  write_annotations(folder_.path(), written);
  const auto read = read_annotations(folder_.path());
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read[0].time_s, 0.5);
  EXPECT_EQ(read[0].node, 17);
  EXPECT_FALSE(read[0].place_um);
  EXPECT_EQ(read[0].text, "Zona dünn µ");
  EXPECT_EQ(read[1].text, "two lines");
  EXPECT_EQ(read[2].text, "A speck, \"dark\"");
  ASSERT_TRUE(read[2].place_um);
  EXPECT_EQ(read[2].place_um->x_um, 12.25);
  EXPECT_EQ(read[2].place_um->y_um, -3.5);
  // Without any the file goes.
  write_annotations(folder_.path(), {});
  EXPECT_FALSE(fs::exists(folder_ / kAnnotationsFile));
}

TEST_F(Annotations, WhatCannotBeReadIsNamedWithItsLine) {
  const std::string head = "time_s,x_um,y_um,node,text\n";
  EXPECT_EQ(fault_of(head + "1,,,,fine\n\n"), "");
  EXPECT_NE(fault_of("time,text\n").find("line 1"), std::string::npos);
  EXPECT_NE(fault_of(head + "1,,,,fine\nsoon,,,,not\n").find("line 3: \"soon\""), std::string::npos);
  EXPECT_NE(fault_of(head + "1,2,3\n").find("3 cells in place of 5"), std::string::npos);
  EXPECT_NE(fault_of(head + ",,,,when?\n").find("no time"), std::string::npos);
  EXPECT_NE(fault_of(head + "1,,,1.5,node\n").find("no number"), std::string::npos);
  EXPECT_NE(fault_of(head + "inf,,,,late\n").find("no number"), std::string::npos);
}

TEST_F(Annotations, GoIntoTheExport) {
  test::write_session(folder_ / "s", 5);
  EXPECT_FALSE(fs::exists(folder_ / "x" / kAnnotationsFile));
  write_annotations(folder_ / "s", {Annotation{.time_s = 1.0, .place_um = {}, .node = 3, .text = "thin here"}});
  const ExportReport report = export_session(folder_ / "s", folder_ / "x");
  EXPECT_EQ(std::count(report.files.begin(), report.files.end(), folder_ / "x" / kAnnotationsFile), 1);
  ASSERT_EQ(read_annotations(folder_ / "x").size(), 1u);
  EXPECT_EQ(read_annotations(folder_ / "x")[0].text, "thin here");
  // An unreadable file is said, and all else exported.
  std::ofstream(folder_ / "s" / kAnnotationsFile) << "gibberish\n";
  const ExportReport torn = export_session(folder_ / "s", folder_ / "y");
  EXPECT_TRUE(test::mentions(torn.notes, "file of annotations left out"));
  EXPECT_TRUE(fs::exists(folder_ / "y" / "events.csv"));
}

TEST_F(Annotations, AFolderThatIsGoneIsAnError) {
  EXPECT_THROW(
      write_annotations(folder_ / "none", {Annotation{.time_s = 1.0, .place_um = {}, .node = {}, .text = "a"}}),
      OutputError);
}

}  // namespace
}  // namespace pellucida
