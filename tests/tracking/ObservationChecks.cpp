#include "tracking/ObservationChecks.h"

#include <cmath>
#include <sstream>

#include "ContourMath.h"

namespace pellucida::test {
namespace {

// Collects the first thing that does not hold.
class Complaint {
 public:
  void require(bool holds, const std::string& what) {
    if (!holds && text_.empty()) text_ = what;
  }
  // low <= value <= high; false for NaN too.
  void in_range(double value, double low, double high, const std::string& what) {
    if (value >= low && value <= high) return;
    std::ostringstream text;
    text << what << " is " << value << ", not in " << low << ".." << high;
    require(false, text.str());
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void check_place(Complaint& complaint, const Eigen::Matrix2Xd& points_um, const ImageView& image,
                 const std::string& what) {
  // A cell may lie half outside, a needle's line end beyond the border: as far out as the picture's diagonal is wide.
  const double diagonal_um = image.pixel_size_um * (std::hypot(image.width_px, image.height_px) + 200.0);
  complaint.require(points_um.allFinite(), what + " is not finite");
  if (!points_um.allFinite() || points_um.size() == 0) return;
  complaint.in_range(points_um.minCoeff(), -diagonal_um, diagonal_um, what + "'s smallest coordinate");
  complaint.in_range(points_um.maxCoeff(), -diagonal_um, 2.0 * diagonal_um, what + "'s largest coordinate");
}

void check_contour(Complaint& complaint, const MembraneContour& contour, const ImageView& image,
                   const std::string& what) {
  const Eigen::Matrix2Xd& points = contour.points_um;
  complaint.require(points.cols() >= 3, what + " has fewer than 3 points");
  complaint.require(contour.confidence.size() == points.cols(), what + "'s confidences are not one a point");
  complaint.require(contour.sigma_um.size() == 0 || contour.sigma_um.size() == points.cols(),
                    what + "'s sigmas are not one a point");
  check_place(complaint, points, image, what);
  if (!complaint.text().empty()) return;
  complaint.in_range(contour.confidence.minCoeff(), 0.0, 1.0, what + "'s smallest confidence");
  complaint.in_range(contour.confidence.maxCoeff(), 0.0, 1.0, what + "'s largest confidence");
  if (contour.sigma_um.size() > 0) {
    complaint.in_range(contour.sigma_um.minCoeff(), 0.0, 1e6, what + "'s smallest sigma");
    complaint.in_range(contour.sigma_um.maxCoeff(), 0.0, 1e6, what + "'s largest sigma");
  }
  complaint.require(contour::signed_area(points) > 0.0, what + " runs the wrong way round");
  complaint.require(!contour::self_intersects(points), what + " crosses itself");
}

}  // namespace

std::string violation_of(const Observation& seen, const ImageView& image) {
  Complaint complaint;
  const double diagonal_um = image.pixel_size_um * (std::hypot(image.width_px, image.height_px) + 200.0);
  complaint.in_range(seen.confidence, 0.0, 1.0, "the confidence");
  const bool nothing = seen.state == CellState::kNoCell || seen.state == CellState::kLost;
  complaint.require(!(nothing && seen.confidence > 0.0), "there is confidence, but no cell");
  complaint.require(nothing || seen.outer.has_value(), "there is a cell without an outer contour");
  if (seen.outer) {
    check_contour(complaint, *seen.outer, image, "the outer contour");
    check_place(complaint, seen.center_um, image, "the centre");
    complaint.in_range(seen.rest_outer_radius_um, 1e-9, diagonal_um, "the outer radius at rest");
    complaint.in_range(seen.rest_inner_radius_um, 0.0, seen.rest_outer_radius_um, "the inner radius at rest");
    complaint.in_range(std::abs(seen.rotation_rad), 0.0, 1e3, "the rotation");
  }
  if (seen.inner) check_contour(complaint, *seen.inner, image, "the inner contour");
  if (seen.oolemma) check_contour(complaint, *seen.oolemma, image, "the oolemma");
  if (seen.needle) {
    check_place(complaint, seen.needle->tip_um, image, "the tip");
    check_place(complaint, seen.needle->outline_um, image, "the needle's outline");
    complaint.in_range(seen.needle->direction.norm(), 0.999, 1.001, "the needle's direction");
    complaint.in_range(seen.needle->confidence, 0.0, 1.0, "the needle's confidence");
    complaint.in_range(seen.needle->tip_sigma_um, 0.0, diagonal_um, "the tip's sigma");
    complaint.in_range(seen.needle->tip_radius_um, 0.0, diagonal_um, "the tip's radius");
  }
  if (seen.holder) {
    check_place(complaint, seen.holder->mouth_um, image, "the holder's mouth");
    complaint.in_range(seen.holder->direction.norm(), 0.999, 1.001, "the holder's direction");
    complaint.in_range(seen.holder->confidence, 0.0, 1.0, "the holder's confidence");
    complaint.in_range(seen.holder->outer_radius_um, 0.0, diagonal_um, "the holder's radius");
  }
  if (seen.outer && seen.needle) {
    complaint.in_range(seen.axis.norm(), 0.999, 1.001, "the axis");
    complaint.in_range(seen.indentation_um, 0.0, 3.0 * diagonal_um, "the indentation");
    complaint.in_range(seen.indentation_sigma_um, 0.0, diagonal_um, "the indentation's sigma");
    complaint.in_range(seen.dimple_radius_um, 0.0, diagonal_um, "the dimple's radius");
  }
  return complaint.text();
}

}  // namespace pellucida::test
