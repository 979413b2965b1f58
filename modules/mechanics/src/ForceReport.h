#pragma once
#include "CellModelCache.h"
#include "CellPlacement.h"
#include "RelaxingContact.h"
#include "SizesCorrector.h"
#include "pellucida/mechanics/ForceCrossCheck.h"
#include "pellucida/mechanics/ForceObserver.h"

namespace pellucida {

/// The model in equilibrium with one frame.
struct SolvedFrame {
  const Observation& observation;
  const CellModelCache& cell;
  const CellPlacement& placement;
  const CellScale& scale;
  const ShapeAuditor& auditor;
  IndentationState state;
  double depth_um = 0.0;  ///< 0 out of contact
  bool contact = false;
  double touch_um = 0.0;  ///< out of contact: how deep the needle may be all the same
  SizesCorrection sizes;
};

/// Writes what a solved frame says into an estimate: shape, forces on needle and nodes, errors and interval, what other
/// models say. Remembers what the membrane has relaxed. One thread at a time.
class ForceReport {
 public:
  /// Throws InputError when a shipped force table is broken. `profile` must outlive it.
  ForceReport(const CellProfile& profile, const ForceOptions& options);

  /// Out of contact at `time_s`: what comes begins from 0 there.
  void rest(double time_s) noexcept { relaxing_.rest(time_s); }
  /// Nothing is known of what was before.
  void forget() noexcept { relaxing_.forget(); }

  /// `estimate` has its placement, depth's sigma, shape and convergence. Without convergence the forces stay
  /// unmeasured.
  void write(const SolvedFrame& frame, ForceEstimate& estimate);

 private:
  RelaxingContact::Force force_of(const SolvedFrame& frame, const ForceEstimate& estimate);
  /// Of no force, where the needle may touch.
  static ForceInterval interval_of_touch(const SolvedFrame& frame, const ForceErrors& errors);
  void ask_others(const SolvedFrame& frame, double scale, ForceEstimate& estimate) const;

  const CellProfile& profile_;
  bool naive_readout_;
  ForceTables tables_;
  RelaxingContact relaxing_;
};

}  // namespace pellucida
