#include "Contrast.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

namespace pellucida {
namespace {

// x for small x, +-1 for large.
inline float limited(float x) noexcept {
  return x / std::sqrt(1 + x * x);
}

// What the limits were set by: pictures that look like micrographs.
constexpr float kDarkest_ratio = 0.85f, kBrightest_ratio = 0.7f;
constexpr float kReliefSlope_rad_per_um = 1.3f;  // where Hoffman's relief has two thirds of its range
constexpr double kShear_um = 0.55;               // of the DIC prism
constexpr float kCompression = 0.35f;            // of phase contrast: light for a factor e of path
constexpr double kDetail_um = 1.5;               // what is finer is detail in phase contrast,
constexpr float kDetail = 0.7f;                  // this is the most it adds,
constexpr float kDetailRange_rad = 0.8f;         // and the path that gives most of that
constexpr double kCondenser_ratio = 0.10;        // the cone of light blurs what is out of focus, um for a um
constexpr double kNeedleBlur_ratio = 0.25;       // the same of the needle, which is thin and bright

void blur(cv::Mat1f& layer, double sigma_um, double pixel_size_um) {
  const double sigma_px = sigma_um / pixel_size_um;
  if (sigma_px > 0.2) cv::GaussianBlur(layer, layer, {}, sigma_px, sigma_px, cv::BORDER_REPLICATE);
}

}  // namespace

Contrast::Contrast(const Look::Contrast& look, double pixel_size_um) : look_(look), pixel_size_um_(pixel_size_um) {}

// Calls law(gx, gy, laplace, row, column) with derivatives in rad/um, and takes away what is absorbed or refracted out.
template <class Law>
void Contrast::apply(const cv::Mat1f& phase_rad, const cv::Mat1f& absorbance, Law law, cv::Mat1f& light) const {
  const auto slope = static_cast<float>(0.5 / pixel_size_um_),
             curve = static_cast<float>(1 / (3 * pixel_size_um_ * pixel_size_um_));
  const auto limit = static_cast<float>(1 / (kPhase_rad_per_um * look_.numerical_aperture));
  light.create(phase_rad.size());
  const int width = phase_rad.cols, height = phase_rad.rows;
  std::vector<float> left(static_cast<std::size_t>(width));
  for (int y = 0; y < height; ++y) {
    const float *here = phase_rad[y], *up = phase_rad[std::max(0, y - 1)],
                *down = phase_rad[std::min(height - 1, y + 1)];
    const float* loss = absorbance[y];
    float* out = light[y];
    auto at = [&](int x, int before, int after) {
      const float gx = slope * (here[after] - here[before]), gy = slope * (down[x] - up[x]);
      // Nine points, the same in every direction to fourth order: two parts of the cross, one of the corners.
      const float cross = here[before] + here[after] + up[x] + down[x] - 4 * here[x];
      const float corners = up[before] + up[after] + down[before] + down[after] - 4 * here[x];
      const float laplace = curve * (2 * cross + 0.5f * corners);
      const float steep = limit * limit * (gx * gx + gy * gy);
      left[static_cast<std::size_t>(x)] = 1 / (1 + steep * steep);
      out[x] = law(gx, gy, laplace, y, x);
    };
    at(0, 0, std::min(1, width - 1));
    for (int x = 1; x + 1 < width; ++x) at(x, x - 1, x + 1);
    at(width - 1, std::max(0, width - 2), width - 1);
    for (int x = 0; x < width; ++x)
      out[x] *= left[static_cast<std::size_t>(x)] * (loss[x] > 0 ? std::exp(-loss[x]) : 1.0f);
  }
}

void Contrast::develop(OpticalPath& path, double needle_out_of_plane_um, cv::Mat1f& light) {
  // The pixels have blurred the path by 0.45 of their side already.
  const bool bright_field = look_.kind == "bright-field";
  const double defocus = bright_field ? look_.defocus_um : 0.0, own = 0.45 * pixel_size_um_;
  auto rest_of = [&](double wanted) { return std::sqrt(std::max(0.0, wanted * wanted - own * own)); };
  const double spread = std::hypot(look_.point_spread_um, kCondenser_ratio * defocus);
  blur(path.phase_rad, rest_of(spread), pixel_size_um_);
  const double needle_spread = std::hypot(look_.point_spread_um, kCondenser_ratio * (defocus + needle_out_of_plane_um),
                                          kNeedleBlur_ratio * needle_out_of_plane_um);
  blur(path.needle_phase_rad, rest_of(needle_spread), pixel_size_um_);
  total_ = path.phase_rad + path.needle_phase_rad;

  const auto strength = static_cast<float>(look_.strength);
  const double angle = look_.shear_angle_deg * std::numbers::pi / 180;
  // The light seems to come from there: what faces it, where the path falls that way, is bright.
  const auto sx = static_cast<float>(-std::cos(angle)), sy = static_cast<float>(-std::sin(angle));
  if (bright_field) {
    const float lens = strength * static_cast<float>(defocus / kPhase_rad_per_um);
    apply(
        total_, path.absorbance,
        [lens](float, float, float laplace, int, int) {
          const float q = -lens * laplace, most = q < 0 ? kDarkest_ratio : kBrightest_ratio;
          return 1 + most * limited(q / most);
        },
        light);
  } else if (look_.kind == "hoffman") {
    apply(
        total_, path.absorbance,
        [=](float gx, float gy, float, int, int) {
          return 1 + kDarkest_ratio * limited(strength * (sx * gx + sy * gy) / kReliefSlope_rad_per_um);
        },
        light);
  } else if (look_.kind == "dic") {
    const double bias = look_.bias_deg * std::numbers::pi / 180;
    const auto b = static_cast<float>(bias), scale = static_cast<float>(1 / (1 - std::cos(bias))),
               shear = static_cast<float>(strength * kShear_um), dark = b,
               bright = std::numbers::pi_v<float> - b + 0.5f;
    apply(
        total_, path.absorbance,
        [=](float gx, float gy, float, int, int) {
          const float turn = shear * (sx * gx + sy * gy), most = turn < 0 ? dark : bright;
          return scale * (1 - std::cos(b + most * limited(turn / most)));
        },
        light);
  } else if (look_.kind == "phase") {
    // The wide kernel on a smaller picture.
    const double sigma_px = look_.halo_um / pixel_size_um_;
    const int shrink = std::clamp(static_cast<int>(sigma_px / 2), 1, 8);
    cv::resize(total_, small_, {}, 1.0 / shrink, 1.0 / shrink, cv::INTER_AREA);
    cv::GaussianBlur(small_, small_, {}, sigma_px / shrink, sigma_px / shrink, cv::BORDER_REPLICATE);
    cv::resize(small_, wide_, total_.size(), 0, 0, cv::INTER_LINEAR);
    // Detail finer than the ring's image keeps its contrast on any halo.
    cv::GaussianBlur(total_, near_, {}, kDetail_um / pixel_size_um_, kDetail_um / pixel_size_um_, cv::BORDER_REPLICATE);
    const float turn = look_.inverted ? strength : -strength;
    apply(
        total_, path.absorbance,
        [&, turn](float, float, float, int y, int x) {
          const float d = 2 * (total_(y, x) - wide_(y, x)), size = std::abs(d);
          const float compressed = kCompression * std::log(size + std::sqrt(size * size + 1));
          const float detail = kDetail * limited((total_(y, x) - near_(y, x)) / kDetailRange_rad);
          return 1 + kDarkest_ratio * limited(turn * ((d < 0 ? -compressed : compressed) + detail));
        },
        light);
  } else {
    apply(
        total_, path.absorbance,
        [=](float gx, float gy, float, int, int) {
          const float slope2 = strength * (gx * gx + gy * gy);
          return 0.1f + 1.5f * slope2 / (slope2 + 6.0f);
        },
        light);
  }
  if (look_.kind == "hoffman" && look_.shading_ratio != 0) add_field_shading(light);
}

// The slit isn't quite where its image is: the background slopes along the shear.
void Contrast::add_field_shading(cv::Mat1f& light) const {
  const double angle = look_.shear_angle_deg * std::numbers::pi / 180, half = std::hypot(light.cols, light.rows) / 2;
  const auto a = static_cast<float>(look_.shading_ratio * std::cos(angle) / half),
             b = static_cast<float>(look_.shading_ratio * std::sin(angle) / half);
  for (int y = 0; y < light.rows; ++y) {
    float* row = light[y];
    const float start = 1 + b * (static_cast<float>(y) - 0.5f * static_cast<float>(light.rows));
    for (int x = 0; x < light.cols; ++x)
      row[x] *= start + a * (static_cast<float>(x) - 0.5f * static_cast<float>(light.cols));
  }
}

}  // namespace pellucida
