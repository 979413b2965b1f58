#pragma once

namespace pellucida {

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
