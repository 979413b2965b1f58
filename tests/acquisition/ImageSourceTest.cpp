#include "ImageSequenceSource.h"
#include "TestFiles.h"
#include "pellucida/acquisition/FolderContent.h"

namespace pellucida {
namespace {

using namespace test;

constexpr SourceOptions kScale{.pixel_size_um = 0.5, .frame_rate_hz = 20.0};

TEST(NaturalOrder, CountsAsPeopleDo) {
  EXPECT_TRUE(natural_less("frame9.png", "frame10.png"));
  EXPECT_FALSE(natural_less("frame10.png", "frame9.png"));
  EXPECT_TRUE(natural_less("a2b10", "a2b9999999999999999999999"));
  EXPECT_TRUE(natural_less("img1", "img01"));
  EXPECT_FALSE(natural_less("img01", "img1"));
  EXPECT_TRUE(natural_less("img", "img0"));
  EXPECT_TRUE(natural_less("a10", "b1"));
  EXPECT_FALSE(natural_less("same7", "same7"));
}

// Whatever is in it, the order is an order: no two names each before the other, and equal only to itself.
TEST(NaturalOrder, IsAStrictOrder) {
  const std::vector<std::string> names{"",    "0",  "00",    "1",     "01",   "10", "a",  "a0",
                                       "a00", "a1", "a01b2", "a1b02", "a1b2", "b",  "a1b"};
  for (const auto& left : names) {
    for (const auto& right : names) {
      if (left == right) {
        EXPECT_FALSE(natural_less(left, right)) << left;
      } else {
        EXPECT_NE(natural_less(left, right), natural_less(right, left)) << left << " / " << right;
      }
      for (const auto& third : names) {
        if (natural_less(left, right) && natural_less(right, third)) {
          EXPECT_TRUE(natural_less(left, third));
        }
      }
    }
  }
}

TEST(Still, EachKindKeepsItsPixels) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "b.tif", "c.bmp"}) {
    cv::imwrite(folder / name, picture(1));
    const auto source = open_source(folder / name, {.pixel_size_um = 0.5, .frame_rate_hz = {}});
    EXPECT_EQ(source->info().frame_rate_origin, "still") << name;
    EXPECT_EQ(source->info().frame_rate_hz, 1.0) << name;
    EXPECT_EQ(source->info().pixel_size_origin, "option") << name;
    EXPECT_EQ(source->info().frame_count, 1) << name;
    const auto frames = all_frames(*source);
    ASSERT_EQ(frames.size(), 1U) << name;
    EXPECT_TRUE(same_pixels(mat_of(frames[0]), picture(1))) << name;
    EXPECT_EQ(frames[0].time_s, 0.0);
    EXPECT_EQ(view_of(frames[0].image.get()).pixel_size_um, 0.5);
    EXPECT_EQ(stamped_frame_index(frames[0].image.get()), 0);
  }
}

TEST(Still, JpegIsCloseToItsPixels) {
  const TemporaryFolder folder;
  cv::imwrite(folder / "a.jpg", picture(2));
  const auto frames = all_frames(*open_source(folder / "a.jpg", kScale));
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_LE(cv::norm(mat_of(frames[0]), picture(2), cv::NORM_INF), 2.0);
}

TEST(Still, SixteenBitStaysSixteenBit) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "b.tif"}) {
    cv::imwrite(folder / name, picture(1, 32, 24, true));
    const auto source = open_source(folder / name, kScale);
    EXPECT_EQ(source->info().bit_depth, 16) << name;
    EXPECT_TRUE(same_pixels(mat_of(*source->next()), picture(1, 32, 24, true))) << name;
  }
}

TEST(Still, ColourBecomesLuminance) {
  const TemporaryFolder folder;
  const cv::Mat red(4, 5, CV_8UC3, cv::Scalar(0, 0, 200));
  for (const char* name : {"a.png", "b.tif", "c.bmp"}) {
    cv::imwrite(folder / name, red);
    const auto source = open_source(folder / name, kScale);
    const cv::Mat grey = mat_of(*source->next());
    EXPECT_EQ(grey.type(), CV_8UC1) << name;
    EXPECT_EQ(static_cast<int>(grey.at<std::uint8_t>(2, 3)), 60) << name;
  }
}

TEST(Still, PixelSizeComesFromMetadata) {
  const TemporaryFolder folder;
  write_tiff(folder / "a.tif", {.per_unit = 10000.0F / 0.825F, .unit = RESUNIT_CENTIMETER, .description = ""});
  const auto source = open_source(folder / "a.tif", {});
  EXPECT_NEAR(source->info().pixel_size_um, 0.825, 1e-5);
  EXPECT_EQ(source->info().pixel_size_origin, "metadata");
  // What the user says wins.
  EXPECT_EQ(open_source(folder / "a.tif", kScale)->info().pixel_size_um, 0.5);
}

TEST(Still, PhysicalSizeOfAPng) {
  const TemporaryFolder folder;
  cv::imwrite(folder / "plain.png", picture(0));
  // A pHYs chunk of 1,212,121 pixels a metre, put behind the head (8 + 25 bytes).
  const std::string chunk("\0\0\0\x09pHYs\0\x12\x7E\xD9\0\x12\x7E\xD9\x01\xA9\x18\x62\x7B", 21);
  const std::string bytes = text_of(folder / "plain.png");
  std::ofstream(folder / "scaled.png", std::ios::binary) << bytes.substr(0, 33) << chunk << bytes.substr(33);
  EXPECT_NEAR(open_source(folder / "scaled.png", {})->info().pixel_size_um, 0.825, 1e-6);
}

