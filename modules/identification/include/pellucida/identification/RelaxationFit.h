#pragma once
#include <Eigen/Core>
#include <vector>

#include "pellucida/identification/RelaxationRecord.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/membrane/Relaxation.h"

namespace pellucida {

/// A ramp-and-hold record described by a spring and Maxwell arms: the elastic force is Fe = a1 u + a2 u^2 + a3 u^3, u
/// the depth below the contact point over the record's largest, and the force is Relaxation applied to it. Fitted
/// together: a1, a2, a3, the contact point, each arm's fraction and time.
struct RelaxationFit {
  std::vector<RelaxationArm> arms;                       ///< the fastest first
  double contact_height_um = 0.0;                        ///< where the probe met the cell
  Eigen::Vector3d elastic_uN = Eigen::Vector3d::Zero();  ///< a1, a2, a3
  Eigen::VectorXd force_uN;                              ///< (n) of the fit, at the record's samples
  double hold_rms_uN = 0.0;                              ///< root mean square of record minus fit over the hold
  double ramp_rms_uN = 0.0;                              ///< over the ramp
  double ramp_and_hold_rms_uN = 0.0;                     ///< over both, each sample counting the same
};

/// Fits 1 to 3 arms by least squares (Ceres); ramp and hold have equal weight, whatever their number of samples. Throws
/// UsageError for another number of arms, NothingMeasuredError when the record holds no push: a force that never rises
/// above the noise, or a height that doesn't fall.
RelaxationFit fit_relaxation(const RelaxationRecord& record, int arm_count = 2);

/// Speed of a record's ramp, um/s.
double ramp_speed_um_per_s(const RelaxationRecord& record);

/// Adds these arms to a profile whose force scale is anchored. The scale is that of a steady push to the puncture
/// indentation within `anchor_ramp_s` >= 0 (0: a sudden one), during which the arms already relax, so that a sudden
/// push takes more force: Fe(d) / integral of G(T - s) dFe(s), Fe the model's force-indentation curve in configuration
/// 1. Throws UsageError for another time or arms.
void apply_relaxation(const std::vector<RelaxationArm>& arms, double anchor_ramp_s, CellProfile& profile);

}  // namespace pellucida
