#pragma once

namespace pellucida {

/// The least of 1, 2, 5 times a power of ten that is not below `value`; `floor` for what is not above it.
double nice_ceiling(double value, double floor) noexcept;

/// The greatest of 1, 2, 5 times a power of ten that is not above `value`, > 0.
double nice_floor(double value) noexcept;

/// The upper end of a colour or arrow scale that follows a changing maximum without flicker: it grows at once, and
/// comes down only when the maximum has stayed below two fifths of it for `kPatience` updates.
class NiceRange {
 public:
  explicit NiceRange(double floor) noexcept : floor_(floor), upper_(floor) {}
  /// Takes a frame's maximum, returns the scale's upper end.
  double update(double maximum) noexcept;
  double upper() const noexcept { return upper_; }

 private:
  static constexpr int kPatience = 45;
  double floor_;
  double upper_;
  int small_count_ = 0;
};

}  // namespace pellucida