TEST(Sequence, FolderInNaturalOrder) {
  const TemporaryFolder folder;
  for (const int number : {10, 9, 1, 2}) cv::imwrite(folder / (std::to_string(number) + ".png"), picture(number));
  put(folder / "notes.txt", "not an image");
  put(folder / ".hidden.png", "not to be looked at");
  const auto source = open_source(folder / "", kScale);
  EXPECT_EQ(source->info().frame_count, 4);
  EXPECT_EQ(source->info().frame_rate_hz, 20.0);
  const auto frames = all_frames(*source);
  ASSERT_EQ(frames.size(), 4U);
  const int order[] = {1, 2, 9, 10};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(same_pixels(mat_of(frames[i]), picture(order[i]))) << i;
    EXPECT_EQ(frames[i].frame_index, static_cast<long>(i));
    EXPECT_DOUBLE_EQ(frames[i].time_s, static_cast<double>(i) / 20.0);
    EXPECT_EQ(frames[i].gap_count, 0);
  }
  EXPECT_TRUE(source->restart());
  EXPECT_TRUE(same_pixels(mat_of(*source->next()), picture(1)));
}

TEST(Sequence, PagesOfATiff) {
  const TemporaryFolder folder;
  for (const std::uint16_t bits : {8, 16}) {
    for (const std::uint16_t compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE}) {
      for (const std::uint32_t tile : {0U, 16U}) {
        write_tiff(folder / "a.tif",
                   {.count = 5, .bits = bits, .compression = compression, .description = "", .tile = tile});
        const auto source = open_source(folder / "a.tif", kScale);
        EXPECT_EQ(source->info().frame_count, 5);
        EXPECT_EQ(source->info().bit_depth, bits);
        const auto frames = all_frames(*source);
        ASSERT_EQ(frames.size(), 5U);
        for (int i = 0; i < 5; ++i) {
          EXPECT_TRUE(same_pixels(mat_of(frames[static_cast<std::size_t>(i)]), picture(i, 32, 24, bits == 16)))
              << bits << " bit, compression " << compression << ", tile " << tile << ", page " << i;
        }
        EXPECT_TRUE(source->restart());
        EXPECT_EQ(all_frames(*source).size(), 5U);
      }
    }
  }
}

TEST(Sequence, WhiteIsZeroTiffIsTurnedRound) {
  const TemporaryFolder folder;
  write_tiff(folder / "a.tif", {.count = 2, .photometric = PHOTOMETRIC_MINISWHITE, .description = ""});
  const auto frames = all_frames(*open_source(folder / "a.tif", kScale));
  EXPECT_TRUE(same_pixels(mat_of(frames[1]), 255 - picture(1)));
}

TEST(Sequence, TiffTellsItsScaleAndRate) {
  const TemporaryFolder folder;
  write_tiff(folder / "a.tif", {.count = 3,
                                .per_unit = 1.0F / 0.825F,
                                .unit = RESUNIT_NONE,
                                .description = "ImageJ=1.53t\nimages=3\nunit=micron\nfinterval=0.05\n"});
  const auto source = open_source(folder / "a.tif", {});
  EXPECT_NEAR(source->info().pixel_size_um, 0.825, 1e-6);
  EXPECT_NEAR(source->info().frame_rate_hz, 20.0, 1e-9);
  EXPECT_EQ(source->info().frame_rate_origin, "metadata");
  EXPECT_NEAR(all_frames(*source)[2].time_s, 0.1, 1e-12);
}

TEST(Sequence, ImagesOfUnequalSizeAreRefusedWhereTheyCome) {
  const TemporaryFolder folder;
  cv::imwrite(folder / "1.png", picture(0));
  cv::imwrite(folder / "2.png", picture(0, 32, 25));
  const auto source = open_source(folder / "", kScale);
  EXPECT_TRUE(source->next());
  expect_error(ExitCode::kInputUnreadable, "2.png: 32 x 25 px, 8 bit where the first image is 32 x 24 px",
               [&] { source->next(); });
}

TEST(Sequence, BrokenImageInTheMiddle) {
  const TemporaryFolder folder;
  for (int i = 0; i < 3; ++i) cv::imwrite(folder / (std::to_string(i) + ".png"), picture(i));
  cut(folder / "1.png", 0.5);
  const auto source = open_source(folder / "", kScale);
  EXPECT_TRUE(source->next());
  expect_error(ExitCode::kInputUnreadable, "1.png: broken image (cut off", [&] { source->next(); });
}

TEST(Sequence, CutOffTiffGivesWhatIsThere) {
  const TemporaryFolder folder;
  write_tiff(folder / "a.tif", {.count = 4, .description = ""});
  cut(folder / "a.tif", 0.6);
  const auto source = open_source(folder / "a.tif", kScale);
  const long promised = *source->info().frame_count;
  EXPECT_LT(promised, 4);
  EXPECT_GE(promised, 1);
  // What is there is given, and then said where it ends, once.
  for (long i = 0; i < promised; ++i) EXPECT_TRUE(source->next()) << i;
  expect_error(ExitCode::kInputUnreadable, "a.tif: broken off after page " + std::to_string(promised),
               [&] { source->next(); });
  EXPECT_FALSE(source->next());
}

}  // namespace
}  // namespace pellucida
