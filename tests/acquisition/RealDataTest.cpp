#include "TestFiles.h"

namespace pellucida {
namespace {

using namespace test;

// Recordings beside the checkout, where they are.
std::string real(const std::string& name) {
  return PELLUCIDA_SOURCE_DIR "/../shared/real/" + name;
}

void expect_video(const std::string& file, int width_px, int height_px, std::size_t count, long lost_count) {
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not here";
  const auto source = open_source(file, {.pixel_size_um = 0.2, .frame_rate_hz = {}});
  EXPECT_EQ(source->info().width_px, width_px);
  EXPECT_EQ(source->info().height_px, height_px);
  const auto frames = all_frames(*source);
  EXPECT_EQ(frames.size(), count);
  EXPECT_EQ(frames.back().frame_index + 1, static_cast<long>(count) + lost_count);
  for (const Frame& frame : frames) EXPECT_FALSE(frame.damage.damaged) << frame.frame_index;
}

TEST(RealData, NeedleVideo) {
  expect_video(real("needle/zebrafish_larva_poke.mkv"), 512, 512, 125, 0);
}
TEST(RealData, AspirationVideo) {
  // Its stamps leave out the frame before the last one.
  expect_video(real("aspiration/red_cell_aspiration.mp4"), 942, 192, 740, 1);
}

TEST(RealData, SixteenBitStill) {
  const std::string file = real("oocyte_stills/vesicle_on_pipette_16bit.png");
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not here";
  const auto source = open_source(file, {.pixel_size_um = 0.2, .frame_rate_hz = {}});
  EXPECT_EQ(source->info().bit_depth, 16);
  EXPECT_EQ(source->info().width_px, 600);
  EXPECT_TRUE(source->next());
}

}  // namespace
}  // namespace pellucida
