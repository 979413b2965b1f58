#include "PersonHints.h"

#include <algorithm>
#include <utility>

#include "TrackerChecks.h"

namespace pellucida {
namespace {

// A place that counts once, px of the picture as it is laid.
std::optional<Eigen::Vector2d> take(std::optional<Eigen::Vector2d>& place_um, const PictureOrientation& laid,
                                    double pixel_size_um) {
  if (!place_um) return std::nullopt;
  return laid.laid_point(*std::exchange(place_um, std::nullopt)) / pixel_size_um;
}

}  // namespace

void PersonHints::add_cell(const CellHint& hint) {
  check(hint);
  cell_ = hint;
  given_.push_back({Kind::kCell, {0.0, 0.0}});
}

void PersonHints::add_tip(const Eigen::Vector2d& tip_um) {
  check_place(tip_um);
  tip_um_ = tip_um;
  given_.push_back({Kind::kTip, tip_um});
}

void PersonHints::add_holder(const Eigen::Vector2d& place_um) {
  check_place(place_um);
  holder_um_ = place_um;
  given_.push_back({Kind::kHolder, place_um});
}

void PersonHints::add_no_cell(const Eigen::Vector2d& place_um) {
  check_place(place_um);
  given_.push_back({Kind::kNoCell, place_um});
}

std::optional<PersonHints::Kind> PersonHints::take_back() {
  if (given_.empty()) return std::nullopt;
  const Kind kind = given_.back().kind;
  given_.pop_back();
  if (kind == Kind::kTip)
    tip_um_.reset();
  else if (kind == Kind::kHolder)
    holder_um_.reset();
  else
    cell_.reset();
  return kind;
}

std::optional<DetectionHint> PersonHints::take_cell(const PictureOrientation& laid, double pixel_size_um) {
  if (!cell_) return std::nullopt;
  DetectionHint hint;
  if (cell_->outline_um) {
    hint.outline = laid.laid_points(*cell_->outline_um) / pixel_size_um;
    hint.inside = hint.outline.rowwise().mean();
  }
  if (cell_->inside_um) hint.inside = laid.laid_point(*cell_->inside_um) / pixel_size_um;
  cell_.reset();
  return hint;
}

std::optional<Eigen::Vector2d> PersonHints::take_tip(const PictureOrientation& laid, double pixel_size_um) {
  return take(tip_um_, laid, pixel_size_um);
}

std::optional<Eigen::Vector2d> PersonHints::take_holder(const PictureOrientation& laid, double pixel_size_um) {
  return take(holder_um_, laid, pixel_size_um);
}

bool PersonHints::is_no_cell(const PictureOrientation& laid, double pixel_size_um,
                             const contour::Circle& circle) const {
  return std::any_of(given_.begin(), given_.end(), [&](const Given& hint) {
    return hint.kind == Kind::kNoCell &&
           (laid.laid_point(hint.place_um) / pixel_size_um - circle.center).norm() < circle.radius;
  });
}

void PersonHints::forget_no_cell(const PictureOrientation& laid, double pixel_size_um, const contour::Circle& cell) {
  std::erase_if(given_, [&](const Given& hint) {
    return hint.kind == Kind::kNoCell &&
           (laid.laid_point(hint.place_um) / pixel_size_um - cell.center).norm() < cell.radius;
  });
}

}  // namespace pellucida
