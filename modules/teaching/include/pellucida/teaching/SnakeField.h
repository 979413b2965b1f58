#pragma once
#include <Eigen/Core>

namespace pellucida {

/// What an image is to a snake: an energy at every pixel, least where the snake is drawn to. Place (x, y) px, the
/// origin at the centre of the top left pixel, y down; between pixels bilinear, beyond the border the border's.
class SnakeField {
 public:
  SnakeField() = default;
  /// `energy` (height x width), each at least 2 pixels. Its scale is the caller's: -1 at the strongest edge by
  /// convention (`snake_field`).
  explicit SnakeField(Eigen::ArrayXXd energy);

  bool empty() const noexcept { return energy_.size() == 0; }
  double width_px() const noexcept { return static_cast<double>(energy_.cols()); }
  double height_px() const noexcept { return static_cast<double>(energy_.rows()); }
  double energy_at(const Eigen::Vector2d& place_px) const { return sample(energy_, place_px); }
  /// Minus the gradient, per px.
  Eigen::Vector2d force_at(const Eigen::Vector2d& place_px) const {
    return {-sample(along_x_, place_px), -sample(along_y_, place_px)};
  }

 private:
  static double sample(const Eigen::ArrayXXd& values, const Eigen::Vector2d& place_px);

  Eigen::ArrayXXd energy_, along_x_, along_y_;
};

}  // namespace pellucida
