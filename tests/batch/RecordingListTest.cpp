#include "pellucida/batch/RecordingList.h"

#include <gtest/gtest.h>

#include <map>
#include <opencv2/imgcodecs.hpp>

#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"
#include "support/Files.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

class RecordingListTest : public testing::Test {
 protected:
  fs::path at(const std::string& name) const { return folder_ / name; }
  void put(const std::string& name, const std::string& text = "text") const {
    fs::create_directories(at(name).parent_path());
    test::put(at(name), text);
  }
  void put_image(const std::string& name) const {
    fs::create_directories(at(name).parent_path());
    ASSERT_TRUE(cv::imwrite(at(name).string(), cv::Mat(8, 8, CV_8U, cv::Scalar(7))));
  }
  void put_stack(const std::string& name) const {
    const std::vector<cv::Mat> pages(3, cv::Mat(8, 8, CV_8U, cv::Scalar(7)));
    ASSERT_TRUE(cv::imwritemulti(at(name).string(), pages));
  }
  // Name to group, of all found in the inputs.
  std::map<std::string, std::string> found(const std::vector<std::string>& inputs) {
    list_ = find_recordings(inputs, at("out"));
    std::map<std::string, std::string> result;
    for (const Recording& recording : list_.recordings) result[recording.name] = recording.group;
    EXPECT_EQ(result.size(), list_.recordings.size());
    return result;
  }
  using Names = std::map<std::string, std::string>;

  TemporaryFolder folder_;
  RecordingList list_;
};

TEST_F(RecordingListTest, FindsEveryKindAndPassesOverTheRest) {
  put("rec/a.avi");
  put("rec/b.MP4");
  put("rec/notes.txt");
  put("rec/.hidden.avi");
  put("rec/day10/c.mkv");
  put("rec/day9/c.mkv");
  put("rec/day9/old session/session.json");
  put("rec/day9/old session/frames/inside.avi");
  put_image("rec/day9/sequence/1.png");
  put_image("rec/day9/sequence/2.png");
  fs::create_directories(at("rec/stacks"));
  put_stack("rec/stacks/s1.tif");
  put("rec/stacks/torn.tif", "II*");
  fs::create_directories(at("rec/empty/deeper"));
  put("rec/out/earlier.avi");
  list_ = find_recordings({at("rec").string()}, at("rec/out"));
  Names names;
  for (const Recording& recording : list_.recordings) names[recording.name] = recording.group;
  EXPECT_EQ(names, (Names{{"a", "rec"},
                          {"b", "rec"},
                          {"day9_c", "day9"},
                          {"day9_old session", "day9"},
                          {"day9_sequence", "day9"},
                          {"day10_c", "day10"},
                          {"stacks_s1", "stacks"},
                          {"stacks_torn", "stacks"}}));
  // As people count.
  EXPECT_EQ(list_.recordings[2].name, "day9_c");
  EXPECT_EQ(list_.recordings[5].name, "day10_c");
  EXPECT_TRUE(list_.notes.empty());
}

TEST_F(RecordingListTest, AFolderOfImagesAndASessionAreOneRecording) {
  put_image("seq/1.png");
  put("session/session.json");
  put("videos/a.avi");
  fs::create_directories(at("empty"));
  EXPECT_FALSE(is_batch_folder(at("seq").string()));
  EXPECT_FALSE(is_batch_folder(at("session").string()));
  EXPECT_FALSE(is_batch_folder(at("empty").string()));
  EXPECT_FALSE(is_batch_folder(at("videos/a.avi").string()));
  EXPECT_FALSE(is_batch_folder("virtual"));
  EXPECT_FALSE(is_batch_folder(at("nowhere").string()));
  EXPECT_TRUE(is_batch_folder(at("videos").string()));
  EXPECT_TRUE(is_batch_folder(folder_.path().string()));
}

TEST_F(RecordingListTest, ImagesBesideRecordingsAreLeftOutWithANote) {
  put("rec/a.avi");
  put_image("rec/overview.png");
  EXPECT_EQ(found({at("rec").string()}), (Names{{"a", "rec"}}));
  ASSERT_EQ(list_.notes.size(), 1U);
  EXPECT_NE(list_.notes[0].find("1 image beside recordings left out"), std::string::npos) << list_.notes[0];
}

TEST_F(RecordingListTest, NamesDiffer) {
  put("rec/cell.avi");
  put("rec/cell.mp4");
  put("rec/Other.avi");
  put("rec/other.avi");
  put("rec/a_b.avi");
  put("rec/a/b.avi");
  put("rec/records.avi");
  put("rec/summary.csv.avi");
  put("rec/line\nend.avi");
  EXPECT_EQ(found({at("rec").string()}), (Names{{"cell_avi", "rec"},
                                                {"cell_mp4", "rec"},
                                                {"Other_avi", "rec"},
                                                {"other_avi_2", "rec"},
                                                {"a_b_avi", "rec"},
                                                {"a_b_avi_2", "a"},
                                                {"records_avi", "rec"},
                                                {"summary.csv_avi", "rec"},
                                                {"line_end", "rec"}}));
}

TEST_F(RecordingListTest, SeveralFoldersComeBeforeTheirNames) {
  put("control/a.avi");
  put("treated/a.avi");
  put("treated/late/b.avi");
  put("single.avi");
  EXPECT_EQ(found({at("control").string() + "/", at("treated").string(), at("single.avi").string()}),
            (Names{{"control_a", "control"},
                   {"treated_a", "treated"},
                   {"treated_late_b", "treated/late"},
                   {"single", folder_.path().filename().string()}}));
}

// A missing file, or a folder that can't be read, is a row of the summary, not the end of the batch.
TEST_F(RecordingListTest, WhatIsNotThereIsARecordingAllTheSame) {
  put("a.avi");
  put("rec/b.avi");
  fs::create_symlink(at("nowhere"), at("rec/broken.avi"));
  fs::create_directory_symlink(at("rec"), at("rec/loop"));
  EXPECT_EQ(found({at("a.avi").string(), at("gone.avi").string(), "virtual:default"}).size(), 3U);
  EXPECT_EQ(found({at("rec").string()}), (Names{{"b", "rec"}, {"broken", "rec"}}));
  EXPECT_THROW(find_recordings({at("a.avi").string(), "v4l2:0"}, at("out")), UsageError);
  fs::create_directories(at("empty/below"));
  EXPECT_THROW(find_recordings({at("empty").string()}, at("out")), InputError);
}

}  // namespace
}  // namespace pellucida
