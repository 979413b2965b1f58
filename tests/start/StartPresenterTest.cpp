// Lists, checks and the resulting choice of the start page, without a display.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/simulation/Scenario.h"
#include "presenters/NumberField.h"
#include "presenters/PathJudgement.h"
#include "presenters/PixelMeasure.h"
#include "presenters/RecentSessions.h"
#include "presenters/StartForm.h"
#include "presenters/StartLists.h"
#include "review/TouchSession.h"
#include "support/Files.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;
using test::put;
using test::write_touch;

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

StartProblem problem_of(const StartForm& form, const std::optional<PathJudgement>& judged = {}) {
  const auto decision = decide(form, judged);
  const auto* problem = std::get_if<StartProblem>(&decision);
  EXPECT_NE(problem, nullptr) << "was accepted";
  return problem ? *problem : StartProblem{};
}

StartChoice choice_of(const StartForm& form, const std::optional<PathJudgement>& judged = {}) {
  const auto decision = decide(form, judged);
  const auto* choice = std::get_if<StartChoice>(&decision);
  EXPECT_NE(choice, nullptr) << std::get<StartProblem>(decision).text;
  return choice ? *choice : StartChoice{};
}

void write_image(const fs::path& file) {
  ASSERT_TRUE(cv::imwrite(file.string(), cv::Mat(48, 64, CV_8UC1, cv::Scalar(90))));
}

TEST(StartNumber, IsReadWithinItsRange) {
  for (const auto& [text, value] : {std::pair("0.825", 0.825), std::pair(" 0,825 ", 0.825), std::pair("0.001", 0.001),
                                    std::pair("100", 100.0), std::pair("1e-1", 0.1)}) {
    const TypedNumber number = read_number(text, kPixelSizeNumber);
    ASSERT_TRUE(number.value) << text << ": " << number.problem;
    EXPECT_DOUBLE_EQ(*number.value, value);
    EXPECT_TRUE(number.problem.empty());
  }
  EXPECT_FALSE(read_number("  ", kPixelSizeNumber).value);
  EXPECT_TRUE(read_number("", kPixelSizeNumber).problem.empty());
}

TEST(StartNumber, OutOfRangeIsSaidWithRangeAndUnit) {
  for (const char* text : {"0", "-1", "0.0009", "100.1", "1e400", "nan", "inf"}) {
    const TypedNumber number = read_number(text, kPixelSizeNumber);
    EXPECT_FALSE(number.value) << text;
    EXPECT_TRUE(holds(number.problem, "0.001 to 100 µm")) << number.problem;
  }
  EXPECT_TRUE(holds(read_number("1e6", kFrameRateNumber).problem, "0.001 to 100000 frames/s"))
      << read_number("1e6", kFrameRateNumber).problem;
  for (const char* text : {"abc", "0.8um", "1 2", "1,2,3", "0x1p3"}) {
    EXPECT_TRUE(holds(read_number(text, kPixelSizeNumber).problem, "is no number")) << text;
  }
}

TEST(StartNumber, ObjectiveAndCameraPixelGiveTheSpecimensPixel) {
  EXPECT_DOUBLE_EQ(*size_by_objective("20", "6.5").pixel_size_um, 0.325);
  EXPECT_FALSE(size_by_objective("20", "").pixel_size_um);
  EXPECT_TRUE(holds(size_by_objective("20", "600").problem, "0.5 to 50 µm"));
}

TEST(StartLists, NameWhatIsShipped) {
  const auto scenarios = scenario_entries();
  ASSERT_GE(scenarios.size(), 13U);
  EXPECT_EQ(scenarios.front().value, "injection");
  for (const auto& entry : scenarios) EXPECT_FALSE(entry.detail.empty()) << entry.value;
  EXPECT_TRUE(holds(scenarios.front().detail, "7.5 µN")) << scenarios.front().detail;
  const auto profiles = profile_entries();
  ASSERT_GE(profiles.size(), 2U);
  EXPECT_EQ(profiles.front().title, "mouse-oocyte (Mouse oocyte)");
  const auto lessons = lesson_entries();
  ASSERT_EQ(lessons.size(), 12U);
  EXPECT_EQ(lessons.front().title, "1. What a snake does");
  EXPECT_EQ(index_of(lessons, lessons[3].value), 3);
  EXPECT_EQ(index_of(lessons, "algebra"), 0);
}

