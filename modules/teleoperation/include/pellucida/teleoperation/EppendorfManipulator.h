#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "pellucida/teleoperation/EppendorfLine.h"
#include "pellucida/teleoperation/Manipulator.h"

namespace pellucida {

struct EppendorfOptions {
  std::string port;  ///< "/dev/ttyUSB0"

  /// Columns are the device's axes (x right, y backwards, z down) in frame W; the default is an upright image of the
  /// bench. Axes not at right angles to each other, as on a slanted drive, belong here.
  std::array<PlainVector3, 3> axes{PlainVector3{1.0, 0.0, 0.0}, PlainVector3{0.0, -1.0, 0.0},
                                   PlainVector3{0.0, 0.0, 1.0}};

  /// The protocol moves in whole um, or in microsteps, whose size it does not state. Above 0: microsteps are used.
  double microsteps_per_um = 0.0;

  double max_speed_um_per_s = 2000.0;
  double travel_um = 10000.0;         ///< each way from the device's own zero; its limit switches act as well
  double answer_timeout_s = 0.3;      ///< for an answer that arrives at once
  double standstill_timeout_s = 5.0;  ///< for one that arrives when all motors have stopped
};

/// Eppendorf PatchMan NP 2 and compatible devices, over a serial port. They do not inject.
///
/// A motion is sent as soon as target or speed change, with speeds divided among the axes so that the tip moves
/// straight. A device that does not answer (EppendorfLine) is closed.
class EppendorfManipulator final : public Manipulator {
 public:
  /// Throws UsageError for numbers out of range and for axes that do not span space.
  explicit EppendorfManipulator(const EppendorfOptions& options);
  ~EppendorfManipulator() override;

  void open() override;
  void close() noexcept override;
  bool is_open() const noexcept override { return line_ != nullptr; }
  const ManipulatorSpecification& specification() const noexcept override { return specification_; }
  void command(const PipetteCommand& command, double now_s) override;
  PipetteState state(double now_s) override;

  /// States that the tip is now at `tip_um` of frame W (where the tracker sees it). Device open.
  void register_tip(const PlainVector3& tip_um);

  /// "5181 V1.04", after `open`.
  const std::string& version() const noexcept { return version_; }

  /// Lines received that were not the expected answer, since `open`.
  std::uint64_t stray_line_count() const noexcept { return line_ ? line_->stray_line_count() : 0; }

 private:
  void ask(EppendorfCode code, const std::string& command, double timeout_s);
  Eigen::Vector3d ask_position();
  void halt();
  void move(const Eigen::Vector3d& target, double speed_um_per_s);
  void demand_open() const;
  void place_travel();

  EppendorfOptions options_;
  ManipulatorSpecification specification_;
  Eigen::Matrix3d world_from_device_;                    ///< of directions
  Eigen::Vector3d origin_um_ = Eigen::Vector3d::Zero();  ///< of the device, in frame W
  double units_per_um_ = 1.0;

  std::unique_ptr<EppendorfLine> line_;
  std::string version_;

  Eigen::Vector3d position_ = Eigen::Vector3d::Zero();  ///< the device's own units
  std::array<long, 3> sent_position_{};
  double sent_speed_um_per_s_ = 0.0;
  bool sent_ = false;  ///< a motion is in force
  bool at_switch_ = false, clamped_ = false, stopped_ = false, polled_ = false;
  double polled_s_ = 0.0;
};

}  // namespace pellucida
