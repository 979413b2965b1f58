#pragma once
#include <limits>

namespace pellucida {

/// What of a cell's shape shows that it is pushed, wherever its contour lies under the tip: the depth of the dimple's
/// flanks, the bulge of the cell's sides. Keeps the most of late and where the tip was then; both go with the needle's
/// depth squared as it is drawn back, so that what this leaves of them is no recoil, and with the depth as it goes on.
/// um; one thread at a time.
class PushedShape {
 public:
  /// What is known of a measure of the shape.
  struct Nature {
    double least_um;           ///< below this, or some times its noise, it says nothing
    double fade_ratio;         ///< of the most of late, per frame
    double most_onward_ratio;  ///< by no more than this factor it grows with a tip that goes on
  };
  explicit PushedShape(const Nature& nature) noexcept;

  /// A frame that was seen well, in contact or not: noise is learnt from what neither place nor pace explain.
  void learn_noise(double value_um) noexcept;
  /// The most of late fades, frame by frame, while the tip, now at `tip_um`, is drawn back: that punctures nothing.
  void fade(double tip_um) noexcept;
  void follow(double value_um, double tip_um) noexcept;
  /// Its most of late begins with the next value.
  void restart() noexcept { most_um_ = 0.0; }
  /// Nothing of late; the noise stays known.
  void forget() noexcept {
    if (most_um_ > 0.0) last_um_ = before_last_um_ = std::numeric_limits<double>::quiet_NaN();
    restart();
  }

  double most_um() const noexcept { return most_um_; }
  /// What the contour says of itself: no value is better known, however steady it looks.
  void set_least_noise(double sigma_um) noexcept { least_noise_um_ = sigma_um; }
  /// Standard deviation of one frame's value.
  double noise_um() const noexcept;
  /// Whether a value is large enough to say something.
  bool is_telling(double value_um) const noexcept;
  /// Its value now, had only the needle moved since it was largest. A tip that seems to have gone back and isn't known
  /// well explains nothing.
  double expected_um(double tip_um, double tip_sigma_um) const noexcept;
  /// By which share of that it has come back, and its standard deviation; NaN where it says nothing.
  struct Share {
    double back = std::numeric_limits<double>::quiet_NaN(), sigma = 0.1;
  };
  Share back(double value_um, double tip_um, double tip_sigma_um) const noexcept;

 private:
  Nature nature_;
  double most_um_ = 0.0, tip_at_most_um_ = 0.0;
  double variance_um2_;  // of one frame, by second differences
  double least_noise_um_ = 0.0;
  double last_um_ = std::numeric_limits<double>::quiet_NaN(), before_last_um_ = last_um_;
};

}  // namespace pellucida