TEST(StartLists, CamerasOrWhatToDoWithoutOne) {
  const TemporaryFolder folder;
  const CameraList none = camera_list(folder.path());
  EXPECT_TRUE(none.cameras.empty());
  EXPECT_TRUE(holds(none.notice, "plugged in")) << none.notice;
  EXPECT_TRUE(holds(none.notice, "Search again")) << none.notice;
  // Listed by the system, but without a device file of its own.
  fs::create_directories(folder / "video987654");
  put(folder / "video987654" / "name", "Microscope camera\n");
  EXPECT_TRUE(holds(camera_list(folder.path()).notice, "no permission to read and write /dev/video987654"));
}

TEST(StartChoices, TheVirtualMicroscopeWithItsHand) {
  StartForm form;
  form.scenario = "puncture";
  form.hand = "mouse";
  const StartChoice choice = choice_of(form);
  EXPECT_EQ(choice.mode, StartMode::kGuide);
  EXPECT_EQ(choice.source, "virtual:puncture");
  EXPECT_EQ(choice.hand, "mouse");
  EXPECT_FALSE(choice.pixel_size_um);
}

TEST(StartChoices, AStifferCellIsAKeyOfItsScenario) {
  StartForm form;
  form.stiffness = "2";
  const std::string source = choice_of(form).source;
  EXPECT_EQ(source, "virtual:injection,cell.stiffness_ratio=2");
  EXPECT_EQ(load_scenario(source.substr(8)).cell.stiffness_ratio, 2.0);
  const auto entries = stiffness_entries();
  EXPECT_EQ(entries.front().value, StartForm{}.stiffness);
  for (const auto& entry : entries) {
    EXPECT_NO_THROW(load_scenario("injection,cell.stiffness_ratio=" + entry.value)) << entry.value;
  }
}

TEST(PixelMeasure, IsTheLengthOverTheLineWithItsEndsPlaces) {
  const DrawnLine line{100.0, 50.0, 220.0, 210.0};
  EXPECT_DOUBLE_EQ(line.length_px(), 200.0);
  const PixelMeasure measure = measure_pixel(line, "165");
  EXPECT_DOUBLE_EQ(measure.pixel_size_um, 0.825);
  EXPECT_NEAR(measure.uncertainty_um, 0.825 * std::sqrt(2.0) / 200.0, 1e-12);
  EXPECT_EQ(measure.typed, "0.8250");
  EXPECT_EQ(measure.text, "0.8250 ± 0.0058 µm per px");
  EXPECT_EQ(*read_number(measure.typed, kPixelSizeNumber).value, 0.825);
  for (const char* length : {"", "long", "0", "-3"}) {
    EXPECT_EQ(measure_pixel(line, length).pixel_size_um, 0.0) << length;
    EXPECT_FALSE(measure_pixel(line, length).text.empty()) << length;
  }
  EXPECT_TRUE(holds(measure_pixel({0, 0, 10, 0}, "100").text, "at least 20 px"));
  EXPECT_TRUE(holds(measure_pixel({0, 0, 30, 0}, "99999").text, "no microscope"));
}

TEST(StartChoices, ARecordingNeedsAPathAndItsNumbers) {
  StartForm form;
  form.card = StartCardId::kRecording;
  EXPECT_EQ(problem_of(form).field, StartField::kPath);
  PathJudgement judged;
  judged.kind = PathKind::kRecording;
  judged.path = form.path = "/films/a.avi";
  judged.frame_rate_hz = 25.0;
  // Its file states no pixel size.
  EXPECT_EQ(problem_of(form, judged).field, StartField::kRecordingPixel);
  EXPECT_TRUE(holds(problem_of(form, judged).text, "µm"));
  form.recording_pixel_um = "0";
  EXPECT_EQ(problem_of(form, judged).field, StartField::kRecordingPixel);
  form.recording_pixel_um = "0.5";
  form.frame_rate_hz = "fast";
  EXPECT_EQ(problem_of(form, judged).field, StartField::kFrameRate);
  form.frame_rate_hz = "";
  form.recording_profile = "mouse-embryo";
  const StartChoice choice = choice_of(form, judged);
  EXPECT_EQ(choice.source, "/films/a.avi");
  EXPECT_EQ(choice.profile, "mouse-embryo");
  EXPECT_EQ(choice.pixel_size_um, 0.5);
  EXPECT_FALSE(choice.frame_rate_hz);
  EXPECT_TRUE(choice.hand.empty());
  judged.frame_rate_hz.reset();
  EXPECT_EQ(problem_of(form, judged).field, StartField::kFrameRate);
  judged.kind = PathKind::kNeither;
  judged.problem = "a table";
  EXPECT_EQ(problem_of(form, judged).text, "a table");
}

