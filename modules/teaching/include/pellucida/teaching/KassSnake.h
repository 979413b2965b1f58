#pragma once
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <memory>
#include <string>

#include "pellucida/core/FieldTable.h"
#include "pellucida/teaching/SnakeField.h"

namespace pellucida {

/// What an instructor turns on a snake. Energies are measured by that of the image: 1 is a point on its strongest edge.
struct SnakeParameters {
  double alpha = 0.05;   ///< of stretching, per px^2
  double beta = 0.1;     ///< of bending, per px^2
  double gamma = 0.3;    ///< viscosity: how little a step moves, per px^2
  double balloon = 0.1;  ///< outward push on each point, per px; below 0 inward
  double blur_px = 1.0;  ///< of the image, standard deviation
  std::string attraction = "dark-lines";
};

/// Keys, units and ranges; sliders and lessons' files follow from them.
FieldList fields_of(SnakeParameters& parameters);
/// Throws UsageError for a number out of its range or an unknown attraction, with what is allowed.
void require_valid(const SnakeParameters& parameters);

/// What the image draws a snake to.
enum class SnakeAttraction { kDarkLines, kEdges };
/// Throws UsageError that lists the names.
SnakeAttraction snake_attraction(const std::string& name);

/// The parts of a snake's energy.
struct SnakeEnergy {
  double stretching = 0.0;  ///< alpha / 2 sum |x_i+1 - x_i|^2
  double bending = 0.0;     ///< beta / 2 sum |x_i-1 - 2 x_i + x_i+1|^2
  double image = 0.0;       ///< sum of the field at the points
  double balloon = 0.0;     ///< -balloon n (r - r0), r = sqrt(area / pi), r0 at the start: a push on each point

  double internal() const noexcept { return stretching + bending; }
  double external() const noexcept { return image + balloon; }
  double total() const noexcept { return internal() + external(); }
};

enum class SnakeState {
  kMoving,
  kConverged,    ///< no point moved by more than `KassSnake::kStill_px` in the last step
  kLeftPicture,  ///< a point has reached the border
  kCollapsed,    ///< nothing is left inside
};

/// The classic snake of Kass, Witkin and Terzopoulos (1988), closed, one step at a time:
///
///   (A + gamma I) x(t+1) = gamma x(t) + f(x(t)),  A = alpha D1'D1 + beta D2'D2,  f = -grad (image + balloon)
///
/// implicit in the internal energy, explicit in the external one. `kPointCount` points; the system is factorised once
/// for each set of parameters. A snake that left the picture or collapsed stays until it is started again.
class KassSnake {
 public:
  static constexpr int kPointCount = 120;
  static constexpr double kStill_px = 0.01;

  /// Throws UsageError for parameters that are not valid.
  explicit KassSnake(const SnakeParameters& parameters = {});

  /// The snake stays where it is. `field` must not be null.
  void set_field(std::shared_ptr<const SnakeField> field);
  /// Likewise. Throws UsageError and changes nothing for parameters that are not valid.
  void set_parameters(const SnakeParameters& parameters);
  const SnakeParameters& parameters() const noexcept { return parameters_; }

  /// Begins anew on a circle, held within the picture.
  void start(const Eigen::Vector2d& center_px, double radius_px);
  /// One step. False, without one, where there is no picture or the snake was lost.
  bool step();

  /// (2 x n), px, closed.
  const Eigen::Matrix2Xd& points_px() const noexcept { return points_; }
  SnakeState state() const noexcept { return state_; }
  int iteration() const noexcept { return iteration_; }
  /// The farthest way of a point in the last step.
  double largest_motion_px() const noexcept { return motion_px_; }
  SnakeEnergy energy() const;
  /// Minus the gradient of the external energy, (2 x n); that of the internal one.
  Eigen::Matrix2Xd external_force() const;
  Eigen::Matrix2Xd internal_force() const;

 private:
  void hold_in_picture();

  SnakeParameters parameters_;
  std::shared_ptr<const SnakeField> field_;
  Eigen::MatrixXd stiffness_;  // A
  Eigen::LLT<Eigen::MatrixXd> solver_;
  Eigen::Matrix2Xd points_;
  SnakeState state_ = SnakeState::kMoving;
  double start_radius_px_ = 0.0;
  int iteration_ = 0;
  double motion_px_ = 0.0;
};

/// Half the shoelace sum, px^2: above 0 where x turns towards y.
double enclosed_area_px2(const Eigen::Matrix2Xd& points);

}  // namespace pellucida
