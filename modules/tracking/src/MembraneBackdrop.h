#pragma once
#include <Eigen/Core>
#include <vector>

#include "EdgeTemplate.h"

namespace pellucida {

/// The membrane's line about a needle's tip: by how much it changes the medium's light, so that a needle whose look was
/// learnt in plain medium is found against it. From the outline of the last frame and the line's learnt look.
class MembraneBackdrop {
 public:
  bool is_empty() const noexcept { return count_ == 0; }

  /// About `tip` (px). `outline`: (2 x n) px, closed, positive area, where it was; `shift`: how far it has gone since;
  /// `wrapped_px`: standard deviation of the bell, along the outline from the tip, over which it goes with the needle
  /// instead, 0 if it does not. The line: `edge`, its samples `step_px` apart; it is asked until the next `set`.
  void set(const Eigen::Matrix2Xd& outline, const EdgeTemplate& edge, double step_px, const Eigen::Vector2d& tip,
           const Eigen::Vector2d& shift, double wrapped_px);

  /// The needle has gone `way` (px) since, and has taken along what is wrapped about its tip.
  void push(const Eigen::Vector2d& way) noexcept;

  /// Brightness at `p`, over that of the medium; inside the cell that of the line's inner end.
  float at(const Eigen::Vector2d& p) const noexcept;

 private:
  struct Point {
    float x, y;                // px, now
    float was_x, was_y, goes;  // px, without the needle's motion, and its share of that
    float normal_x, normal_y;  // outwards
    int direction;             // of EdgeTemplate
  };
  const EdgeTemplate* edge_ = nullptr;
  std::vector<Point> points_;
  std::size_t count_ = 0;
  float step_px_ = 1.0F;
  Eigen::Vector2d shift_ = Eigen::Vector2d::Zero();
};

}  // namespace pellucida
