#include "presenters/SourcePresenter.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

TEST(SourcePresenter, NamesSourceAndPicture) {
  SourceInfo info;
  info.name = "virtual:default";
  info.width_px = 728;
  info.height_px = 486;
  info.pixel_size_um = 0.825;
  info.frame_rate_hz = 30.0;
  info.frame_rate_origin = "scenario";
  EXPECT_EQ(window_title(info), "Pellucida - virtual:default");
  EXPECT_EQ(source_caption(info), "728 × 486 px  ·  0.825 µm/px  ·  30 frames/s");
}

TEST(SourcePresenter, FilesAndFoldersAreNamedWithoutTheWayToThem) {
  const auto label = [](const char* name) {
    SourceInfo info;
    info.name = name;
    return source_label(info);
  };
  EXPECT_EQ(label("/data/cells/day 1.avi"), "day 1.avi");
  EXPECT_EQ(label("/data/cells/"), "cells");
  EXPECT_EQ(label("v4l2:0"), "v4l2:0");
  EXPECT_EQ(label("/"), "/");
}

TEST(SourcePresenter, AStillHasNoFrameRate) {
  SourceInfo info;
  info.width_px = 10;
  info.height_px = 20;
  info.pixel_size_um = 0.5;
  info.frame_rate_hz = 1.0;
  info.frame_rate_origin = "still";
  EXPECT_EQ(source_caption(info), "10 × 20 px  ·  0.5 µm/px");
}

}  // namespace
}  // namespace pellucida
