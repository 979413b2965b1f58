#include "widgets/ParameterPanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QSignalBlocker>

#include "Words.h"
#include "pellucida/core/Resources.h"
#include "widgets/ParameterSlider.h"

namespace pellucida {
namespace {

constexpr std::pair<const char*, const char*> kIntegratorNames[] = {
    {PELLUCIDA_WORDS("Implicit Euler"), "implicit-euler"},
    {PELLUCIDA_WORDS("Symplectic Euler, eq. (4)"), "symplectic-euler"},
    {PELLUCIDA_WORDS("Linear acceleration (Newmark)"), "linear-acceleration"}};

}  // namespace

ParameterPanel::ParameterPanel(std::function<void(const TeachingParameters&)> changed, QWidget* parent)
    : SidePage(parent), changed_(std::move(changed)) {
  profile_ = add_choice(words("Cell"), "profileChoice", words("A profile's geometry and constants"));
  for (const auto& name : list_resources("profiles", ".json")) profile_->addItem(QString::fromStdString(name));
  integrator_ = add_choice(words("Integrator"), "integratorChoice", words("How eq. (2) is stepped through time"));
  for (const auto& [text, name] : kIntegratorNames) integrator_->addItem(words(text), QString(name));
  volume_ = new QCheckBox(words("Liquid keeps its volume"), this);
  volume_->setToolTip(words("Without it the liquid leaves freely, and there is no pressure"));
  add(volume_);
  for (int k = 0; k < kTeachSliderCount; ++k) {
    const auto which = static_cast<TeachSlider>(k);
    sliders_.push_back(new ParameterSlider(
        ParameterScale(which),
        [this, which](double value) {
          ParameterScale(which).set(parameters_, value);
          changed_(parameters_);
        },
        this));
    add(sliders_.back());
  }
  end();

  connect(profile_, qOverload<int>(&QComboBox::activated), this, [this] { change(); });
  connect(integrator_, qOverload<int>(&QComboBox::activated), this, [this] { change(); });
  connect(volume_, &QCheckBox::toggled, this, [this] { change(); });
}

void ParameterPanel::change() {
  const std::string profile = profile_->currentText().toStdString();
  // Another cell comes with its own modulus.
  if (profile != parameters_.profile) parameters_.young_modulus_kPa = 0.0;
  parameters_.profile = profile;
  parameters_.integrator = integrator_->currentData().toString().toStdString();
  parameters_.keeps_volume = volume_->isChecked();
  changed_(parameters_);
}

void ParameterPanel::set_parameters(const TeachingParameters& parameters) {
  parameters_ = parameters;
  const QSignalBlocker quiet[] = {QSignalBlocker(profile_), QSignalBlocker(integrator_), QSignalBlocker(volume_)};
  const QString profile = QString::fromStdString(parameters.profile);
  // A profile that is a file of the user's own.
  if (profile_->findText(profile) < 0) profile_->addItem(profile);
  profile_->setCurrentText(profile);
  integrator_->setCurrentIndex(integrator_->findData(QString::fromStdString(parameters.integrator)));
  volume_->setChecked(parameters.keeps_volume);
  for (int k = 0; k < kTeachSliderCount; ++k) {
    sliders_[static_cast<std::size_t>(k)]->show_value(ParameterScale(static_cast<TeachSlider>(k)).value_in(parameters));
  }
}

void ParameterPanel::show_limits(const CellSnapshot& snapshot) {
  for (int k = 0; k < kTeachSliderCount; ++k) {
    const auto which = static_cast<TeachSlider>(k);
    sliders_[static_cast<std::size_t>(k)]->show_stable_part(stable_part(which, snapshot));
  }
  // The profile's own modulus is known once the cell is there.
  if (parameters_.young_modulus_kPa == 0.0) slider(TeachSlider::kModulus).show_value(snapshot.young_modulus_kPa);
}

}  // namespace pellucida
