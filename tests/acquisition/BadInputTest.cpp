#include <sys/wait.h>
#include <unistd.h>

#include <cmath>

#include "TestFiles.h"

namespace pellucida {
namespace {

using namespace test;

constexpr SourceOptions kAnyScale{.pixel_size_um = 0.825, .frame_rate_hz = 30.0};

TEST(BadInput, WhatIsNotThereOrEmpty) {
  const TemporaryFolder folder;
  expect_error(ExitCode::kInputUnreadable, "nowhere.avi: no such file or folder",
               [&] { open_source(folder / "nowhere.avi", kAnyScale); });
  put(folder / "empty.avi", "");
  expect_error(ExitCode::kInputUnreadable, "empty.avi: empty file (0 bytes)",
               [&] { open_source(folder / "empty.avi", kAnyScale); });
  fs::create_directories(folder / "sub");
  expect_error(ExitCode::kInputUnreadable, "no PNG, TIFF, JPEG or BMP image in this folder",
               [&] { open_source(folder / "sub", kAnyScale); });
  expect_error(ExitCode::kInputUnreadable, "/dev/null: neither a file nor a folder",
               [&] { open_source("/dev/null", kAnyScale); });
  expect_error(ExitCode::kInputUnreadable, "no such file", [&] { open_source("", kAnyScale); });
}

TEST(BadInput, WhatIsNoVideo) {
  const TemporaryFolder folder;
  put(folder / "text.avi", "This is a text file.\nIt is called a video.\n");
  expect_error(ExitCode::kInputUnreadable, "text.avi: a text file, not a video or an image",
               [&] { open_source(folder / "text.avi", kAnyScale); });
  std::string noise(5000, '\0');
  cv::RNG random(3);
  for (char& c : noise) c = static_cast<char>(random.uniform(0, 256));
  put(folder / "noise.avi", noise);
  expect_error(ExitCode::kInputUnreadable, "noise.avi: neither a video nor an image this build can read",
               [&] { open_source(folder / "noise.avi", kAnyScale); });
  put(folder / "playlist.m3u8", "#EXTM3U\n#EXTINF:1,\n/etc/hostname\n");
  expect_error(ExitCode::kInputUnreadable, "a text file", [&] { open_source(folder / "playlist.m3u8", kAnyScale); });
}

TEST(BadInput, ContentCountsNotTheName) {
  const TemporaryFolder folder;
  cv::imwrite(folder / "a.png", picture(0));
  fs::rename(folder / "a.png", folder / "a.avi");
  EXPECT_EQ(open_source(folder / "a.avi", kAnyScale)->info().frame_rate_origin, "still");
}

TEST(BadInput, PixelsOfOtherKinds) {
  const TemporaryFolder folder;
  write_tiff(folder / "float.tif", {.bits = 32, .format = SAMPLEFORMAT_IEEEFP, .description = ""});
  write_tiff(folder / "signed.tif", {.bits = 16, .format = SAMPLEFORMAT_INT, .description = ""});
  write_tiff(folder / "wide.tif", {.count = 2, .bits = 32, .description = ""});
  expect_error(ExitCode::kInputUnreadable, "float.tif: holds 32 bit float pixels; convert it to 8 or 16 bit grey",
               [&] { open_source(folder / "float.tif", kAnyScale); });
  expect_error(ExitCode::kInputUnreadable, "signed.tif: holds 16 bit signed pixels",
               [&] { open_source(folder / "signed.tif", kAnyScale); });
  expect_error(ExitCode::kInputUnreadable, "wide.tif: holds 32 bit pixels",
               [&] { open_source(folder / "wide.tif", kAnyScale); });
}

TEST(BadInput, OptionsOutOfRange) {
  const TemporaryFolder folder;
  cv::imwrite(folder / "a.png", picture(0));
  write_video(folder / "a.avi", 3, 30.0);
  for (const char* name : {"a.png", "a.avi"}) {
    for (const auto& [value, text] :
         std::vector<std::pair<double, std::string>>{{0.0, "--pixel-size-um 0: out of range; give 0.001 to 100"},
                                                     {-1.0, "--pixel-size-um -1"},
                                                     {NAN, "--pixel-size-um nan"},
                                                     {INFINITY, "--pixel-size-um inf"},
                                                     {1e6, "--pixel-size-um 1000000: out of range"}}) {
      expect_error(ExitCode::kWrongUsage, text,
                   [&, v = value] { open_source(folder / name, {.pixel_size_um = v, .frame_rate_hz = {}}); });
    }
    expect_error(ExitCode::kWrongUsage, "--fps 0: out of range; give 0.001 to 100000 frames a second",
                 [&] { open_source(folder / name, {.pixel_size_um = 1.0, .frame_rate_hz = 0.0}); });
  }
}

TEST(BadInput, MissingScaleNamesTheOption) {
  const TemporaryFolder folder;
  cv::imwrite(folder / "1.png", picture(0));
  cv::imwrite(folder / "2.png", picture(0));
  write_video(folder / "sub.avi", 3, 30.0);
  expect_error(ExitCode::kWrongUsage, "1.png: pixel size unknown; give --pixel-size-um",
               [&] { open_source(folder / "1.png", {}); });
  expect_error(ExitCode::kWrongUsage, "sub.avi: pixel size unknown; give --pixel-size-um",
               [&] { open_source(folder / "sub.avi", {}); });
  expect_error(ExitCode::kWrongUsage, ": frame rate unknown; give --fps",
               [&] { open_source(folder / "", {.pixel_size_um = 1.0, .frame_rate_hz = {}}); });
  EXPECT_NO_THROW(open_source(folder / "1.png", {.pixel_size_um = 1.0, .frame_rate_hz = {}}));
}

TEST(BadInput, InputIsLookedAtBeforeTheOptions) {
  const TemporaryFolder folder;
  constexpr SourceOptions kBad{.pixel_size_um = 0.0, .frame_rate_hz = {}};
  expect_error(ExitCode::kInputUnreadable, "no such file", [&] { open_source(folder / "nowhere", kBad); });
  put(folder / "text.avi", "text");
  expect_error(ExitCode::kInputUnreadable, "a text file", [&] { open_source(folder / "text.avi", kBad); });
  cv::imwrite(folder / "a.png", picture(0));
  cut(folder / "a.png", 0.5);
  expect_error(ExitCode::kInputUnreadable, "broken image", [&] { open_source(folder / "a.png", kBad); });
}

TEST(BadInput, ImagesCutAnywhereAreOneLineEach) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "b.jpg", "c.bmp", "d.tif"}) {
    cv::imwrite(folder / name, picture(0, 128, 96));
    const std::string whole = text_of(folder / name);
    for (int i = 1; i < 20; ++i) {
      put(folder / name, whole.substr(0, whole.size() * static_cast<std::size_t>(i) / 20));
      expect_error(ExitCode::kInputUnreadable, name, [&] { open_source(folder / name, kAnyScale); });
    }
  }
}

