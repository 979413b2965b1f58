#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "pellucida/teleoperation/Manipulator.h"

namespace pellucida {

/// The properties of a motorised three-axis micromanipulator with an injector that matter to control.
struct SimulatedInjectorOptions {
  PlainVector3 start_um;                             ///< position of the tip when first opened
  PlainVector3 lower_um{-2000.0, -2000.0, -2000.0};  ///< travel limits
  PlainVector3 upper_um{2000.0, 2000.0, 2000.0};
  double max_speed_um_per_s = 2000.0;
  double max_acceleration_um_per_s2 = 20000.0;
  double backlash_um = 0.5;     ///< width of the play of each axis
  double resolution_um = 0.04;  ///< step of each axis: targets and reports are rounded to it
  double latency_s = 0.01;      ///< from a command's arrival to the first motion
  double deposit_rate_pl_per_s = 5.0;
};

/// The true position of the tip; the report of a manipulator contains the backlash.
struct InjectorPose {
  double time_s = 0.0;
  PlainVector3 tip_um;
  double deposited_pl = 0.0;  ///< since first opened
};

/// A micromanipulator without hardware, exact and repeatable: travel limits, limited speed and acceleration, latency,
/// steps, backlash between the motor (which is what it reports) and the tip (which is what the microscope sees).
///
/// Each axis runs towards its target as fast as speed, acceleration and the braking speed sqrt(2 a d) allow; the speed
/// limit applies to the magnitude of the three. An emergency stop acts without latency and at once.
class SimulatedInjector final : public Manipulator {
 public:
  /// Called after every advance, on the calling thread: moves the virtual microscope's needle.
  using Follower = std::function<void(const InjectorPose&)>;

  /// Throws UsageError for limits upside down, a start outside them, or a speed, acceleration or step out of range.
  explicit SimulatedInjector(const SimulatedInjectorOptions& options = {}, Follower follower = {});

  void open() override;
  void close() noexcept override;
  bool is_open() const noexcept override { return open_; }
  const ManipulatorSpecification& specification() const noexcept override { return specification_; }
  void command(const PipetteCommand& command, double now_s) override;
  PipetteState state(double now_s) override;

  /// Advances time by `dt_s`, in steps of at most a millisecond, as `command` and `state` do with the time since the
  /// last call. For tests and simulated time.
  void advance(double dt_s);

  const InjectorPose& pose() const noexcept { return pose_; }

 private:
  struct Waiting {
    double due_s;
    PipetteCommand command;
  };

  void follow_time(double now_s);
  void take_due_commands();
  void hold();
  void step(double dt_s);

  SimulatedInjectorOptions options_;
  ManipulatorSpecification specification_;
  Follower follower_;
  std::vector<Waiting> waiting_;  ///< commands under way, oldest first
  Eigen::Vector3d motor_um_;
  Eigen::Vector3d target_um_;
  Eigen::Vector3d velocity_um_per_s_ = Eigen::Vector3d::Zero();
  double speed_limit_um_per_s_ = 0.0;
  double time_s_ = 0.0;
  bool time_known_ = false;
  bool open_ = false;
  bool injecting_ = false;
  bool stopped_ = false;
  bool target_clamped_ = false;
  InjectorPose pose_;
};

}  // namespace pellucida
