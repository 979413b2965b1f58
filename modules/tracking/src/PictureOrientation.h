#pragma once
#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "pellucida/core/ImageView.h"
#include "pellucida/core/Observation.h"

namespace pellucida {

/// How a film is laid before anything looks at it: a microscope may show it mirrored or turned by 90 degrees, and none
/// of that may decide anything. The networks know no mirror image and a grid of pixels has a first row; so the first
/// picture says which of its eight mirrored and turned versions is taken, by where its edges are, and all later ones
/// follow: wide pictures stay wide, and most of what changes in grey lies left of the middle and above it (in square
/// pictures more so above). All eight versions of a film are thus the same film to what follows, pixel by pixel.
class PictureOrientation {
 public:
  /// By its first picture, of any size and format. Sums of whole numbers: two versions of it never differ by rounding.
  void choose(const ImageView& view);
  bool is_chosen() const noexcept { return is_chosen_; }

  /// The picture as it is laid: `view` itself, or an image that lives until the next call. Points given to and taken
  /// from the others belong to this picture.
  ImageView lay(const ImageView& view);

  /// From the picture as it came to the one that is laid: points and directions, um.
  Eigen::Vector2d laid_point(const Eigen::Vector2d& point_um) const;
  Eigen::Vector2d laid_direction(const Eigen::Vector2d& direction) const;
  Contour_um laid_points(const Contour_um& points_um) const;
  /// And back, all that was seen; closed contours keep their first point and their positive area.
  void take_back(Observation& seen) const;

 private:
  Eigen::Vector2d point_back(const Eigen::Vector2d& point_um) const;
  Eigen::Vector2d direction_back(const Eigen::Vector2d& direction) const;
  void take_back(MembraneContour& contour) const;
  bool is_mirrored() const noexcept { return (flips_x_ != flips_y_) != swaps_; }

  bool is_chosen_ = false;
  bool flips_x_ = false, flips_y_ = false, swaps_ = false;   // in this order
  Eigen::Vector2d last_pixel_um_ = Eigen::Vector2d::Zero();  // of the picture as it came
  cv::Mat flipped_, laid_;
};

}  // namespace pellucida
