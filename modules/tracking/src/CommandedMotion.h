#pragma once
#include <Eigen/Core>
#include <optional>

namespace pellucida {

/// Where a manipulator's commands put the needle's tip along the needle, px, held against what the film shows. Scale
/// and axes of the commands and a steady drift of the scene are learnt from the film (a Kalman filter of four numbers);
/// nothing is believed before the tip has been seen to go where it was sent. Then a tip that seems to go back although
/// nothing of the kind was commanded is misread: as a membrane gives way, what is read as the needle's end goes back
/// with it. A tip that merely lags behind is believed: steps may be missed and gears have play.
/// Allocates nothing.
class CommandedMotion {
 public:
  /// How far ahead of another a place lies along the needle, with its standard deviation, px.
  struct Along {
    double ahead_px = 0.0, sigma_px = 0.0;
  };

  /// The next frame: what was commanded since the one before, px; nothing: unknown. First of a frame's calls.
  void begin(const std::optional<Eigen::Vector2d>& commanded_px);
  /// The whole scene, needle and all, moved by this since the frame before, as far as that is known.
  void move_scene(const Eigen::Vector2d& way_px);

  /// Where the tip is due in this frame, ahead of `tip`; nothing while that isn't known, or not believed.
  std::optional<Along> due(const Eigen::Vector2d& tip) const;

  /// Whether a tip read at `tip` (standard deviation `sigma_px`) can't have got there: far behind where it is due, and
  /// gone back from where it was last seen by more than was commanded.
  bool contradicts(const Eigen::Vector2d& tip, double sigma_px) const;

  /// The tip of a needle that points in `direction` was seen at `tip`. `is_new`: it was found in this frame.
  void learn(const Eigen::Vector2d& tip, const Eigen::Vector2d& direction, double sigma_px, bool is_new);
  /// This frame's tip was misread, as `contradicts` said. After ten such frames in a row the next reading is believed.
  void misread() noexcept { ++misread_; }

 private:
  bool is_believed() const;
  void start(const Eigen::Vector2d& tip, const Eigen::Vector2d& direction, double sigma_px);

  Eigen::Vector2d direction_ = Eigen::Vector2d::UnitX();
  // Place along `direction_`, its change per commanded px along x and y, drift a frame; and their covariance.
  Eigen::Vector4d state_ = Eigen::Vector4d::Zero();
  Eigen::Matrix4d covariance_ = Eigen::Matrix4d::Zero();
  Eigen::Vector2d command_ = Eigen::Vector2d::Zero();  // in this frame
  Eigen::Vector2d heading_ = Eigen::Vector2d::Zero();  // of the last command that moved anything
  double way_px_ = 0.0;                                // that all commands so far made along the needle
  double excess_ = 1.0;                                // of squared surprises over what was expected, of late
  // Where it was last seen, less all that was commanded back since; and the most of one frame of late.
  double least_px_ = 0.0, back_px_ = 0.0;
  int learnt_ = 0, settled_ = 0, misread_ = 0;  // frames: ever, since it was found, in a row
  bool has_place_ = false;
};

}  // namespace pellucida
