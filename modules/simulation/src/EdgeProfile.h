#pragma once
#include <functional>
#include <vector>

namespace pellucida {

/// A function of the signed distance to a line, tabulated: transmittance (or weight) across an edge.
class EdgeProfile {
 public:
  /// Samples `value` over -band..band. `dark_at_zero`: the slope at 0 is taken away by a short odd term of width
  /// `width_um`, so that the profile's minimum lies at 0 exactly, whatever steps and fringes surround it.
  EdgeProfile(const std::function<double(double)>& value, double band_um, double width_um, bool dark_at_zero);

  /// Value at a signed distance; constant beyond the band.
  float operator()(float distance_um) const noexcept {
    const float place = (distance_um + band_um_) * inverse_step_;
    if (place <= 0.0f) return table_.front();
    const auto i = static_cast<std::size_t>(place);
    if (i + 1 >= table_.size()) return table_.back();
    const float part = place - static_cast<float>(i);
    return table_[i] + part * (table_[i + 1] - table_[i]);
  }

 private:
  std::vector<float> table_;
  float band_um_ = 0.0f, inverse_step_ = 0.0f;
};

/// exp(-x^2 / (2 sigma^2))
double gaussian(double x, double sigma) noexcept;
/// A soft step from 0 to 1 about x = 0, `width` its standard deviation.
double soft_step(double x, double width) noexcept;

}  // namespace pellucida
