#pragma once
#include <memory>
#include <vector>

#include "pellucida/core/Observation.h"
#include "pellucida/mechanics/ForceEstimate.h"
#include "pellucida/mechanics/ScaleMeasurement.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/membrane/Indenter.h"

namespace pellucida {

/// What may be chosen about the estimate.
struct ForceOptions {
  /// Weight omega of the contour in the equilibrium, as a ratio to E h, 1/um^2: 0, the depth alone (default); the
  /// largest sensible value is 1e-5 (docs/method.md, 3.8, explains the 0).
  double observation_ratio = 0.0;
  /// Also read the springs with every node placed on the contour: biased, for teaching only.
  bool naive_readout = false;
  /// The frequency for which stiffness and damping are given, if the profile has relaxation arms; above 0. A hand moves
  /// at about 1 Hz.
  double hand_frequency_Hz = 1.0;
};

/// Force from the tracked shape. Each frame: the contact point from the needle's line and the resting outline, which
/// gives the cell's frame and the push (a needle beside the centre pushes at an angle); the holder where it was
/// tracked; the filtered indentation, taken as the needle's depth; then the mass-spring-damper membrane in equilibrium
/// with the needle that deep, started from the last frame's shape; then the exact read-out of the tip's bond. The rest
/// of the contour audits the result: it widens the interval and raises warnings. Whether the membrane has given way is
/// decided from tip, membrane, contour and the tracker's state together; in doubt the force goes on, with a wider
/// interval and a warning. Where the profile has relaxation arms the force, and with it everything on the nodes, is
/// what remains of it since the contact began (`Relaxation`). One thread at a time; not real-time safe (allocates).
class ForceObserver {
 public:
  explicit ForceObserver(CellProfile profile, ForceOptions options = {});
  ~ForceObserver();
  ForceObserver(ForceObserver&&) noexcept;
  ForceObserver& operator=(ForceObserver&&) noexcept;

  const CellProfile& profile() const noexcept;

  /// Uses this cell's own stiffness instead of the profile's, from the next frame on. Throws UsageError unless it is
  /// above 0 with a sigma of 0 or above.
  void set_scale(const CellScale& scale);

  /// Learns this cell's scale from measurements: for a push the model of this cell, as seen and held, at that depth,
  /// against the known value. They take effect from the next frame at or after `since_s` that shows the cell; none: the
  /// kind's scale. Throws UsageError as `way_of`, and for an aspiration without its modulus.
  void set_scale_measurements(std::vector<ScaleMeasurement> measurements);

  /// The risk of a further push into the cell seen last: depths `step_um`, 2 `step_um`, ... to 1.3 times the one at
  /// which its puncture is expected (`ExpectedPuncture`). Empty before a cell was seen. Leaves the model at rest: not
  /// to be called between two frames in contact. Throws UsageError unless the step is above 0.
  std::vector<PunctureRisk> puncture_risk(double step_um);

  /// The scale in use, and whether it was measured on this cell.
  CellScale scale() const noexcept;
  bool has_own_scale() const noexcept;

  /// State `free` gives a force of 0 and the shape at rest; `no_cell` and `lost` give nothing; `contact` gives the
  /// force at the observed indentation, or nothing with the reason when needle or numbers are missing. A puncture,
  /// tracked or not, gives 0 (`punctured`) once the membrane is seen to have left the tip; before, a tracked one counts
  /// as a contact (`puncture_doubted`).
  ///
  /// `known` (may be null): the equilibrium that an observer with the same profile but for its effective modulus found
  /// in the same frame, after the same frames before (`solved_shape`). It saves the solution, most of the time of a
  /// frame.
  ForceEstimate process(const Observation& observation, const SolvedShape* known = nullptr);

  /// The equilibrium of the last frame processed, for others; nothing where the needle pressed on nothing.
  std::shared_ptr<const SolvedShape> solved_shape() const;

  /// Forgets the cell.
  void reset();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
