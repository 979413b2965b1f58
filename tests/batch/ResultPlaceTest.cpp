#include "ResultPlace.h"

#include <gtest/gtest.h>

#include "pellucida/core/TemporaryFolder.h"
#include "support/Files.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

class ResultPlaceTest : public testing::Test {
 protected:
  // What a program would have left in the place.
  static void work(const ResultPlace& place, const std::string& text) {
    fs::create_directories(place.work());
    test::put(place.work() / "session.json", text);
  }
  static RecordingRecord record(const std::string& session) {
    RecordingRecord record;
    record.session_sha256 = session;
    return record;
  }
  fs::path output() const { return folder_.path(); }
  std::string result() const { return test::text_of(output() / "cell/session.json"); }

  TemporaryFolder folder_;
};

TEST_F(ResultPlaceTest, AResultAppearsWholeAndReplacesAnOlderOne) {
  for (const char* text : {"one", "two"}) {
    {
      ResultPlace place(output(), "cell");
      ASSERT_TRUE(place.is_ours());
      work(place, text);
      EXPECT_NE(result(), text);
      place.publish(record(text));
    }
    EXPECT_EQ(result(), text);
    EXPECT_EQ(read_record(record_file(output(), "cell"))->session_sha256, text);
    EXPECT_TRUE(fs::is_empty(output() / ".unfinished"));
  }
}

TEST_F(ResultPlaceTest, AFailureLeavesTheOlderResult) {
  {
    ResultPlace place(output(), "cell");
    work(place, "one");
    place.publish(record("one"));
  }
  ResultPlace(output(), "cell").publish(record(""));
  EXPECT_EQ(result(), "one");
  EXPECT_EQ(read_record(record_file(output(), "cell"))->session_sha256, "one");
  ResultPlace(output(), "other").publish(record(""));
  EXPECT_TRUE(read_record(record_file(output(), "other")));
  EXPECT_FALSE(fs::exists(output() / "other"));
}

TEST_F(ResultPlaceTest, OneAtATimeAndLeftoversAreGone) {
  fs::create_directories(output() / ".unfinished/cell/session/frames");
  test::put(output() / ".unfinished/cell/session/measurements.csv", "torn");
  ResultPlace place(output(), "cell");
  ASSERT_TRUE(place.is_ours());
  EXPECT_FALSE(fs::exists(place.work()));
  work(place, "mine");
  {
    const ResultPlace second(output(), "cell");
    EXPECT_FALSE(second.is_ours());
  }
  EXPECT_EQ(test::text_of(place.work() / "session.json"), "mine");
  EXPECT_TRUE(ResultPlace(output(), "other").is_ours());
}

}  // namespace
}  // namespace pellucida
