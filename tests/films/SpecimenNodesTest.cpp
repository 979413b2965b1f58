// The force on every node and the membrane's tension, on cells from finite elements that share nothing with the
// program: from the contours as they are, and from films of them. Limits are about twice what is found.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "films/MembraneTable.h"
#include "films/RandomFilm.h"
#include "pellucida/core/Resources.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/mechanics/ForceObserver.h"
#include "pellucida/membrane/TriangleMesh.h"
#include "pellucida/simulation/CellReference.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "pellucida/tracking/MembraneTracker.h"

namespace pellucida::test {
namespace {

enum Zone { kTip, kFlank, kFree, kHolder, kZones };
constexpr const char* kZoneNames[] = {"tip", "flank", "free", "holder"};

// How far the nodes' forces and the tension of one zone are from the truth.
struct ZoneErrors {
  double force_squares = 0.0, true_force_squares = 0.0, tension_squares = 0.0, true_tension_squares = 0.0;
  int count = 0, covered = 0, tension_covered = 0;
  double force_rms() const { return std::sqrt(force_squares / true_force_squares); }
  double tension_rms() const { return std::sqrt(tension_squares / true_tension_squares); }
  double coverage() const { return count > 0 ? static_cast<double>(covered) / count : 1.0; }
  double tension_coverage() const { return count > 0 ? static_cast<double>(tension_covered) / count : 1.0; }
};

struct NodeErrors {
  ZoneErrors zones[kZones];
  void add(const ForceEstimate& e, const MembraneTable::Depth& truth, double load_ratio,
           const ReferenceGeometry& geometry) {
    const Eigen::Vector3d needle = e.rotation_WC.col(2);
    const Eigen::VectorXd areas = node_areas_um2(e.rest_um, e.triangles);
    for (Eigen::Index i = 0; i < e.rest_um.cols(); ++i) {
      const Eigen::Vector3d place = e.rest_um.col(i) - e.center_um;
      const double along = place.dot(needle), radius_um = place.norm();
      const Eigen::Vector3d across = place - along * needle;
      const double theta = std::atan2(across.norm(), along);
      const double half_rad = std::sqrt(areas[i] / std::numbers::pi) / radius_um;
      const Eigen::Vector2d load = load_ratio * truth.load_uN_per_um2(theta, half_rad);
      const Eigen::Vector3d out = across.norm() > 1e-9 ? across.normalized() : Eigen::Vector3d::Zero();
      const Eigen::Vector3d true_uN = -areas[i] * (load.x() * out + load.y() * needle);
      ZoneErrors& zone = zones[zone_of(theta, geometry)];
      ++zone.count;
      zone.force_squares += (e.force_uN.col(i) - true_uN).squaredNorm();
      zone.true_force_squares += true_uN.squaredNorm();
      const double beside_uN = std::abs(e.force_uN.col(i).norm() - true_uN.norm());
      if (beside_uN <= 1.96 * e.force_sigma_uN[i]) ++zone.covered;
      const double tension = load_ratio * truth.at(theta).tension_uN_per_um;
      zone.tension_squares += std::pow(e.tension_uN_per_um[i] - tension, 2);
      if (std::abs(e.tension_uN_per_um[i] - tension) <= 1.96 * e.tension_sigma_uN_per_um[i]) ++zone.tension_covered;
      zone.true_tension_squares += tension * tension;
    }
  }
  static Zone zone_of(double theta_rad, const ReferenceGeometry& g) {
    const double r_um = g.middle_radius_um;
    if (theta_rad < 2.0 * std::max(g.tip_radius_um, 0.08 * r_um) / r_um) return kTip;
    // The model's nodes there are an eighth of the radius apart.
    const double holder_um = g.holder_ring_um + g.holder_half_width_um;
    if (std::numbers::pi - theta_rad < std::asin(std::min(1.0, holder_um / r_um)) + 0.18) return kHolder;
    return theta_rad < 1.0 ? kFlank : kFree;
  }
  void print(const char* title) const {
    std::printf("%-26s", title);
    for (int z = 0; z < kZones; ++z) {
      std::printf(" | %s %5.1f %3.0f %5.1f %3.0f", kZoneNames[z], 100 * zones[z].force_rms(), 100 * zones[z].coverage(),
                  100 * zones[z].tension_rms(), 100 * zones[z].tension_coverage());
    }
    std::printf("\n");
  }
};

/// The shipped specimens, or those of the folder PELLUCIDA_SPECIMENS.
std::vector<std::string> specimen_paths() {
  const char* others = std::getenv("PELLUCIDA_SPECIMENS");
  auto paths = specimens_in(others ? others : (resource_folder() / "reference").string());
  std::erase_if(paths, [](const std::string& path) { return path.find("specimen-") == std::string::npos; });
  return paths;
}

/// A push to all depths of a specimen's membrane table.
Scenario deep_push_into(const std::string& path) {
  Scenario scenario = RandomFilm().scenario;
  scenario.cell.reference = path;
  scenario.motion.indentation_um = 41;
  scenario.motion.gap_um = 6;
  scenario.motion.indentation_speed_um_per_s = 20;
  scenario.motion.hold_s = 0.1;
  return scenario;
}

// The film, and what is read from it at the depths of the table: from the true contours and from the tracked ones.
TEST(SpecimenNodes, ForcesAndTension) {
  std::printf(
      "RMS error of nodal force, %% of the truth's RMS, and nodes inside their interval, %%; the same of tension\n");
  NodeErrors all_true, all_seen;
  int frame_count = 0, seen_count = 0;
  for (const std::string& path : specimen_paths()) {
    const CellReference specimen = CellReference::load(path, 1);
    const MembraneTable table(path + "-1-membrane.csv");
    VirtualMicroscope microscope(deep_push_into(path));
    MembraneTracker tracker(TrackerOptions{});
    ForceObserver of_truth(load_profile("mouse-oocyte")), observer(load_profile("mouse-oocyte"));
    of_truth.set_scale({1.0, 0.0});
    observer.set_scale({1.0, 0.0});
    std::size_t next = 0;
    while (const std::optional<Frame> frame = microscope.next()) {
      const Observation seen = tracker.process(view_of(frame->image.get()), frame->time_s, frame->frame_index);
      const ForceEstimate from_truth = of_truth.process(microscope.truth().observation);
      const ForceEstimate from_film = observer.process(seen);
      const double depth_um = microscope.truth().observation.indentation_um;
      if (next >= table.depths().size() || depth_um < table.depths()[next].indentation_um) continue;
      const MembraneTable::Depth& truth = table.depths()[next++];
      // The frame lies a fraction of a micrometre beyond the table's depth.
      const double ratio = specimen.force_uN(depth_um) / specimen.force_uN(truth.indentation_um);
      ASSERT_TRUE(from_truth.converged) << path << " at " << depth_um;
      NodeErrors of_frame, of_film;
      of_frame.add(from_truth, truth, ratio, specimen.geometry());
      all_true.add(from_truth, truth, ratio, specimen.geometry());
      ++frame_count;
      // A contact that the tracker missed is counted elsewhere.
      if (from_film.contact_force_uN > 0.0) {
        ++seen_count;
        of_film.add(from_film, truth, ratio, specimen.geometry());
        all_seen.add(from_film, truth, ratio, specimen.geometry());
      }
      char title[64];
      std::snprintf(title, sizeof title, "h %4.1f a %3.1f um, %2.0f um", specimen.geometry().thickness_um,
                    specimen.geometry().tip_radius_um, truth.indentation_um);
      of_frame.print(title);
      of_film.print("   as seen");
    }
    EXPECT_EQ(next, table.depths().size()) << path;
  }
  all_true.print("all, true contours");
  all_seen.print("all, as seen");
  EXPECT_GT(seen_count, 0.7 * frame_count);
  for (const NodeErrors* errors : {&all_true, &all_seen}) {
    // The load of a tool is spread over its patch otherwise than in a solid: the nodes there say that they don't know.
    EXPECT_GT(errors->zones[kTip].coverage(), 0.85);
    EXPECT_GT(errors->zones[kHolder].coverage(), 0.9);
    EXPECT_GT(errors->zones[kFlank].coverage(), 0.9);
    EXPECT_GT(errors->zones[kFree].coverage(), 0.9);
    for (const ZoneErrors& zone : errors->zones) EXPECT_GT(zone.tension_coverage(), 0.85);
    EXPECT_LT(errors->zones[kFlank].force_rms(), 0.45);
    EXPECT_LT(errors->zones[kFree].force_rms(), 0.3);
    EXPECT_LT(errors->zones[kFree].tension_rms(), 0.22);
  }
}

// Thickness, tip and holding pipette are hidden, so that the kind's count, or what the contours say of them: the true
// contours, without a tracker's errors.
TEST(SpecimenNodes, SizesByContours) {
  NodeErrors by_kind, by_contours;
  double kind_squares = 0.0, contours_squares = 0.0, true_squares = 0.0;  // of the contact force
  for (const std::string& path : specimen_paths()) {
    const CellReference specimen = CellReference::load(path, 1);
    // The model stays where the kind's tools touch: nodes under either tool are the tools'.
    const CellProfile kind = load_profile("mouse-oocyte");
    ReferenceGeometry zones = specimen.geometry();
    zones.tip_radius_um = std::max(zones.tip_radius_um, kind.tip_radius_um);
    zones.holder_ring_um =
        std::max(zones.holder_ring_um + zones.holder_half_width_um, kind.holder_ring_um + kind.holder_half_width_um) -
        zones.holder_half_width_um;
    const MembraneTable table(path + "-1-membrane.csv");
    VirtualMicroscope microscope(deep_push_into(path));
    ForceObserver with(kind), without(kind);
    with.set_scale({1.0, 0.0});
    without.set_scale({1.0, 0.0});
    std::size_t next = 0;
    while (microscope.next()) {
      Observation seen = microscope.truth().observation;
      seen.rest_inner_radius_um = 0.0;
      seen.inner.reset();
      if (seen.needle) seen.needle->tip_radius_um = 0.0;
      if (seen.holder) seen.holder->outer_radius_um = 0.0;
      const ForceEstimate corrected = with.process(seen);
      // Without an outline at rest no contour is held against a solid.
      if (seen.state == CellState::kFree) seen.outer->points_um.resize(2, 0);
      const ForceEstimate usual = without.process(seen);
      const double depth_um = seen.indentation_um;
      if (next >= table.depths().size() || depth_um < table.depths()[next].indentation_um) continue;
      const MembraneTable::Depth& truth = table.depths()[next++];
      ASSERT_TRUE(corrected.converged && usual.converged) << path << " at " << depth_um;
      const double true_uN = specimen.force_uN(depth_um), ratio = true_uN / specimen.force_uN(truth.indentation_um);
      kind_squares += std::pow(usual.contact_force_uN - true_uN, 2);
      contours_squares += std::pow(corrected.contact_force_uN - true_uN, 2);
      true_squares += true_uN * true_uN;
      by_kind.add(usual, truth, ratio, zones);
      by_contours.add(corrected, truth, ratio, zones);
    }
  }
  by_kind.print("sizes of the kind");
  by_contours.print("sizes by contours");
  std::printf("contact force, RMS error in %% of the truth's RMS: %.1f by the kind, %.1f by contours\n",
              100.0 * std::sqrt(kind_squares / true_squares), 100.0 * std::sqrt(contours_squares / true_squares));
  EXPECT_LT(contours_squares, 0.25 * kind_squares);
  EXPECT_LT(by_contours.zones[kFree].force_rms(), 0.6 * by_kind.zones[kFree].force_rms());
  EXPECT_LT(by_contours.zones[kFlank].force_rms(), 0.8 * by_kind.zones[kFlank].force_rms());
  EXPECT_LT(by_contours.zones[kFree].tension_rms(), 0.6 * by_kind.zones[kFree].tension_rms());
  EXPECT_GT(by_contours.zones[kFree].coverage(), 0.9);
  EXPECT_GT(by_contours.zones[kFlank].coverage(), 0.9);
}

}  // namespace
}  // namespace pellucida::test
