#include "pellucida/batch/RecordingRecord.h"

#include <gtest/gtest.h>

#include "TestSessions.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/session/Sha256.h"
#include "support/Files.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

RecordingRecord example() {
  RecordingRecord record;
  record.input = {"/data/a.avi", 12, 34, "abc"};
  record.recipe = {{"--pixel-size-um=0.5", "--no-frames"}, "def", "0.1.0"};
  record.exit_code = 3;
  record.error = "a.avi: broken off after frame 12; \"quoted\"";
  record.wall_time_s = 1.25;
  record.session_sha256 = "123";
  return record;
}

TEST(RecordingRecord, ReadsBackAsWritten) {
  const TemporaryFolder folder;
  const RecordingRecord record = example();
  write_record(folder / "r.json", record);
  const auto read = read_record(folder / "r.json");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->input.path, record.input.path);
  EXPECT_EQ(read->input.byte_count, record.input.byte_count);
  EXPECT_EQ(read->input.modified_ns, record.input.modified_ns);
  EXPECT_EQ(read->input.sha256, record.input.sha256);
  EXPECT_EQ(read->recipe, record.recipe);
  EXPECT_EQ(read->exit_code, record.exit_code);
  EXPECT_EQ(read->error, record.error);
  EXPECT_EQ(read->wall_time_s, record.wall_time_s);
  EXPECT_EQ(read->session_sha256, record.session_sha256);
}

TEST(RecordingRecord, WhatIsNoRecordIsNone) {
  const TemporaryFolder folder;
  EXPECT_FALSE(read_record(folder / "nowhere.json"));
  write_record(folder / "r.json", example());
  const std::string whole = test::text_of(folder / "r.json");
  std::string later = whole;
  later.replace(later.find("\"record_version\": 1"), 19, "\"record_version\": 2");
  for (const std::string& text : {std::string(), std::string("[]"), std::string("{\"record_version\": 1}"),
                                  whole.substr(0, whole.size() / 2), later}) {
    test::put(folder / "r.json", text);
    EXPECT_FALSE(read_record(folder / "r.json")) << text;
  }
}

TEST(RecordingRecord, ContentDecidesWhereTheStampDoesNot) {
  const TemporaryFolder folder;
  test::put(folder / "a.avi", "one");
  InputStamp then = stamp_of((folder / "a.avi").string());
  EXPECT_EQ(then.byte_count, 3U);
  EXPECT_TRUE(same_content(then, stamp_of((folder / "a.avi").string())));

  // Touched, or moved: the same only where the content is known.
  fs::rename(folder / "a.avi", folder / "b.avi");
  fs::last_write_time(folder / "b.avi", fs::file_time_type::clock::now() + std::chrono::hours(1));
  const InputStamp moved = stamp_of((folder / "b.avi").string());
  EXPECT_FALSE(same_content(then, moved));
  then.sha256 = sha256_of("one");
  EXPECT_TRUE(same_content(then, moved));
  test::put(folder / "b.avi", "two");
  EXPECT_FALSE(same_content(then, stamp_of((folder / "b.avi").string())));
  test::put(folder / "b.avi", "longer");
  EXPECT_FALSE(same_content(then, stamp_of((folder / "b.avi").string())));
  EXPECT_EQ(stamp_of((folder / "gone.avi").string()).byte_count, 0U);
}

TEST(RecordingRecord, AFolderIsAllItsFiles) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "s");
  test::put(folder / "s" / "1.png", "one");
  test::put(folder / "s" / "2.png", "two");
  const InputStamp then = stamp_of((folder / "s").string());
  EXPECT_EQ(then.byte_count, 6U);
  test::put(folder / "s" / "3.png", "three");
  EXPECT_FALSE(same_content(then, stamp_of((folder / "s").string())));
}

TEST(RecordingRecord, OnlyItsOwnClosedSessionIsTheResult) {
  const TemporaryFolder folder;
  test::write_session(folder / "s", {1.0, 2.0});
  RecordingRecord record;
  EXPECT_FALSE(holds_result(folder / "s", record));
  record.session_sha256 = sha256_of_file(folder / "s" / "session.json");
  EXPECT_TRUE(holds_result(folder / "s", record));
  EXPECT_FALSE(holds_result(folder / "nowhere", record));
  std::string head = test::text_of(folder / "s" / "session.json");
  head.replace(head.find("\"complete\": true"), 16, "\"complete\": false");
  test::put(folder / "s" / "session.json", head);
  EXPECT_FALSE(holds_result(folder / "s", record));
}

}  // namespace
}  // namespace pellucida
