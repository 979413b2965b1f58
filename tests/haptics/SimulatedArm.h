#pragma once
#include <Eigen/Core>

#include "pellucida/haptics/HapticDevice.h"

namespace pellucida::test {

/// A person's arm on a device, in each axis a mass on a spring and a damper to where the person means to be, which the
/// device's force pulls away:
///     m x'' = k (intent - x) - (b_arm + b_device) x' + F
/// Orders of magnitude of a hand that grips a stylus: 0.1 .. 1 kg, some N s/m, some hundred N/m.
struct ArmOptions {
  double mass_kg = 0.3;
  double damping_N_s_per_m = 5.0;
  double stiffness_N_per_m = 300.0;
};

/// The device of such an arm: what is written acts until the next write.
class SimulatedArm final : public HapticDevice {
 public:
  SimulatedArm(DeviceSpecification specification, const ArmOptions& arm);

  const DeviceSpecification& specification() const noexcept override { return specification_; }
  bool read(double now_s, HandSample& sample) noexcept override;
  bool write(const PlainVector3& force_N) noexcept override;

  /// Time goes on by `dt_s`, the force of the last write held.
  void advance(double dt_s) noexcept;

  // What the person and the test's faults do.
  Eigen::Vector3d intent_m = Eigen::Vector3d::Zero();
  std::uint32_t buttons = 0;
  bool lost = false;
  bool says_nan = false;
  Eigen::Vector3d jump_m = Eigen::Vector3d::Zero();  ///< added to what is read

  const Eigen::Vector3d& position_m() const noexcept { return position_m_; }
  const Eigen::Vector3d& force_N() const noexcept { return force_N_; }

 private:
  DeviceSpecification specification_;
  ArmOptions arm_;
  double damping_;
  Eigen::Vector3d position_m_ = Eigen::Vector3d::Zero(), velocity_m_per_s_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d force_N_ = Eigen::Vector3d::Zero();
};

}  // namespace pellucida::test
