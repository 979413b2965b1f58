#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "RobustSlope.h"
#include "pellucida/report/CellPassport.h"

namespace pellucida {

/// A row in contact with its force and depth. The interval's ends equal the force where none was given.
struct ForcePoint {
  std::size_t row = 0;
  double time_s = 0.0;
  double depth_um = 0.0;
  double force_uN = 0.0, lower_uN = 0.0, upper_uN = 0.0;
};

/// A work with its 95 % interval, pJ (1 uN um = 1e-12 J = 1 pJ).
struct WorkInterval {
  double value = 0.0, lower = 0.0, upper = 0.0;
};

/// Force over depth in one contact.
class ForceCurve {
 public:
  ForceCurve() = default;
  /// Of the rows in contact that have a force and a depth. `puncture`: the row that first shows one.
  ForceCurve(std::span<const Measurement> rows, const RowRange& range, std::optional<std::size_t> puncture);

  const std::vector<ForcePoint>& points() const noexcept { return points_; }
  bool empty() const noexcept { return points_.empty(); }
  /// How many points come before the puncture, without those in which the membrane was already on its way back; all of
  /// them without a puncture.
  std::size_t before_puncture() const noexcept { return before_puncture_; }

  /// The point of the largest force from `first` on, and that of the largest depth; before the puncture.
  std::size_t strongest(std::size_t first) const noexcept;
  std::size_t deepest() const noexcept;

  /// Integral of the force over the way from rest to point `last`, on the path that was taken (trapezoids).
  WorkInterval work_to(std::size_t last) const;
  /// Work on the whole way and back to rest: the area between insertion and removal.
  WorkInterval loop() const;

  /// Slope of the force over the depth on the way in, of the points within 2.5 um of `depth_um`. Nothing where the
  /// needle came no deeper than 1 um beyond, or there are too few points.
  std::optional<RobustSlope> stiffness_at(double depth_um) const;

 private:
  WorkInterval work(std::size_t last, bool back_to_rest) const;

  std::vector<ForcePoint> points_;
  std::size_t before_puncture_ = 0;
};

/// How much further than a depth the needle must have come for a stiffness there, um.
inline constexpr double kBeyondDepth_um = 1.0;

}  // namespace pellucida
