#include "pellucida/teaching/KassSnake.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

using S = SnakeParameters;
constexpr Field<S> kSnakeParameters[] = {
    {"alpha", "1/px^2", &S::alpha, {1e-3, 10}, "of stretching: draws the snake together"},
    {"beta", "1/px^2", &S::beta, {1e-3, 1000}, "of bending: keeps it smooth"},
    {"gamma", "1/px^2", &S::gamma, {0.02, 10}, "viscosity: the larger, the shorter the steps"},
    {"balloon", "1/px", &S::balloon, {-0.3, 0.3}, "outward push on each point; below 0 inward"},
    {"blur_px", "px", &S::blur_px, {0.5, 8}, "of the image, standard deviation"},
    {"attraction", "", &S::attraction, {}, "what draws it: `dark-lines` or `edges`"},
};

// Smaller than this, nothing of a cell is left inside.
constexpr double kLeastRadius_px = 3.0;

Eigen::Index after(Eigen::Index i, Eigen::Index n) {
  return i + 1 == n ? 0 : i + 1;
}

/// Differences of points along a closed line, (n x n): first and second.
Eigen::MatrixXd first_difference(Eigen::Index n) {
  Eigen::MatrixXd d = -Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i) d(i, after(i, n)) = 1.0;
  return d;
}
Eigen::MatrixXd second_difference(Eigen::Index n) {
  return -first_difference(n).transpose() * first_difference(n);
}

double radius_of_area_px(const Eigen::Matrix2Xd& points) {
  return std::sqrt(std::max(0.0, enclosed_area_px2(points)) / std::numbers::pi);
}

}  // namespace

FieldList fields_of(SnakeParameters& parameters) {
  FieldList list;
  list.add("", kSnakeParameters, parameters);
  return list;
}

SnakeAttraction snake_attraction(const std::string& name) {
  if (name == "dark-lines") return SnakeAttraction::kDarkLines;
  if (name == "edges") return SnakeAttraction::kEdges;
  throw UsageError("attraction " + name + ": not known; known are dark-lines, edges");
}

void require_valid(const SnakeParameters& parameters) {
  SnakeParameters copy = parameters;
  if (const auto fault = range_fault(fields_of(copy))) throw UsageError(*fault);
  snake_attraction(parameters.attraction);
}

double enclosed_area_px2(const Eigen::Matrix2Xd& points) {
  double twice = 0.0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Index next = after(i, points.cols());
    twice += points(0, i) * points(1, next) - points(0, next) * points(1, i);
  }
  return 0.5 * twice;
}

KassSnake::KassSnake(const SnakeParameters& parameters) : points_(Eigen::Matrix2Xd::Zero(2, kPointCount)) {
  set_parameters(parameters);
}

void KassSnake::set_parameters(const SnakeParameters& parameters) {
  require_valid(parameters);
  parameters_ = parameters;
  const Eigen::MatrixXd first = first_difference(kPointCount), second = second_difference(kPointCount);
  stiffness_ = parameters_.alpha * first.transpose() * first + parameters_.beta * second.transpose() * second;
  solver_.compute(stiffness_ + parameters_.gamma * Eigen::MatrixXd::Identity(kPointCount, kPointCount));
  if (state_ == SnakeState::kConverged) state_ = SnakeState::kMoving;
}

void KassSnake::set_field(std::shared_ptr<const SnakeField> field) {
  field_ = std::move(field);
  if (state_ == SnakeState::kConverged) state_ = SnakeState::kMoving;
}

void KassSnake::start(const Eigen::Vector2d& center_px, double radius_px) {
  for (int i = 0; i < kPointCount; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / kPointCount;
    points_.col(i) = center_px + radius_px * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad));
  }
  state_ = SnakeState::kMoving;
  iteration_ = 0;
  motion_px_ = 0.0;
  // A circle across the border begins on it.
  if (field_ && !field_->empty()) hold_in_picture();
  start_radius_px_ = radius_of_area_px(points_);
  state_ = SnakeState::kMoving;
}

void KassSnake::hold_in_picture() {
  const Eigen::Vector2d last(field_->width_px() - 1.0, field_->height_px() - 1.0);
  for (Eigen::Index i = 0; i < points_.cols(); ++i) {
    const Eigen::Vector2d held = points_.col(i).cwiseMax(Eigen::Vector2d::Zero()).cwiseMin(last);
    if (held != points_.col(i)) state_ = SnakeState::kLeftPicture;
    points_.col(i) = held;
  }
}

bool KassSnake::step() {
  if (!field_ || field_->empty()) return false;
  if (state_ == SnakeState::kLeftPicture || state_ == SnakeState::kCollapsed) return false;
  const Eigen::Matrix2Xd before = points_;
  const Eigen::MatrixXd right = (parameters_.gamma * points_ + external_force()).transpose();
  points_ = solver_.solve(right).transpose();
  motion_px_ = (points_ - before).colwise().norm().maxCoeff();
  ++iteration_;
  state_ = motion_px_ < kStill_px ? SnakeState::kConverged : SnakeState::kMoving;
  if (radius_of_area_px(points_) < kLeastRadius_px) state_ = SnakeState::kCollapsed;
  hold_in_picture();
  return true;
}

SnakeEnergy KassSnake::energy() const {
  SnakeEnergy energy;
  for (Eigen::Index i = 0; i < points_.cols(); ++i) {
    const Eigen::Index next = after(i, points_.cols()), second = after(next, points_.cols());
    energy.stretching += 0.5 * parameters_.alpha * (points_.col(next) - points_.col(i)).squaredNorm();
    energy.bending +=
        0.5 * parameters_.beta * (points_.col(i) - 2.0 * points_.col(next) + points_.col(second)).squaredNorm();
    if (field_) energy.image += field_->energy_at(points_.col(i));
  }
  energy.balloon = -parameters_.balloon * kPointCount * (radius_of_area_px(points_) - start_radius_px_);
  return energy;
}

Eigen::Matrix2Xd KassSnake::internal_force() const {
  return -points_ * stiffness_;
}

Eigen::Matrix2Xd KassSnake::external_force() const {
  const Eigen::Index n = points_.cols();
  Eigen::Matrix2Xd force = Eigen::Matrix2Xd::Zero(2, n);
  // d sqrt(A / pi) = dA / (2 sqrt(pi A)), dA / dx_i = (y_i+1 - y_i-1) / 2.
  const double radius_px = std::max(radius_of_area_px(points_), 1.0);
  const double push = parameters_.balloon * kPointCount / (2.0 * std::numbers::pi * radius_px);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d along = points_.col(after(i, n)) - points_.col(i == 0 ? n - 1 : i - 1);
    force.col(i) = 0.5 * push * Eigen::Vector2d(along.y(), -along.x());
    if (field_) force.col(i) += field_->force_at(points_.col(i));
  }
  return force;
}

}  // namespace pellucida
