#include <gtest/gtest.h>

#include <cmath>

#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "simulation/TestScenes.h"

namespace pellucida {
namespace {

using test::bytes_of;
using test::scenario_of;

TEST(Looks, SameSeedSameBytesUnderEveryLook) {
  for (const std::string& look : look_names()) {
    SCOPED_TRACE(look);
    const std::string json =
        R"({"look": ")" + look + R"(", "image": {"frame_rate_hz": 1, "width_px": 400, "height_px": 300},
                                 "cell": {"center_x_um": 150, "center_y_um": 120}})";
    VirtualMicroscope a(scenario_of(json)), b(scenario_of(json));
    const auto one = *a.next(), two = *b.next();
    EXPECT_EQ(bytes_of(one), bytes_of(two));
    Scenario plain = scenario_of(json);
    plain.look = "drawing";
    VirtualMicroscope drawn(plain);
    EXPECT_NE(bytes_of(one), bytes_of(*drawn.next()));
  }
}

TEST(Looks, TruthIsTheDrawings) {
  Scenario scenario = scenario_of(R"({"image": {"frame_rate_hz": 2}})");
  VirtualMicroscope drawn(scenario);
  scenario.look = "hoffman";
  VirtualMicroscope looked(scenario);
  while (drawn.next()) {
    ASSERT_TRUE(looked.next());
    const Observation &a = drawn.truth().observation, &b = looked.truth().observation;
    EXPECT_EQ(a.outer->points_um, b.outer->points_um);
    EXPECT_EQ(a.needle->tip_um, b.needle->tip_um);
    EXPECT_EQ(a.needle->tip_um, Eigen::Vector2d(b.needle->outline_um.col(0)));
    EXPECT_EQ(a.holder->mouth_um, b.holder->mouth_um);
  }
}

TEST(Looks, HolderOutOfViewAndCellOutOfView) {
  Look look;
  look.holder.in_view = false;
  const Scenario scenario = scenario_of(R"({"cell": {"in_view": false}, "image": {"frame_rate_hz": 1}})");
  VirtualMicroscope microscope(scenario, look);
  while (microscope.next()) {
    const Observation& seen = microscope.truth().observation;
    EXPECT_EQ(seen.state, CellState::kNoCell);
    EXPECT_FALSE(seen.outer || seen.inner || seen.holder);
    EXPECT_TRUE(seen.needle);
    EXPECT_EQ(microscope.truth().contact_force_uN, 0);
  }
  EXPECT_TRUE(VirtualMicroscope(scenario).next());  // drawn, too
}

TEST(Looks, NeedleMovesInDepth) {
  Scenario scenario = scenario_of(
      R"({"look": "hoffman", "image": {"frame_rate_hz": 10, "duration_s": 1.5},
          "motion": {"gap_um": 20, "indentation_um": 0, "approach_speed_um_per_s": 500, "hold_s": 2,
                     "out_of_plane_um": 25, "out_of_plane_time_s": 0.8}})");
  VirtualMicroscope microscope(scenario);
  while (microscope.next()) {
    const Truth& truth = microscope.truth();
    if (truth.observation.time_s <= 0.8) {
      EXPECT_EQ(truth.tip_um.z, 0);
    }
    if (truth.observation.time_s >= 1.15) {
      EXPECT_NEAR(truth.tip_um.z, 25, 1e-9);
    }
  }
}

// The picture with the cell and that without differ inside the true contour alone.
TEST(Looks, CellIsDrawnInsideItsTrueContour) {
  Look look;
  look.contrast.kind = "hoffman";
  look.contrast.point_spread_um = 0.3;
  look.cell.cumulus_count = 0;
  look.camera.full_well_electrons = 1e6;
  look.camera.read_noise_electrons = 0;
  for (const char* tools : {R"("configuration": 1)", R"("configuration": 3, "holder_angle_deg": 70)"}) {
    const std::string rest = std::string(R"("tools": {)") + tools +
                             R"(}, "image": {"frame_rate_hz": 2, "bit_depth": 16, "pixel_size_um": 0.5,
                                "width_px": 500, "height_px": 400}, "debris": {"count": 0})";
    VirtualMicroscope with(scenario_of("{" + rest + R"(, "cell": {"center_x_um": 120, "center_y_um": 100}})"), look);
    VirtualMicroscope without(
        scenario_of("{" + rest + R"(, "cell": {"center_x_um": 120, "center_y_um": 100, "in_view": false}})"), look);
    while (const auto frame = with.next()) {
      const auto empty = without.next();
      const Contour_um& outer = with.truth().observation.outer->points_um;
      const ImageView a = view_of(frame->image.get()), b = view_of(empty->image.get());
      const auto *pa = static_cast<const std::uint16_t*>(a.data), *pb = static_cast<const std::uint16_t*>(b.data);
      // The dimple is seen through the ring about it: leave it out.
      const Observation& seen = with.truth().observation;
      int outside = 0, inside = 0, checked = 0;
      for (Eigen::Index k = 0; k < outer.cols(); ++k) {
        const Eigen::Vector2d tangent =
            (outer.col((k + 1) % outer.cols()) - outer.col((k + outer.cols() - 1) % outer.cols())).normalized();
        const Eigen::Vector2d normal(tangent.y(), -tangent.x());
        const Eigen::Vector2d from = outer.col(k) - seen.center_um;
        const double across = std::abs(seen.axis.x() * from.y() - seen.axis.y() * from.x());
        if (from.dot(seen.axis) > -0.4 * seen.rest_outer_radius_um && across < seen.dimple_radius_um + 8) continue;
        if (from.dot(seen.holder->direction) > 0.8 * seen.rest_outer_radius_um) continue;     // the rim's groove
        if (std::abs(std::cos(45 * M_PI / 180) * (normal.x() + normal.y())) < 0.3) continue;  // along the shear
        auto difference = [&](double way_um) {
          const Eigen::Vector2d p = (outer.col(k) + way_um * normal) / 0.5;
          const long at = std::lround(p.y()) * a.width_px + std::lround(p.x());
          return std::abs(pa[at] - pb[at]);
        };
        ++checked;
        if (difference(2.0) > 1500) ++outside;
        if (difference(-1.0) > 3000) ++inside;
      }
      ASSERT_GT(checked, 60);
      EXPECT_LE(outside, checked / 50) << frame->frame_index;
      EXPECT_GE(inside, checked * 3 / 4) << frame->frame_index;
    }
  }
}

}  // namespace
}  // namespace pellucida
