// Recordings whose data were damaged: what could not be decoded as it was recorded is marked, never passed on in
// silence, and shifts no time.
#include <random>

#include "TestFiles.h"

namespace pellucida {
namespace {

using namespace test;

const SourceOptions kOnePixelScale{.pixel_size_um = 1.0, .frame_rate_hz = {}};

// Noisy pictures, so that every byte of the file counts.
void write_noise(const std::string& file, int count, const char* codec) {
  cv::VideoWriter writer(file, cv::VideoWriter::fourcc(codec[0], codec[1], codec[2], codec[3]), 20.0, {96, 64}, true);
  ASSERT_TRUE(writer.isOpened()) << file;
  cv::RNG random(7);
  for (int i = 0; i < count; ++i) {
    cv::Mat pixels(64, 96, CV_8UC3);
    random.fill(pixels, cv::RNG::UNIFORM, 0, 256);
    writer.write(pixels);
  }
}

enum class Hit { kOverwrite, kInsert };

// Damages a video at `kRunCount` places by chance and holds each frame against the whole one of the same time.
void expect_marked(const std::string& codec, const std::string& ending, Hit hit, int byte_count) {
  constexpr int kRunCount = 12;
  const TemporaryFolder folder;
  const std::string whole = folder / ("whole" + ending);
  const std::string damaged = folder / ("damaged" + ending);
  write_noise(whole, 20, codec.c_str());
  const auto good = all_frames(*open_source(whole, kOnePixelScale));
  ASSERT_EQ(good.size(), 20U);
  for (const Frame& frame : good) EXPECT_FALSE(frame.damage.damaged) << frame.frame_index;
  const std::string content = text_of(whole);
  std::mt19937 random(3);
  int wrong_count = 0;
  for (int run = 0; run < kRunCount; ++run) {
    // Between the heads and the index, where pictures are.
    const std::size_t at = content.size() / 8 + random() % (content.size() * 3 / 4);
    std::string junk;
    for (int i = 0; i < byte_count; ++i) junk += static_cast<char>(random());
    std::string changed = content;
    changed.replace(at, hit == Hit::kInsert ? 0 : junk.size(), junk);
    put(damaged, changed);
    std::vector<Frame> frames;
    bool said = false;
    try {
      const auto source = open_source(damaged, kOnePixelScale);
      while (auto frame = source->next()) frames.push_back(*frame);
    } catch (const InputError&) {
      said = true;
    }
    long stretch = 0;
    for (const Frame& frame : frames) {
      const auto same_time = std::find_if(good.begin(), good.end(), [&](const Frame& one) {
        return one.frame_index == frame.frame_index && std::abs(one.time_s - frame.time_s) < 1e-6;
      });
      ASSERT_NE(same_time, good.end()) << frame.frame_index << " at " << frame.time_s;
      const bool wrong = !same_pixels(mat_of(frame), mat_of(*same_time));
      wrong_count += wrong ? 1 : 0;
      EXPECT_TRUE(frame.damage.damaged || !wrong || said)
          << codec << ending << ", run " << run << ": " << frame.frame_index;
      EXPECT_EQ(frame.damage.count_before, stretch);
      EXPECT_EQ(frame.damage.reason.empty(), !frame.damage.damaged);
      stretch = frame.damage.damaged ? stretch + 1 : 0;
    }
  }
  EXPECT_GT(wrong_count, kRunCount / 3) << "the damage must be some";
}

TEST(DamagedRecording, OverwrittenBytesOfAMotionJpegAreMarked) {
  expect_marked("MJPG", ".avi", Hit::kOverwrite, 200);
}

TEST(DamagedRecording, BytesInsertedIntoAMatroskaAreMarked) {
  expect_marked("MJPG", ".mkv", Hit::kInsert, 100);
  expect_marked("FFV1", ".mkv", Hit::kInsert, 100);
}

TEST(DamagedRecording, AJpegWithDamageInsideIsMarkedInItsPlace) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "f");
  for (int i = 0; i < 4; ++i) cv::imwrite(folder / ("f/" + std::to_string(i) + ".jpg"), picture(i, 64, 48));
  // A marker in the middle of the picture ends what can be decoded of it.
  std::string content = text_of(folder / "f/1.jpg");
  content.replace(content.size() * 9 / 10, 2, "\xFF\xD3");
  put(folder / "f/1.jpg", content);
  testing::internal::CaptureStderr();
  const auto source = open_source(folder / "f", {.pixel_size_um = 1.0, .frame_rate_hz = 10.0});
  const auto frames = all_frames(*source);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  ASSERT_EQ(frames.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(frames[i].damage.damaged, i == 1);
    EXPECT_EQ(frames[i].damage.count_before, i == 2 ? 1 : 0);
    EXPECT_NEAR(frames[i].time_s, 0.1 * static_cast<double>(i), 1e-9);
  }
  EXPECT_NE(frames[1].damage.reason.find("Corrupt JPEG data"), std::string::npos) << frames[1].damage.reason;
}

// Of a stack that was cut off, every page is whole, marked, or missed by name.
TEST(DamagedRecording, NoPageOfATiffIsTakenForWholeThatIsNot) {
  const TemporaryFolder folder;
  for (const auto compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS}) {
    const std::string whole = folder / "whole.tif";
    const std::string damaged = folder / "damaged.tif";
    write_tiff(whole, {.count = 4, .compression = static_cast<std::uint16_t>(compression)});
    const SourceOptions options{.pixel_size_um = 1.0, .frame_rate_hz = 10.0};
    const auto good = all_frames(*open_source(whole, options));
    ASSERT_EQ(good.size(), 4U);
    const std::string content = text_of(whole);
    for (std::size_t bytes = 8; bytes < content.size(); bytes += 61) {
      put(damaged, content.substr(0, bytes));
      bool said = false;
      std::vector<Frame> frames;
      try {
        const auto source = open_source(damaged, options);
        while (auto frame = source->next()) frames.push_back(*frame);
      } catch (const InputError&) {
        said = true;
      }
      EXPECT_TRUE(said || frames.size() == good.size()) << compression << ", " << bytes;
      for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_TRUE(frames[i].damage.damaged || same_pixels(mat_of(frames[i]), mat_of(good[i])))
            << compression << ", " << bytes << ", page " << i;
      }
    }
  }
}

}  // namespace
}  // namespace pellucida
