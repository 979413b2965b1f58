#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <type_traits>

#include "pellucida/core/PlainVector.h"

namespace pellucida {

/// How a fixture feels. A violation of p um is answered like a spring stretched by c(p) um, at the hand: c = p^2 / (2
/// w) up to the width w and p - w/2 beyond, so that force and slope start from zero (C1).
struct FixtureFeel {
  double stiffness_N_per_m = 200.0;  ///< at the hand
  double damping_N_s_per_m = 0.5;    ///< at the hand, against motion into or along the violation's normal
  double width_um = 2.0;             ///< w, above 0
  bool operator==(const FixtureFeel&) const = default;
};

// All lengths um, frame W. A fixture gives the displacement the tip should make: zero where it is satisfied.

/// Keeps the tip on the planned line inside the cell, on the way in and on the way out: within `radius_um` of the line;
/// before the entry the tube flares, and only the cone guides.
struct RectilinearGuide {
  bool enabled = false;
  PlainVector3 entry_um;
  PlainVector3 axis{1.0, 0.0, 0.0};  ///< unit vector into the cell
  double radius_um = 1.0;            ///< free play, >= 0
  double opening_um = 30.0;          ///< above 0: before the entry, at s um, the radius has grown by s^2 / (2 opening)
  FixtureFeel feel;
  bool operator==(const RectilinearGuide&) const = default;
};

/// Funnels the tip to the entry: within the radius r(s) = radius + s tan(half angle) at s um before the entry, up to
/// `length_um`, beyond which it opens quickly and nothing is felt.
struct ApproachCone {
  bool enabled = false;
  PlainVector3 entry_um;
  PlainVector3 axis{1.0, 0.0, 0.0};
  double radius_um = 1.0;
  double half_angle_rad = 0.3;  ///< 0 .. 1.4
  double length_um = 100.0;     ///< above 0
  double opening_um = 30.0;     ///< above 0
  FixtureFeel feel;
  bool operator==(const ApproachCone&) const = default;
};

/// No deeper than `depth_um` beyond the entry along the axis.
struct DepthStop {
  bool enabled = false;
  PlainVector3 entry_um;
  PlainVector3 axis{1.0, 0.0, 0.0};
  double depth_um = 50.0;
  FixtureFeel feel;
  bool operator==(const DepthStop&) const = default;
};

/// Forbidden: the cell's body (a sphere) outside the path (a cylinder about the planned line).
struct CellBody {
  bool enabled = false;
  PlainVector3 center_um;
  double radius_um = 40.0;
  PlainVector3 entry_um;  ///< a point of the path's line
  PlainVector3 axis{1.0, 0.0, 0.0};
  double path_radius_um = 6.0;
  FixtureFeel feel;
  bool operator==(const CellBody&) const = default;
};

/// Forbidden: the holding pipette, a half-infinite cylinder from its mouth on.
struct HolderBody {
  bool enabled = false;
  PlainVector3 mouth_um;
  PlainVector3 direction{-1.0, 0.0, 0.0};  ///< unit vector from the cell's centre to the mouth
  double radius_um = 40.0;                 ///< clearance included
  FixtureFeel feel;
  bool operator==(const HolderBody&) const = default;
};

/// The displacement from `tip_um` to where the fixture wants the tip, already softened (c of `FixtureFeel`). Each is
/// finite and continuous in the tip for any finite tip.
Eigen::Vector3d correction_um(const RectilinearGuide& guide, const Eigen::Vector3d& tip_um) noexcept;
Eigen::Vector3d correction_um(const ApproachCone& cone, const Eigen::Vector3d& tip_um) noexcept;
Eigen::Vector3d correction_um(const DepthStop& stop, const Eigen::Vector3d& tip_um) noexcept;
Eigen::Vector3d correction_um(const CellBody& body, const Eigen::Vector3d& tip_um) noexcept;
Eigen::Vector3d correction_um(const HolderBody& holder, const Eigen::Vector3d& tip_um) noexcept;

/// Which fixtures acted, in a mask.
enum FixtureBit : std::uint32_t { kGuideBit = 1, kConeBit = 2, kStopBit = 4, kCellBit = 8, kHolderBit = 16 };

/// All fixtures of a plan, as passed to the 1 kHz thread. Trivially copyable.
struct FixtureSet {
  RectilinearGuide guide;
  ApproachCone cone;
  DepthStop stop;
  CellBody cell;
  HolderBody holder;
  double max_force_N = 2.0;  ///< of all together at the hand
  bool operator==(const FixtureSet&) const = default;
};
static_assert(std::is_trivially_copyable_v<FixtureSet>);

/// The effect of a set at one position of the tip.
struct FixtureResult {
  Eigen::Vector3d allowed_um = Eigen::Vector3d::Zero();  ///< where the pipette may be
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();     ///< on the hand, frame W
  std::uint32_t acting = 0;                              ///< mask of `FixtureBit`
};

/// The fixtures one after another: guide, cone, depth stop, cell body, holder. Each acts on the position left by those
/// before, so two that want the same do not push twice and two that contradict do not fight; the later decides where
/// the pipette may be: protection before guidance. The force is the sum of each one's spring on its own correction,
/// damped, limited to `max_force_N`. As in the virtual coupling, the part of the hand's motion that is corrected away
/// does not move the pipette, so the stiffness felt never exceeds that of the stiffest fixture or cell.
///
/// `part` (0..1) fades all of them; `velocity_um_per_s` is the wanted tip's, `scale_um_per_m` turns um into m of the
/// hand.
FixtureResult apply(const FixtureSet& set, const Eigen::Vector3d& wanted_um, const Eigen::Vector3d& velocity_um_per_s,
                    double scale_um_per_m, double part) noexcept;

}  // namespace pellucida
