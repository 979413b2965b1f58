#pragma once
#include <QWidget>
#include <functional>

#include "presenters/NumberScale.h"

class QLabel;
class QSlider;

namespace pellucida {

class StableStrip;

/// A number of Teach mode: name and value above, a slider, and below it which part of it is stable, in green beside
/// red, and in words.
class ParameterSlider : public QWidget {
 public:
  /// `changed` is called when a person moves the slider, with the new number.
  ParameterSlider(const NumberScale& scale, std::function<void(double)> changed, QWidget* parent);

  /// Other ends; the value is to be shown anew.
  void set_scale(const NumberScale& scale) { scale_ = scale; }
  /// Not while the slider is held.
  void show_value(double value);
  void show_stable_part(const StablePart& part);
  QSlider& slider() noexcept { return *slider_; }

 private:
  void show_text(double value);

  NumberScale scale_;
  std::function<void(double)> changed_;
  QLabel* value_;
  QSlider* slider_;
  StableStrip* strip_;
  QLabel* note_;
};

}  // namespace pellucida
