#include "presenters/SnakePresenter.h"

#include "pellucida/core/Html.h"
#include "pellucida/core/Words.h"

namespace pellucida {
namespace {

std::string two_decimals(double value) {
  return fixed_number(value, 2);
}
std::string three_decimals(double value) {
  return fixed_number(value, 3);
}

constexpr NumberScale kSnakeScales[kSnakeSliderCount] = {
    {PELLUCIDA_WORDS("Stretching, \u03b1"), PELLUCIDA_WORDS("Draws the snake together and spreads its points evenly"),
     1e-3, 10.0, true, 0.01, false, three_digits},
    {PELLUCIDA_WORDS("Bending, \u03b2"), PELLUCIDA_WORDS("Keeps the snake smooth; too much cuts across the dimple"),
     1e-3, 1000.0, true, 0.01, false, three_digits},
    {PELLUCIDA_WORDS("Viscosity, \u03b3"), PELLUCIDA_WORDS("The smaller, the longer a step; too small overshoots"),
     0.02, 10.0, true, 0.01, false, three_digits},
    {PELLUCIDA_WORDS("Balloon"), PELLUCIDA_WORDS("A push on each point, outwards; inwards below 0"), -0.3, 0.3, false,
     0.01, false, three_decimals},
    {PELLUCIDA_WORDS("Blur"), PELLUCIDA_WORDS("Of the image: more is felt from farther away, and less sharply"), 0.5,
     8.0, true, 0.01, false, [](double blur_px) { return fixed_number(blur_px, 1) + " px"; }},
    {PELLUCIDA_WORDS("Radius at the start"), PELLUCIDA_WORDS("Of the circle that the snake begins on"), 2.0, 150.0,
     true, 0.01, false, [](double radius_um) { return fixed_number(radius_um, 1) + " µm"; }},
    {PELLUCIDA_WORDS("Moment"), PELLUCIDA_WORDS("Which frame of the film or the recording is seen"), 0.0, 6.0, false,
     0.01, false, [](double time_s) { return fixed_number(time_s, 2) + " s"; }},
    {PELLUCIDA_WORDS("Pace"), PELLUCIDA_WORDS("Steps a second while it runs"), 1.0, 200.0, true, 0.02, false,
     [](double pace) { return fixed_number(pace, 0) + " /s"; }}};

}  // namespace

NumberScale snake_scale(SnakeSlider which) {
  return kSnakeScales[static_cast<int>(which)];
}

SnakeTexts snake_texts(const KassSnake& snake, bool has_picture, bool is_running, bool is_restless,
                       const ThemeColors& theme) {
  SnakeTexts texts;
  if (!has_picture) {
    texts.state = {say("No picture"), theme.text_dim};
  } else if (snake.state() == SnakeState::kLeftPicture) {
    texts.state = {say("Left the picture"), theme.record};
  } else if (snake.state() == SnakeState::kCollapsed) {
    texts.state = {say("Collapsed"), theme.record};
  } else if (snake.state() == SnakeState::kConverged) {
    texts.state = {say("At rest"), theme.good};
  } else if (is_restless) {
    texts.state = {say("Finds no rest"), theme.record};
  } else if (is_running) {
    texts.state = {say("Moving"), theme.warning};
  } else {
    texts.state = {snake.iteration() == 0 ? say("At the start") : say("Stopped"), theme.accent};
  }
  const SnakeEnergy energy = snake.energy();
  const auto plain = [&](std::string text) { return Phrase{std::move(text), theme.text}; };
  texts.figures = {plain(std::to_string(snake.iteration())),
                   plain(two_decimals(energy.total())),
                   plain(two_decimals(energy.stretching)),
                   plain(two_decimals(energy.bending)),
                   plain(two_decimals(energy.image)),
                   plain(two_decimals(energy.balloon)),
                   plain(three_decimals(snake.largest_motion_px()) + " px")};
  return texts;
}

}  // namespace pellucida
