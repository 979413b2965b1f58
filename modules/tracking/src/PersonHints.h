#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "CellDetector.h"
#include "PictureOrientation.h"
#include "pellucida/tracking/TrackingHints.h"

namespace pellucida {

/// What a person points at, in the order given: cell, tip and holder, each for one frame; what is no cell, until it is
/// taken back. Kept as it came, um of the camera's picture; handed out in px of the picture as it is laid.
class PersonHints {
 public:
  enum class Kind { kCell, kTip, kHolder, kNoCell };

  /// Each throws UsageError for a place that is not finite, an outline of fewer than 3 points, or neither.
  void add_cell(const CellHint& hint);
  void add_tip(const Eigen::Vector2d& tip_um);
  void add_holder(const Eigen::Vector2d& place_um);
  void add_no_cell(const Eigen::Vector2d& place_um);
  /// Takes the last one back and says what it was; nothing where there is none.
  std::optional<Kind> take_back();

  /// A cell was pointed at that has not been looked for.
  bool has_cell() const noexcept { return cell_.has_value(); }
  std::optional<DetectionHint> take_cell(const PictureOrientation& laid, double pixel_size_um);
  std::optional<Eigen::Vector2d> take_tip(const PictureOrientation& laid, double pixel_size_um);
  std::optional<Eigen::Vector2d> take_holder(const PictureOrientation& laid, double pixel_size_um);

  /// Whether a person called it no cell.
  bool is_no_cell(const PictureOrientation& laid, double pixel_size_um, const contour::Circle& circle) const;
  /// Two hints about one place: the later one, that there is a cell, counts.
  void forget_no_cell(const PictureOrientation& laid, double pixel_size_um, const contour::Circle& cell);

 private:
  struct Given {
    Kind kind;
    Eigen::Vector2d place_um;
  };
  std::optional<CellHint> cell_;
  std::optional<Eigen::Vector2d> tip_um_, holder_um_;
  std::vector<Given> given_;
};

}  // namespace pellucida
