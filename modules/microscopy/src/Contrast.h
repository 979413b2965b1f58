#pragma once
#include <opencv2/core.hpp>

#include "OpticalPath.h"

namespace pellucida {

/// Turns an optical path into light, relative to the empty field. Each contrast is its first-order law with a soft
/// limit where a steep path would leave its range; light refracted beyond the aperture is lost.
/// - bright field: I = 1 - z/k laplace(phi), transport of intensity (Teague 1983);
/// - Hoffman: I = 1 + f(d phi / ds), f monotone and saturating (Hoffman and Gross 1975);
/// - DIC: I = (1 - cos(bias + shear d phi / ds)) / (1 - cos(bias)) (Preza et al. 1999);
/// - phase: I = 1 -+ f(phi - phi * wide kernel), f compressed (Yin et al. 2012);
/// - dark field: I grows with |grad phi|^2.
class Contrast {
 public:
  Contrast(const Look::Contrast& look, double pixel_size_um);
  /// `needle_out_of_plane_um`: how far the needle lies beyond the focal plane. `light` is (re)allocated, CV_32F. The
  /// path's layers are blurred in place.
  void develop(OpticalPath& path, double needle_out_of_plane_um, cv::Mat1f& light);

 private:
  template <class Law>
  void apply(const cv::Mat1f& phase_rad, const cv::Mat1f& absorbance, Law law, cv::Mat1f& light) const;
  void add_field_shading(cv::Mat1f& light) const;

  Look::Contrast look_;
  double pixel_size_um_;
  cv::Mat1f total_, wide_, small_, near_;
};

}  // namespace pellucida
