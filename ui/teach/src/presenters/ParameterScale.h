#pragma once
#include "pellucida/teaching/CellSnapshot.h"
#include "presenters/NumberScale.h"

namespace pellucida {

/// The numbers that Teach mode has a slider for.
enum class TeachSlider { kTimeStep, kNodeMass, kDamping, kModulus, kMesh, kGive, kPace };
inline constexpr int kTeachSliderCount = 7;

/// One of them, and where it is in the parameters.
class ParameterScale : public NumberScale {
 public:
  explicit ParameterScale(TeachSlider which);

  double value_in(const TeachingParameters& parameters) const noexcept;
  void set(TeachingParameters& parameters, double value) const noexcept;

 private:
  TeachSlider which_;
};

StablePart stable_part(TeachSlider which, const CellSnapshot& snapshot);

}  // namespace pellucida
