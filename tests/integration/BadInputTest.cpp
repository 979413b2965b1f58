#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "support/RunProgram.h"

// Bad input: one clear line on stderr, and the right exit code.

namespace pellucida {
namespace {

namespace fs = std::filesystem;

class BadInput : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = test::fresh_folder(std::string("bad_input_") + info->name(), testing::TempDir());
  }

  // Runs and expects the exit code, exactly one line, and each of the words in it.
  void expect(const std::string& arguments, int exit_code, const std::vector<std::string>& words) {
    const auto outcome = test::run_program(arguments, folder_ / "run");
    EXPECT_EQ(outcome.exit_code, exit_code) << arguments << '\n' << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    for (const auto& word : words)
      EXPECT_NE(outcome.err.find(word), std::string::npos) << word << " in: " << outcome.err;
  }

  fs::path at(const std::string& name) const { return folder_ / name; }
  std::string quoted(const std::string& name) const {
    std::string text(1, '\'');
    text += at(name).string();
    text += '\'';
    return text;
  }

  fs::path folder_;
};

TEST_F(BadInput, MissingFile) {
  expect("analyze /no/such/video.avi --output " + quoted("s"), 3, {"/no/such/video.avi"});
}

TEST_F(BadInput, EmptyFile) {
  std::ofstream(at("empty.avi")).close();
  expect("analyze " + quoted("empty.avi") + " --pixel-size-um 1 --output " + quoted("s"), 3, {"empty.avi", "empty"});
}

TEST_F(BadInput, TextNamedAvi) {
  std::ofstream(at("text.avi")) << "This is not a film.\n";
  expect("analyze " + quoted("text.avi") + " --pixel-size-um 1 --output " + quoted("s"), 3, {"text.avi"});
}

TEST_F(BadInput, EmptyFolder) {
  fs::create_directories(at("images"));
  expect("analyze " + quoted("images") + " --pixel-size-um 1 --output " + quoted("s"), 3, {"images"});
}

class BadInputOnAVideo : public BadInput {
 protected:
  void SetUp() override {
    BadInput::SetUp();
    const auto outcome = test::run_program("simulate --duration-s 0.5 --output " + quoted("v.avi"), folder_ / "make");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
};

TEST_F(BadInputOnAVideo, ZeroPixelSize) {
  expect("analyze " + quoted("v.avi") + " --pixel-size-um 0 --output " + quoted("s"), 2, {"--pixel-size-um"});
  expect("analyze " + quoted("v.avi") + " --pixel-size-um -1 --output " + quoted("s"), 2, {"--pixel-size-um"});
}

TEST_F(BadInputOnAVideo, UnknownPixelSizeNamesTheOption) {
  expect("analyze " + quoted("v.avi") + " --output " + quoted("s"), 2, {"--pixel-size-um"});
}

TEST_F(BadInputOnAVideo, UnknownProfileNamesTheKnownOnes) {
  expect("analyze " + quoted("v.avi") + " --pixel-size-um 0.825 --quality best --output " + quoted("s"), 2,
         {"--quality", "live", "high"});
  expect("analyze " + quoted("v.avi") + " --pixel-size-um 0.825 --profile frog --output " + quoted("s"), 2,
         {"frog", "mouse-oocyte"});
  EXPECT_FALSE(fs::exists(at("s")));
}

TEST_F(BadInputOnAVideo, APixelSizeThatMakesTheCellTooLargeIsNamedWithItsRadius) {
  expect("analyze " + quoted("v.avi") + " --pixel-size-um 3.3 --output " + quoted("s"), 4, {"radius of", "pixel size"});
}

TEST_F(BadInputOnAVideo, UnwritableOutput) {
  expect("analyze " + quoted("v.avi") + " --pixel-size-um 0.825 --output /proc/pellucida", 5, {"/proc/pellucida"});
  std::ofstream(at("file")) << "in the way";
  expect("analyze " + quoted("v.avi") + " --pixel-size-um 0.825 --output " + quoted("file/s"), 5, {"file"});
}

TEST_F(BadInputOnAVideo, ASessionIsNeverOverwritten) {
  const std::string analyze = "analyze " + quoted("v.avi") + " --pixel-size-um 0.825 --output " + quoted("s");
  ASSERT_EQ(test::run_program(analyze, folder_ / "first").exit_code, 0);
  expect(analyze, 2, {"s"});
}

TEST_F(BadInputOnAVideo, TruncatedVideoKeepsWhatCameBefore) {
  const auto size = fs::file_size(at("v.avi"));
  fs::resize_file(at("v.avi"), size * 6 / 10);
  expect("analyze " + quoted("v.avi") + " --pixel-size-um 0.825 --output " + quoted("s"), 3, {"v.avi"});
  const std::string rows = test::text_of(at("s") / "measurements.csv");
  EXPECT_GT(std::count(rows.begin(), rows.end(), '\n'), 5);
  EXPECT_EQ(test::run_program("check " + quoted("s"), folder_ / "check").exit_code, 0);
}

TEST_F(BadInput, UnknownCommandAndUnknownScenario) {
  expect("frobnicate", 2, {"--help"});
  expect("simulate --scenario nowhere --output " + quoted("v.avi"), 2, {"nowhere", "default"});
  expect("simulate --scenario nowhere.json --output " + quoted("v.avi"), 3, {"nowhere.json", "default"});
  expect("export /no/such/session --output " + quoted("x"), 3, {"/no/such/session"});
  expect("check /no/such/session", 3, {"/no/such/session"});
}

}  // namespace
}  // namespace pellucida
