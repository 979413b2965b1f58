#pragma once
#include <QWidget>
#include <functional>

#include "presenters/ParameterScale.h"

class QLabel;
class QSlider;

namespace pellucida {

class StableStrip;

/// A parameter of Teach mode: name and value above, a slider, and below it which part of it is stable, in green beside
/// red, and in words.
class ParameterSlider : public QWidget {
 public:
  /// `changed` is called when a person moves the slider, with the new number.
  ParameterSlider(TeachSlider which, std::function<void(double)> changed, QWidget* parent);

  /// Not while the slider is held.
  void show_value(double value);
  void show_stable_part(const StablePart& part);
  QSlider& slider() noexcept { return *slider_; }

 private:
  ParameterScale scale_;
  std::function<void(double)> changed_;
  QLabel* value_;
  QSlider* slider_;
  StableStrip* strip_;
  QLabel* note_;
};

}  // namespace pellucida
