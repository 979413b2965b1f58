#pragma once
#include <optional>
#include <string>
#include <type_traits>

#include "pellucida/haptics/CellGuards.h"
#include "pellucida/haptics/ContactPredictor.h"
#include "pellucida/haptics/Fixtures.h"
#include "pellucida/haptics/ScalingCheck.h"
#include "pellucida/haptics/VirtualCoupling.h"

namespace pellucida {

class FieldList;  // core/FieldTable.h

/// All settings that may be changed while the hand works. Trivially copyable: it goes through `LatestValue`.
struct HapticSettings {
  double force_scale_N_per_uN = 0.0;  ///< hand force per force at the cell; 0: the contact is not felt
  CellStrength cell;                  ///< largest demands of the cell, for the check of the scale
  PredictorSettings predictor;
  CouplingSettings coupling;
  CellLimits limits;
  FixtureSet fixtures;

  double period_s = 1e-3;            ///< of the loop
  double low_pass_Hz = 600.0;        ///< of the force on the hand
  double full_scale_time_s = 0.004;  ///< shortest time in which the force may change by the device's largest
  double fade_in_time_s = 0.1;       ///< fade-in of the force when the hand engages
  double clutch_time_s = 0.03;       ///< fade-out when the hand disengages
  double release_time_s = 0.005;     ///< fade-out on an emergency stop or a loss
};
static_assert(std::is_trivially_copyable_v<HapticSettings>);

/// Settings for a device, a motion scale and a kind of cell that can be used as they are: four fifths of the largest
/// force scale the device can render for that cell, the cell's limits of force and depth, link and fixtures at half the
/// device's largest stiffness, no fixture enabled.
HapticSettings default_settings(const DeviceSpecification& device, double motion_scale_um_per_m,
                                const CellStrength& cell = {});

/// The numbers of the settings, with meaning, unit and range; docs/developer/hand-settings.md is printed from them.
FieldList fields_of(HapticSettings& settings);

/// Why the device can't use these settings at that motion scale: a number out of range, or the text of the refused
/// scaling with the nearest accepted one. Nothing when they are valid.
std::optional<std::string> fault_of(const HapticSettings& settings, const DeviceSpecification& device,
                                    double motion_scale_um_per_m);

}  // namespace pellucida