// Whatever a bit flips to, a picture is read or refused: never a crash.
TEST(BadInput, FlippedBitsNeverCrash) {
  const TemporaryFolder folder;
  cv::RNG random(5);
  for (const char* name : {"a.png", "b.jpg", "c.bmp", "d.tif"}) {
    cv::imwrite(folder / name, picture(0));
    const std::string whole = text_of(folder / name);
    for (int i = 0; i < 150; ++i) {
      std::string bytes = whole;
      for (int k = 0; k < 3; ++k) {
        bytes[static_cast<std::size_t>(random.uniform(0, static_cast<int>(bytes.size())))] ^=
            static_cast<char>(1 << random.uniform(0, 8));
      }
      put(folder / name, bytes);
      try {
        const auto source = open_source(folder / name, kAnyScale);
        source->next();
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::kInputUnreadable) << error.what();
      }
    }
  }
}

// A head of a BMP of 1,080 bytes that says `compression`; ITK would decode run lengths beyond the pixels.
std::string bitmap(std::uint32_t width_px, std::uint32_t height_px, std::uint32_t compression) {
  std::string bytes(1080, '\0');
  const auto set = [&](std::size_t at, std::uint32_t value, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) bytes[at + i] = static_cast<char>(value >> (8 * i));
  };
  bytes[0] = 'B';
  bytes[1] = 'M';
  set(2, 1080, 4);
  set(10, 1078, 4);
  set(14, 40, 4);
  set(18, width_px, 4);
  set(22, height_px, 4);
  set(26, 1, 2);
  set(28, 8, 2);
  set(30, compression, 4);
  return bytes;
}

