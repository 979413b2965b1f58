#pragma once
#include <functional>
#include <vector>

#include "presenters/ParameterScale.h"
#include "widgets/SidePage.h"

class QCheckBox;
class QComboBox;

namespace pellucida {

class ParameterSlider;

/// The parameters of a poked cell: which cell, which integrator, sliders, volume.
class ParameterPanel : public SidePage {
 public:
  /// `changed` is called with all parameters when a person changes one.
  ParameterPanel(std::function<void(const TeachingParameters&)> changed, QWidget* parent);

  /// Sets every control, without a call of `changed`.
  void set_parameters(const TeachingParameters& parameters);
  const TeachingParameters& parameters() const noexcept { return parameters_; }
  /// Marks the stable parts.
  void show_limits(const CellSnapshot& snapshot);
  ParameterSlider& slider(TeachSlider which) { return *sliders_[static_cast<std::size_t>(which)]; }

 private:
  void change();

  std::function<void(const TeachingParameters&)> changed_;
  TeachingParameters parameters_;
  QComboBox* profile_;
  QComboBox* integrator_;
  QCheckBox* volume_;
  std::vector<ParameterSlider*> sliders_;
};

}  // namespace pellucida
