#include "pellucida/simulation/CellReference.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>

#include "pellucida/core/Error.h"
#include "pellucida/core/Resources.h"
#include "pellucida/core/Table.h"
#include "pellucida/simulation/Truth.h"
#include "pellucida/simulation/VirtualSpecimen.h"
#include "simulation/SectionChecks.h"
#include "simulation/TestScenes.h"

namespace pellucida {
namespace {

using test::ReferenceCase;

class EveryReference : public testing::TestWithParam<ReferenceCase> {
 protected:
  CellReference reference_ = CellReference::load(GetParam().cell, GetParam().configuration);
};

TEST_P(EveryReference, ForceIsTheCurveAtItsDepths) {
  const auto file = resource_folder() / "reference" /
                    (std::string(GetParam().cell) + "-" + std::to_string(GetParam().configuration) + "-force.csv");
  const Table curve = Table::read(file);
  const auto depth = curve.column("indentation_um"), force = curve.column("force_uN"),
             pressure = curve.column("pressure_kPa");
  ASSERT_GT(depth.size(), 20);
  for (Eigen::Index i = 0; i < depth.size(); ++i) {
    EXPECT_NEAR(reference_.force_uN(depth(i)), force(i), 1e-12);
    EXPECT_NEAR(reference_.pressure_Pa(depth(i)), 1e3 * pressure(i), 1e-9);
    if (curve.has("lateral_force_uN"))
      EXPECT_NEAR(reference_.lateral_force_uN(depth(i)), curve.column("lateral_force_uN")(i), 1e-12);
    else
      EXPECT_EQ(reference_.lateral_force_uN(depth(i)), 0.0);
  }
  EXPECT_EQ(reference_.force_uN(-5), 0.0);
}

TEST_P(EveryReference, ForceRisesAllTheWay) {
  double before = 0;
  for (double depth = 0.05; depth <= reference_.max_indentation_um(); depth += 0.05) {
    const double force = reference_.force_uN(depth);
    ASSERT_GT(force, before) << depth;
    before = force;
  }
}

TEST_P(EveryReference, RestIsTwoCircles) {
  const auto rest = reference_.section(-3);
  for (Eigen::Index i = 0; i < rest.outer_um.cols(); ++i) {
    EXPECT_NEAR(rest.outer_um.col(i).norm(), reference_.outer_radius_um(), 0.0013);
    EXPECT_NEAR(rest.inner_um.col(i).norm(), reference_.inner_radius_um(), 0.0013);
  }
}

TEST_P(EveryReference, ApexFollowsTheDepth) {
  const Eigen::Index apex = reference_.angle_rad().size() / 2;
  EXPECT_EQ(reference_.angle_rad()(apex), std::asin(reference_.offset_um() / reference_.outer_radius_um()));
  for (double depth = 0; depth <= reference_.max_indentation_um(); depth += 0.7) {
    const auto section = reference_.section(depth);
    EXPECT_NEAR(section.outer_um(1, apex), reference_.apex_z_um() - depth, reference_.offset_um() > 0 ? 4.5e-3 : 9e-4)
        << depth;
    EXPECT_NEAR(section.outer_um(0, apex), reference_.offset_um(), 0.095) << depth;
  }
}

TEST_P(EveryReference, ShapeMovesSmoothlyWithDepth) {
  // No point moves faster than twice the tip, nor jumps: also between the steps of the table.
  const double step = 0.05;
  auto before = reference_.section(0);
  for (double depth = step; depth <= reference_.max_indentation_um(); depth += step) {
    const auto now = reference_.section(depth);
    ASSERT_LE((now.outer_um - before.outer_um).colwise().norm().maxCoeff(), 2.0 * step) << depth;
    ASSERT_LE((now.inner_um - before.inner_um).colwise().norm().maxCoeff(), 2.0 * step) << depth;
    before = now;
  }
}

TEST_P(EveryReference, ContoursAreClosedSmoothAndDoNotCross) {
  for (double depth = 0; depth <= reference_.max_indentation_um(); depth += 1) {
    const auto section = reference_.section(depth);
    for (const Contour_um* contour : {&section.outer_um, &section.inner_um}) {
      EXPECT_EQ(test::crossing_count(*contour), 0) << depth;
      // Neighbours are close, and no corner is sharper than 20 degrees.
      const Eigen::Index n = contour->cols();
      for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Vector2d a = contour->col((i + n - 1) % n), b = contour->col(i), c = contour->col((i + 1) % n);
        EXPECT_LE((c - b).norm(), 2.0) << depth << " point " << i;
        EXPECT_LE(std::abs(std::atan2(test::cross(b - a, c - b), (b - a).dot(c - b))), 20 * std::numbers::pi / 180)
            << depth << " point " << i;
      }
    }
    // The inner membrane lies inside the outer one, a zona's thickness away.
    for (Eigen::Index i = 0; i < section.inner_um.cols(); ++i) {
      ASSERT_TRUE(test::inside(section.outer_um, section.inner_um.col(i))) << depth;
      const double thickness = test::distance_to(section.outer_um, section.inner_um.col(i));
      ASSERT_GE(thickness, 2.0) << depth << " point " << i;
      ASSERT_LE(thickness, 6.5) << depth << " point " << i;
    }
  }
}

TEST_P(EveryReference, HolderAndCellDoNotOverlap) {
  const double angle = reference_.holder_angle_rad();
  const Eigen::Vector2d to_holder(std::sin(angle), -std::cos(angle));
  // The rim as the microscope draws it: glass 5 um in radius that touches the resting membrane.
  const double reach = reference_.outer_radius_um() + 5, sine = reference_.geometry().holder_ring_um / reach;
  for (double depth = 0; depth <= reference_.max_indentation_um(); depth += 1) {
    const auto section = reference_.section(depth);
    for (double side : {1.0, -1.0}) {
      const Eigen::Vector2d rim = reach * (std::sqrt(1 - sine * sine) * to_holder +
                                           side * sine * Eigen::Vector2d(-to_holder.y(), to_holder.x()));
      EXPECT_GE(test::distance_to(section.outer_um, rim), 5 - 1.2) << depth;
      EXPECT_FALSE(test::inside(section.outer_um, rim)) << depth;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cells, EveryReference,
                         testing::Values(ReferenceCase{"mouse-oocyte", 1}, ReferenceCase{"mouse-oocyte", 2},
                                         ReferenceCase{"mouse-oocyte", 3}, ReferenceCase{"mouse-oocyte", 4},
                                         ReferenceCase{"mouse-embryo", 1}, ReferenceCase{"mouse-embryo", 2},
                                         ReferenceCase{"mouse-embryo", 3}, ReferenceCase{"mouse-embryo", 4}),
                         [](const auto& which) {
                           return std::string(which.param.cell).substr(6) + std::to_string(which.param.configuration);
                         });

TEST(ReferenceGeometry, IsOfTheTablesAndFaultsAreNamed) {
  const ReferenceGeometry oocyte = load_reference_geometry("mouse-oocyte");
  EXPECT_EQ(oocyte.outer_radius_um(), 52.5);
  EXPECT_EQ(oocyte.inner_radius_um(), 47.5);
  EXPECT_THROW(load_reference_geometry("mouse-ocyte"), UsageError);
  const auto folder = std::filesystem::temp_directory_path() / "pellucida-reference-geometry";
  std::filesystem::create_directories(folder);
  const auto fault = [&](const std::string& text) -> std::string {
    std::ofstream(folder / "cell-geometry.json") << text;
    try {
      load_reference_geometry((folder / "cell").string());
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(fault(R"({"thickness_um": 5})").find("middle_radius_um"), std::string::npos);
  EXPECT_NE(fault(R"({"middle_radius_um": 50, "thickness_um": -5, "tip_radius_um": 5, "holder_ring_um": 17,
                      "holder_half_width_um": 5, "young_modulus_kPa": 100})")
                .find("thickness_um is -5"),
            std::string::npos);
  std::filesystem::remove_all(folder);
}

TEST(CellReference, ToolsAreDrawnAsWideAsTheMechanicsHasThem) {
  Scenario scenario;
  scenario.cell.reference = "specimen-18";
  scenario.cell.size_scale = 0.9;
  scenario.motion.indentation_um = 30;
  const ReferenceGeometry geometry = load_reference_geometry("specimen-18");
  EXPECT_NEAR(with_tools_drawn(scenario).tools.needle_tip_radius_um, 0.9 * geometry.tip_radius_um, 1e-12);
  const HolderRim rim = holder_rim(VirtualSpecimen(scenario));
  EXPECT_NEAR(rim.ring_radius_um + rim.wall_radius_um, 0.9 * (geometry.holder_ring_um + geometry.holder_half_width_um),
              1e-12);
  scenario.tools.needle_tip_radius_um = 1.5;  // as it is given
  EXPECT_EQ(with_tools_drawn(scenario).tools.needle_tip_radius_um, 1.5);
}

TEST(CellReference, ASpecimenWithoutATableOfOffsetsHoldsOnItsAxis) {
  Scenario scenario;
  scenario.cell.reference = "specimen-3";
  const VirtualSpecimen specimen(scenario);
  EXPECT_TRUE(specimen.force().at(specimen.force().tip_at(0.0, 20.0)).in_range);
  EXPECT_FALSE(specimen.force().at(specimen.force().tip_at(3.0, 20.0)).in_range);
}

TEST(CellReference, MeasuredPunctureForces) {
  EXPECT_NEAR(CellReference::load("mouse-oocyte", 1).force_uN(44), 7.5, 1e-9);
  EXPECT_NEAR(CellReference::load("mouse-embryo", 1).force_uN(53), 13.0, 1e-9);
}

TEST(CellReference, VolumeIsKeptWhereTheSectionIsASurfaceOfRevolution) {
  // The finite elements keep the fluid's volume; the section's faces are 2.5 um off the middle surface, so each face
  // alone varies a little with the stretch.
  for (const char* cell : {"mouse-oocyte", "mouse-embryo"}) {
    const auto reference = CellReference::load(cell, 1);
    const double rest_outer = revolved_volume_um3(reference.section(0).outer_um);
    const double rest_inner = revolved_volume_um3(reference.section(0).inner_um);
    EXPECT_NEAR(rest_outer, 4 * std::numbers::pi / 3 * std::pow(reference.outer_radius_um(), 3), 1.9e-4 * rest_outer);
    for (double depth = 0; depth <= reference.max_indentation_um(); depth += 1) {
      const auto section = reference.section(depth);
      EXPECT_NEAR(revolved_volume_um3(section.outer_um), rest_outer, 0.015 * rest_outer) << cell << depth;
      EXPECT_NEAR(revolved_volume_um3(section.inner_um), rest_inner, 0.015 * rest_inner) << cell << depth;
    }
  }
}

TEST(CellReference, UnknownOnesAreRefused) {
  EXPECT_THROW(CellReference::load("mouse-oocyte", 5), UsageError);
  EXPECT_THROW(CellReference::load("frog", 1), UsageError);
}

}  // namespace
}  // namespace pellucida