TEST(BadInput, ABitmapWithRunLengthsIsRefused) {
  const TemporaryFolder folder;
  for (const std::uint32_t compression : {1U, 2U, 4U, 0xFFFFFFFFU}) {
    put(folder / "a.bmp", bitmap(30000, 30000, compression));
    expect_error(ExitCode::kInputUnreadable, "a BMP with run lengths",
                 [&] { open_source(folder / "a.bmp", kAnyScale); });
  }
  put(folder / "a.bmp", bitmap(30000, 30000, 0));
  expect_error(ExitCode::kInputUnreadable, "cut off", [&] { open_source(folder / "a.bmp", kAnyScale); });
}

TEST(BadInput, AnImageTooLargeIsRefusedBeforeItIsDecoded) {
  const TemporaryFolder folder;
  SourceOptions small = kAnyScale;
  small.most_megapixels = 0.01;
  for (const char* name : {"a.png", "b.jpg", "c.bmp", "d.tif"}) {
    cv::imwrite(folder / name, picture(0, 128, 96));
    expect_error(ExitCode::kInputUnreadable, "128 x 96 px, more than 0.01 megapixels; raise --max-megapixels",
                 [&] { open_source(folder / name, small); });
    EXPECT_TRUE(open_source(folder / name, kAnyScale)->next());
  }
  write_video(folder / "e.avi", 3, 20.0);
  small.most_megapixels = 0.001;
  expect_error(ExitCode::kInputUnreadable, "64 x 48 px, more than", [&] { open_source(folder / "e.avi", small); });
  small.most_megapixels = -1.0;
  expect_error(ExitCode::kWrongUsage, "--max-megapixels must be", [&] { open_source(folder / "a.png", small); });
}

TEST(BadInput, ATiffOfManySamplesOrHugeTilesIsRefused) {
  const TemporaryFolder folder;
  const auto write = [&](std::uint32_t samples, std::uint32_t tile_px) {
    TIFF* file = TIFFOpen((folder / "a.tif").c_str(), "w");
    TIFFSetField(file, TIFFTAG_IMAGEWIDTH, 16U);
    TIFFSetField(file, TIFFTAG_IMAGELENGTH, 16U);
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, samples);
    TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    if (tile_px > 0) {
      TIFFSetField(file, TIFFTAG_TILEWIDTH, tile_px);
      TIFFSetField(file, TIFFTAG_TILELENGTH, tile_px);
      std::vector<std::uint8_t> tile(std::size_t{tile_px} * tile_px);
      TIFFWriteTile(file, tile.data(), 0, 0, 0, 0);
    } else {
      std::vector<std::uint8_t> row(std::size_t{16} * samples);
      for (std::uint32_t y = 0; y < 16; ++y) TIFFWriteScanline(file, row.data(), y, 0);
    }
    TIFFWriteDirectory(file);
    TIFFClose(file);
  };
  write(4000, 0);
  expect_error(ExitCode::kInputUnreadable, "4000 samples a pixel", [&] { open_source(folder / "a.tif", kAnyScale); });
  write(1, 64);
  SourceOptions small = kAnyScale;
  small.most_megapixels = 0.001;
  expect_error(ExitCode::kInputUnreadable, "its tiles: 64 x 64 px, more than",
               [&] { open_source(folder / "a.tif", small); });
  EXPECT_TRUE(open_source(folder / "a.tif", kAnyScale)->next());
}

