#pragma once
#include <deque>
#include <limits>
#include <memory>
#include <vector>

#include "haptics/SimulatedArm.h"
#include "pellucida/haptics/HapticServo.h"

namespace pellucida::test {

/// Hand to tip by a fixed scale; with the clutch held it does not move.
class DirectMap final : public MotionMap {
 public:
  explicit DirectMap(double scale_um_per_m) : scale_(scale_um_per_m) {}
  void engage(const HandSample& hand, const PlainVector3& tip_um) noexcept override;
  TipTarget update(const HandSample& hand, double dt_s) noexcept override;
  double scale_um_per_m() const noexcept override { return scale_; }

 private:
  double scale_;
  Eigen::Vector3d hand_m_ = Eigen::Vector3d::Zero(), tip_um_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d last_um_ = Eigen::Vector3d::Zero();
};

/// A cell that is touched by a tip going along +x: a force that grows with the third power of depth, 7.5 uN at 44 um
/// and 0.51 uN/um there, as the oocyte's. It may give way.
struct CubicCell {
  double contact_x_um = 100.0;
  double force_uN = 7.5;
  double at_depth_um = 44.0;
  double puncture_depth_um = std::numeric_limits<double>::infinity();
  bool punctured = false;

  double depth_um(double tip_x_um) const { return tip_x_um > contact_x_um ? tip_x_um - contact_x_um : 0.0; }
  double force_at(double depth) const;
  double stiffness_at(double depth) const;
};

/// What a camera that looks at the cell reports: frames of 30 a second that arrive late, and its faults.
struct CameraOptions {
  double frames_per_s = 30.0;
  double latency_s = 0.02;
  double pipette_lag_s = 0.01;  ///< time constant with which the pipette follows its command
};

/// Hand, servo, pipette, cell and camera on a clock of their own: one call a tick. Everything is deterministic.
class HandRun {
 public:
  HandRun(const DeviceSpecification& device, const HapticSettings& settings, double scale_um_per_m,
          const ArmOptions& arm = {}, const CameraOptions& camera = {});
  HandRun(const DeviceSpecification& device, const HapticSettings& settings, std::unique_ptr<MotionMap> map,
          const ArmOptions& arm = {}, const CameraOptions& camera = {});

  /// One tick after `dt_s`; the record of it.
  HapticRecord tick(double dt_s = 1e-3);
  /// Ticks for that long; all records.
  std::vector<HapticRecord> run(double seconds);

  /// Another hand takes the pipette where it is: a servo of its own, on the same cell and camera.
  void change_hand();

  double now_s() const { return now_s_; }
  std::vector<LimitEvent> events();

  SimulatedArm arm;
  CubicCell cell;
  bool camera_stalled = false;
  bool camera_says_nan = false;
  bool pipette_lost = false;
  double stiffness_error_ratio = 1.0;  ///< the stiffness reported over the true one
  HapticServo& servo() { return *servo_; }
  const PipetteCommand& command() const { return last_command_; }
  double pipette_x_um() const { return pipette_um_.x(); }

 private:
  struct Waiting {
    double due_s;
    ContactModel model;
  };
  HapticPorts ports() { return {contact_, pipette_, command_}; }
  void film();
  ContactModel look() const;

  CameraOptions camera_;
  std::unique_ptr<MotionMap> map_;
  LatestValue<ContactModel> contact_;
  LatestValue<PipetteState> pipette_;
  LatestValue<PipetteCommand> command_;
  HapticSettings settings_;
  std::unique_ptr<HapticServo> servo_;
  PipetteCommand last_command_;
  Eigen::Vector3d pipette_um_ = Eigen::Vector3d::Zero();
  std::deque<Waiting> under_way_;
  double now_s_ = 0.0, next_frame_s_ = 0.0;
  long frame_index_ = 0;
};

/// Largest change of the force from one record to the next, N.
double largest_force_step_N(const std::vector<HapticRecord>& records);
/// Largest way of the commanded tip from one record to the next, um.
double largest_tip_step_um(const std::vector<HapticRecord>& records);

}  // namespace pellucida::test
