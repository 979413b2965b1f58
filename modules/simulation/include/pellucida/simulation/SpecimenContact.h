#pragma once
#include <array>
#include <type_traits>

#include "pellucida/core/Observation.h"
#include "pellucida/core/PlainVector.h"
#include "pellucida/simulation/Scenario.h"
#include "pellucida/simulation/SpecimenForce.h"

namespace pellucida {

/// A droplet that the needle left in the cell: a sphere at rest.
struct Droplet {
  PlainVector3 center_um;  ///< frame W, before the stage moved
  double volume_pL = 0.0;  ///< 1 pL = 1000 um^3
  double radius_um() const noexcept;
};

/// The cell under the needle at one moment: its response and what happened to it. Trivially copyable.
struct SpecimenMoment {
  static constexpr int kMaxDroplets = 16;

  double time_s = 0.0;
  PlainVector3 tip_um;  ///< as given, frame W
  SpecimenReply reply;  ///< at the tip; no force and no energy while punctured
  CellState state = CellState::kFree;
  double pressure_depth_um = 0.0;  ///< depth that the pressure belongs to; 0 when free or punctured
  double puncture_time_s = -1.0;   ///< of the last puncture; below 0: the membrane is intact
  double puncture_depth_um = 0.0;  ///< of the membrane then
  double puncture_force_uN = 0.0;  ///< along the push, just before
  int puncture_count = 0;          ///< since the cell was new
  int droplet_count = 0;           ///< of `droplets`
  std::array<Droplet, kMaxDroplets> droplets{};
  double deposited_pL = 0.0;  ///< all of them
  double lost_pL = 0.0;       ///< expelled while the tip was not inside the cell, or for want of room
};
static_assert(std::is_trivially_copyable_v<SpecimenMoment>);

/// The cell's memory under a freely moved needle: intact, touched, punctured, intact again. Trivially copyable;
/// `advance` allocates nothing and never throws, so a 1 kHz thread may own it.
///
/// Free: the tip is outside the resting membrane. Contact: the membrane follows the tip. Punctured: from the moment the
/// axial force reaches this cell's strength; the force is 0 at once and the membrane returns exponentially to the
/// residual depth around the needle, or with the needle where that is less deep. Free again, and intact, once the tip
/// has left. A cell's strength is the force of its configuration's curve at `puncture.indentation_um`, reduced by a
/// share that the seed draws (`puncture.spread_ratio`); the membrane also gives way where the tables end.
class SpecimenContact {
 public:
  SpecimenContact() = default;
  SpecimenContact(const SpecimenForce& force, const Scenario& scenario);

  /// The tip at `tip_um` at `time_s` (never going back), and all that the needle has expelled so far, pL (a smaller
  /// total than before counts as no change). What it expels inside the punctured cell stays there as a droplet;
  /// droplets grow while the tip stays near.
  const SpecimenMoment& advance(const PlainVector3& tip_um, double time_s, double expelled_pL = 0.0) noexcept;

  /// A new cell: intact and empty. The total expelled so far is kept.
  void reset() noexcept;

  const SpecimenMoment& moment() const noexcept { return moment_; }
  const SpecimenForce& force() const noexcept { return force_; }
  /// The axial force at which this cell punctures, uN; 0 when punctures are off.
  double puncture_force_uN() const noexcept { return enabled_ ? bears_uN_ : 0.0; }

 private:
  void expel(double volume_pL) noexcept;

  SpecimenForce force_;
  bool enabled_ = false;
  double bears_uN_ = 0.0, residual_um_ = 0.0, relaxation_s_ = 0.06;
  bool started_ = false;
  double last_axial_uN_ = 0.0, expelled_pL_ = 0.0;
  SpecimenMoment moment_;
};
static_assert(std::is_trivially_copyable_v<SpecimenContact>);

/// The share of the nominal puncture force for the cell of this seed: uniform between 1 - spread and 1.
double puncture_share(std::uint64_t seed, double spread_ratio);

}  // namespace pellucida