// Left out, it would shift the times of the images behind it.
TEST(BadInput, AnEmptyImageOfAFolderIsNamedInItsTurn) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "f");
  for (int i = 0; i < 3; ++i) cv::imwrite((folder / "f").string() + "/" + std::to_string(i) + ".png", picture(i));
  put(folder / "f" / "1.png", "");
  put(folder / "f" / "notes.txt", "");
  const auto source = open_source(folder / "f", kAnyScale);
  EXPECT_EQ(source->info().frame_count, 3);
  EXPECT_TRUE(source->next());
  expect_error(ExitCode::kInputUnreadable, "1.png: empty file (0 bytes)", [&] { source->next(); });
}

TEST(BadInput, CamerasThatAreNotThere) {
  expect_error(ExitCode::kDeviceMissing, "v4l2:97: /dev/video97 can't be opened (No such file or directory); ",
               [] { open_source("v4l2:97", kAnyScale); });
  expect_error(ExitCode::kWrongUsage, "\"front\" is no camera number; give v4l2:0",
               [] { open_source("v4l2:front", kAnyScale); });
  expect_error(ExitCode::kDeviceMissing, "this build has no gstreamer source",
               [] { open_source("gstreamer:videotestsrc", kAnyScale); });
  expect_error(ExitCode::kDeviceMissing, "this build has no genicam source",
               [] { open_source("genicam:1", kAnyScale); });
}

// Each pass of a progressive JPEG takes the time of a picture and a few bytes.
TEST(BadInput, AJpegOfEndlessPassesIsRefused) {
  const TemporaryFolder folder;
  cv::imwrite(folder / "a.jpg", picture(0), {cv::IMWRITE_JPEG_PROGRESSIVE, 1});
  const std::string whole = text_of(folder / "a.jpg");
  const std::size_t last = whole.rfind("\xFF\xDA"), end = whole.rfind("\xFF\xD9");
  ASSERT_TRUE(last != std::string::npos && end != std::string::npos && last < end);
  std::string endless = whole.substr(0, end);
  for (int i = 0; i < 200; ++i) endless += whole.substr(last, end - last);
  put(folder / "b.jpg", endless + whole.substr(end));
  EXPECT_TRUE(open_source(folder / "a.jpg", kAnyScale)->next());
  expect_error(ExitCode::kInputUnreadable, "broken image", [&] {
    const auto source = open_source(folder / "b.jpg", kAnyScale);
    while (source->next()) {
    }
  });
}

// The exception's line is the only one: the libraries below say nothing of their own.
TEST(BadInput, LibrariesKeepSilent) {
  const TemporaryFolder folder;
  write_video(folder / "a.mp4", 30, 30.0, "mp4v");
  cut(folder / "a.mp4", 0.5);
  write_video(folder / "b.avi", 30, 30.0);
  cut(folder / "b.avi", 0.5);
  put(folder / "c.avi", std::string(3000, '\1'));
  cv::imwrite(folder / "d.jpg", picture(0));
  cut(folder / "d.jpg", 0.8);
  write_tiff(folder / "e.tif", {.count = 3, .description = ""});
  cut(folder / "e.tif", 0.3);
  testing::internal::CaptureStderr();
  for (const char* name : {"a.mp4", "b.avi", "c.avi", "d.jpg", "e.tif"}) {
    try {
      const auto source = open_source(folder / name, kAnyScale);
      while (source->next()) {
      }
    } catch (const Error&) {
    }
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace pellucida
