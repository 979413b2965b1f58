#pragma once
#include <string>
#include <vector>

#include "pellucida/teaching/CellSnapshot.h"

namespace pellucida {

/// The numbers that Teach mode has a slider for.
enum class TeachSlider { kTimeStep, kNodeMass, kDamping, kModulus, kMesh, kGive, kPace };
inline constexpr int kTeachSliderCount = 7;

/// One of them: its name and unit, its ends, and how a slider's places (0 to 1) become numbers.
class ParameterScale {
 public:
  explicit ParameterScale(TeachSlider which);

  const char* name() const noexcept { return name_; }
  const char* tip() const noexcept { return tip_; }
  /// The parameter at a place, and the place of a parameter; what is beyond the ends is held there.
  double value_at(double place) const noexcept;
  double place_of(double value) const noexcept;
  /// With its unit.
  std::string text_of(double value) const;
  /// The least change by an arrow key, as a place.
  double key_step() const noexcept { return key_step_; }

  double value_in(const TeachingParameters& parameters) const noexcept;
  void set(TeachingParameters& parameters, double value) const noexcept;

 private:
  TeachSlider which_;
  const char* name_ = "";
  const char* tip_ = "";
  double low_ = 0.0;
  double high_ = 1.0;
  bool is_log_ = false;
  double key_step_ = 0.01;
};

/// Which part of a slider is stable while all other parameters stay: places from and to, 0 to 1, and that in words;
/// empty words where the slider has no such part.
struct StablePart {
  double from = 0.0;
  double to = 1.0;
  std::string text;
};
StablePart stable_part(TeachSlider which, const CellSnapshot& snapshot);

/// "15 ms", "146 µs".
std::string duration_text(double time_us);

}  // namespace pellucida
