#include "presenters/RecordingPresenter.h"

#include <gtest/gtest.h>

#include <regex>

namespace pellucida {
namespace {

TEST(RecordingPresenter, WithoutAWishEachRecordingGetsItsOwnFolder) {
  RecordingPresenter recordings({}, "/users/one");
  EXPECT_EQ(recordings.next_folder("2026-11-20T20-15-00Z"), "/users/one/Pellucida/2026-11-20T20-15-00Z");
  EXPECT_EQ(recordings.next_folder("2026-11-20T20-16-00Z"), "/users/one/Pellucida/2026-11-20T20-16-00Z");
}

TEST(RecordingPresenter, TheFolderAskedForIsUsedOnceThenNumbered) {
  RecordingPresenter recordings("/data/cell", "/users/one");
  EXPECT_EQ(recordings.next_folder("x"), "/data/cell");
  EXPECT_EQ(recordings.next_folder("x"), "/data/cell-2");
  EXPECT_EQ(recordings.next_folder("x"), "/data/cell-3");
}

TEST(RecordingPresenter, StampsMakeFileNames) {
  EXPECT_TRUE(std::regex_match(RecordingPresenter::utc_stamp(), std::regex(R"(\d{4}-\d\d-\d\dT\d\d-\d\d-\d\dZ)")));
  EXPECT_EQ(RecordingPresenter({}, "/users/one").picture_file("S"), "/users/one/Pellucida/picture-S.png");
}

}  // namespace
}  // namespace pellucida