TEST(StartChoices, ACameraNeedsAPixelSizeTypedOrByTheObjective) {
  StartForm form;
  form.card = StartCardId::kCamera;
  EXPECT_EQ(problem_of(form).field, StartField::kCamera);
  form.camera = "v4l2:2";
  EXPECT_EQ(problem_of(form).field, StartField::kSpecimenPixel);
  form.specimen_pixel_um = "0.7";
  EXPECT_EQ(choice_of(form).pixel_size_um, 0.7);
  EXPECT_EQ(choice_of(form).source, "v4l2:2");
  form.objective = "40";
  EXPECT_EQ(problem_of(form).field, StartField::kCameraPixel);
  form.camera_pixel_um = "8";
  EXPECT_EQ(choice_of(form).pixel_size_um, 0.2);
}

TEST(StartChoices, ALessonWithItsLook) {
  StartForm form;
  form.card = StartCardId::kLesson;
  form.lesson = "volume";
  form.large_letters = true;
  const StartChoice choice = choice_of(form);
  EXPECT_EQ(choice.mode, StartMode::kTeach);
  EXPECT_EQ(choice.lesson, "volume");
  EXPECT_TRUE(choice.large_letters);
}

TEST(StartWords, OptionsBecomeFieldsAndAnotherSizeInTheFileIsSaid) {
  EXPECT_EQ(in_words_of_page("a.avi: give --fps or --pixel-size-um"), "a.avi: give the frame rate or the pixel size");
  PathJudgement judged;
  judged.caption = "64 × 48 px";
  judged.pixel_size_um = 0.65;
  EXPECT_EQ(recording_note(judged, "0.65"), judged.caption);
  EXPECT_EQ(recording_note(judged, ""), judged.caption);
  EXPECT_TRUE(holds(recording_note(judged, "0.825"), "states 0.65 µm")) << recording_note(judged, "0.825");
}

TEST(PathJudgement, TellsSessionsRecordingsAndOthers) {
  const TemporaryFolder folder;
  write_touch(folder / "S");
  EXPECT_EQ(judge_path(folder / "S").kind, PathKind::kSession);
  const PathJudgement file_of_session = judge_path(folder / "S" / "measurements.csv");
  EXPECT_EQ(file_of_session.kind, PathKind::kSession);
  EXPECT_EQ(file_of_session.path, folder / "S");

  fs::create_directories(folder / "images");
  for (const char* name : {"f1.png", "f2.png"}) write_image(folder / "images" / name);
  const PathJudgement images = judge_path(folder / "images");
  EXPECT_EQ(images.kind, PathKind::kRecording) << images.problem;
  EXPECT_FALSE(images.pixel_size_um);
  EXPECT_TRUE(holds(images.caption, "64 × 48 px")) << images.caption;
  EXPECT_TRUE(holds(images.caption, "pixel size not in the file")) << images.caption;

  fs::create_directories(folder / "empty");
  put(folder / "table.csv", "a,b\n1,2\n");
  for (const fs::path& path : {folder / "empty", folder / "table.csv", folder / "missing"}) {
    const PathJudgement other = judge_path(path);
    EXPECT_EQ(other.kind, PathKind::kNeither) << path;
    EXPECT_TRUE(holds(other.problem, path.filename().string())) << other.problem;
    EXPECT_TRUE(holds(other.problem, "give a video, a folder of images, or the folder of a session")) << other.problem;
  }
}

TEST(RecentSessions, AreTheNewestFoldersThatHoldASession) {
  const TemporaryFolder folder;
  const auto now = fs::file_time_type::clock::now();
  write_touch(folder / "S0");
  for (int k = 0; k < 8; ++k) {
    std::string name = "S";
    name += std::to_string(k);
    if (k > 0) fs::copy(folder / "S0", folder / name, fs::copy_options::recursive);
    fs::last_write_time(folder / name / "session.json", now - std::chrono::hours(k == 3 ? 0 : 8 - k));
  }
  fs::create_directories(folder / "no session");
  const auto newest = newest_sessions(folder.path(), 6);
  ASSERT_EQ(newest.size(), 6U);
  EXPECT_EQ(newest[0].filename(), "S3");
  EXPECT_EQ(newest[1].filename(), "S7");
  EXPECT_EQ(newest[5].filename(), "S2");
  EXPECT_TRUE(newest_sessions(folder / "missing", 6).empty());

  const RecentSession session = recent_session(SessionReader(newest[0]));
  EXPECT_EQ(session.duration, "2.90 s");
  EXPECT_TRUE(session.date.ends_with("UTC")) << session.date;
  EXPECT_TRUE(picture_in(newest[0]).empty());
  write_image(newest[0] / "picture.png");
  EXPECT_EQ(picture_in(newest[0]), newest[0] / "picture.png");
}

}  // namespace
}  // namespace pellucida
