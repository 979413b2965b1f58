#pragma once
#include <cstdint>

#include "pellucida/evaluation/ContactCamera.h"
#include "pellucida/planning/InjectionPlan.h"
#include "pellucida/simulation/ModalityName.h"
#include "pellucida/simulation/Scenario.h"
#include "pellucida/simulation/SpecimenContact.h"

namespace pellucida {

class FieldList;  // core/FieldTable.h

/// One trial of a SIMULATED operator: what the modality provides, and what counts as success.
struct TrialOptions {
  Modality modality = Modality::kFlatImage;
  std::uint64_t seed = 1;  ///< of operator, cell, placement and noise; the same for all modalities of a pair

  double motion_scale_um_per_m = 1e4;  ///< 10 um of the tip for 1 mm of the hand
  double force_scale_N_per_uN = 0.05;  ///< with haptics: 0.4 N at the hand when a cell gives way at 7.5 uN
  bool slows_on_force = true;          ///< false: a felt force moves the arm, but doesn't slow the operator
  double approach_distance_um = 10.0;
  double guide_radius_um = 0.0;
  double guide_width_um = 0.5;
  double tolerance_um = 8.0;       ///< about a mouse pronucleus' radius
  double max_overshoot_um = 20.0;  ///< a third of the way on to the far membrane
  double least_deposit_ratio = 0.9;
  double time_limit_s = 30.0;
  ContactCameraOptions camera;  ///< its seed is the trial's
};

/// Its numbers, with meaning, unit and range, as "trial.NAME".
FieldList fields_of(TrialOptions& options);

/// The outcome. Numbers that were not reached are NaN.
struct TrialOutcome {
  Modality modality = Modality::kFlatImage;
  std::uint64_t seed = 0;

  bool punctured = false;
  bool deposited = false;  ///< enough of it, on average within the tolerance of the target
  bool removed = false;    ///< the operator has taken the tip out again, within the time
  bool success = false;    ///< all three, and the overshoot is within its limit

  double duration_s = 0.0;   ///< from the first picture until the tip is out; the limit where it never was
  double insertion_s = 0.0;  ///< from leaving the approach point until the deposit begins
  /// Root mean square of the tip's distance from the planned line, in 3-D, over the time of the insertion.
  double lateral_rms_um = 0.0;
  double lateral_max_um = 0.0;
  /// Fastest motion along the line that the hand commanded (tremor filter included; mean over 20 ms), from the first
  /// touch of the membrane until it gives way.
  double peak_approach_um_per_s = 0.0;
  double mean_approach_um_per_s = 0.0;        ///< of the true tip, along the line, in the same time
  double peak_after_puncture_um_per_s = 0.0;  ///< as the peak, from there until the deposit begins
  double peak_force_uN = 0.0;                 ///< of cell on needle, all directions
  double peak_hand_force_N = 0.0;             ///< written to the device
  double overshoot_um = 0.0;                  ///< deepest tip beyond the target, along the line
  double deposit_error_um = 0.0;              ///< mean distance of what was deposited from the target
  double deposited_pL = 0.0, lost_pL = 0.0;   ///< in the cell; elsewhere
  std::uint32_t limits = 0;                   ///< mask of `limit_bit(LimitKind)` that acted at any time
};

/// The cell of the trials, read once: each trial has its own seed, position and angle.
class TrialScene {
 public:
  /// Cell, tools and puncture of a scenario. Throws as VirtualSpecimen; UsageError where nothing can be punctured.
  explicit TrialScene(const Scenario& scenario = load_scenario("injection"));

  SpecimenContact cell(std::uint64_t seed) const;
  /// Of its kind, as a profile has it: without the spread from cell to cell.
  CellStrength strength() const;

 private:
  Scenario scenario_;
  SpecimenForce force_;
};

/// Straight through the cell's centre along the needle, as made by `plan_injection`; target: the centre. Throws
/// UsageError if there is no path.
InjectionPlan trial_plan(const TrialOptions& options, const SpecimenForce& cell);

/// One trial in simulated time, at 1 kHz: operator and arm -> HapticServo -> TeleoperationMap -> SimulatedInjector
/// (commands at 100 Hz) -> the cell of finite elements -> ContactCamera (30 Hz, 40 ms) -> servo and operator's eyes.
/// Without haptics the force scale is 0; the guide is there in the fourth modality alone, from the approach point on.
/// No thread, no wall clock: the same scene and options, the same outcome. Throws UsageError for options out of range.
TrialOutcome run_trial(const TrialScene& scene, const TrialOptions& options);

}  // namespace pellucida
