#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/core_vtk/FrameSource.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/haptics/CellStrength.h"
#include "pellucida/haptics/HapticRecord.h"
#include "pellucida/haptics/LimitEvent.h"
#include "pellucida/planning/InjectionPlan.h"
#include "pellucida/simulation/OperatorOptions.h"

namespace pellucida {

/// Options of a virtual microscope with a simulated operator at its needle.
struct SimulatedInjectionOptions {
  std::string scenario = "injection";  ///< by name or file
  OperatorOptions simulated_operator{.modality = Modality::kSpaceAndFixture};
  CellStrength cell;             ///< of the kind of cell, for the limits of force and depth
  std::uint64_t seed = 1;        ///< of the operator
  double vision_delay_s = 0.04;  ///< from a frame's exposure to its force at the hand
  double max_duration_s = 60.0;  ///< after this the operator gives up
};

/// Outcome of an injection: by the specimen itself, and by the hand.
struct InjectionOutcome {
  bool done = false;  ///< the operator completed the plan
  double duration_s = 0.0;
  double puncture_s = -1.0;        ///< below 0: the membrane never gave way
  double puncture_force_uN = 0.0;  ///< just before, truth
  double puncture_depth_um = 0.0;  ///< of the membrane, truth
  double deposited_pL = 0.0;       ///< inside the cell
  double lateral_rms_um =
      0.0;  ///< of the tip about the planned line, from the approach point on, until the deposit ended
  double peak_hand_force_N = 0.0;
};

/// The virtual microscope as a source of frames, with the simulated operator guiding its needle through plan, hand, 1
/// kHz step and injector, all in simulated time: a frame is there when the hand has worked up to its exposure. What the
/// frames were measured as comes by `see`, so that operator and hand know no more than in a live run. Deterministic
/// by its options as long as every frame is seen before the next is asked for. One thread at a time.
class SimulatedInjectionSource final : public FrameSource {
 public:
  /// Throws as load_scenario, SimulatedOperator and HapticServo do.
  explicit SimulatedInjectionSource(const SimulatedInjectionOptions& options);
  ~SimulatedInjectionSource() override;

  const SourceInfo& info() const noexcept override;
  /// The next frame; nothing once the operator is done or the time is over.
  std::optional<Frame> next() override;

  /// Takes a measured frame: the plan is made from the first good one.
  void see(const Scene& measured);

  /// Nothing before the cell has been seen.
  const std::optional<InjectionPlan>& plan() const noexcept;
  /// Ticks and limits of the hand since they were last taken; times are the session's.
  std::vector<HapticRecord> take_records();
  std::vector<LimitEvent> take_events();
  InjectionOutcome outcome() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
