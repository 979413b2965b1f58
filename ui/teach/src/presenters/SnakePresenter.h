#pragma once
#include <string>
#include <vector>

#include "pellucida/teaching/KassSnake.h"
#include "presenters/NumberScale.h"
#include "presenters/Phrase.h"

namespace pellucida {

/// The numbers of a snake that have a slider.
enum class SnakeSlider { kAlpha, kBeta, kGamma, kBalloon, kBlur, kRadius, kMoment, kPace };
inline constexpr int kSnakeSliderCount = 8;

NumberScale snake_scale(SnakeSlider which);

/// What Teach mode says about a snake, UTF-8.
struct SnakeTexts {
  Phrase state;                 ///< its colour is the pill's
  std::vector<Phrase> figures;  ///< step, energy, stretching, bending, image, balloon, farthest move
};
/// `is_lost_running`: it was run for as long as it may and came to no rest.
SnakeTexts snake_texts(const KassSnake& snake, bool has_picture, bool is_running, bool is_restless,
                       const ThemeColors& theme);

}  // namespace pellucida
