#include "ExposureControl.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QSlider>
#include <QWidgetAction>
#include <algorithm>
#include <cmath>
#include <utility>

#include "Words.h"
#include "pellucida/core/Error.h"
#include "pellucida/visualization/Readout.h"
#include "presenters/MessageBook.h"

namespace pellucida {
namespace {

// Of the slider, from the shortest time to the longest, each as many times the one before.
constexpr int kStepCount = 100;
constexpr int kSettled_ms = 600;

double time_ms_at(int step, const CameraExposure::State& state) {
  return state.least_ms * std::pow(state.most_ms / state.least_ms, static_cast<double>(step) / kStepCount);
}

int step_of(const CameraExposure::State& state) {
  // An automatic may be anywhere.
  const double time_ms = std::clamp(state.time_ms, state.least_ms, state.most_ms);
  const double share = std::log(time_ms / state.least_ms) / std::log(state.most_ms / state.least_ms);
  return static_cast<int>(std::lround(kStepCount * share));
}

}  // namespace

ExposureControl::ExposureControl(std::shared_ptr<CameraExposure> exposure, QMenu& menu, Remark remark, Say say_it)
    : QObject(&menu), exposure_(std::move(exposure)), remark_(std::move(remark)), say_(std::move(say_it)) {
  build(menu);
  settled_.setSingleShot(true);
  settled_.setInterval(kSettled_ms);
  connect(&settled_, &QTimer::timeout, this, [this] {
    remark_(state_.automatic ? "camera exposure: automatic"
                             : "camera exposure: " + readout::number(state_.time_ms, 1) + " ms");
  });
  // An automatic has moved on since.
  connect(&menu, &QMenu::aboutToShow, this, [this] { show_state(); });
  show_state();
}

void ExposureControl::build(QMenu& menu) {
  menu.addSeparator();
  auto* box = new QWidget;
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(10, 6, 10, 6);
  grid->setHorizontalSpacing(12);
  grid->addWidget(new QLabel(words("Exposure")), 0, 0);
  time_ = new QSlider(Qt::Horizontal);
  time_->setObjectName("exposure");
  time_->setAccessibleName(words("Exposure time of the camera"));
  time_->setRange(0, kStepCount);
  time_->setFixedWidth(170);
  grid->addWidget(time_, 0, 1);
  number_ = new QLabel;
  number_->setMinimumWidth(64);
  number_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  grid->addWidget(number_, 0, 2);
  automatic_ = new QCheckBox(words("The camera chooses the time"));
  automatic_->setObjectName("exposureAutomatic");
  grid->addWidget(automatic_, 1, 0, 1, 3);
  auto* note = new QLabel(words("The camera's own: it changes what is measured."));
  note->setProperty("figureNote", true);
  grid->addWidget(note, 2, 0, 1, 3);
  auto* action = new QWidgetAction(&menu);
  action->setDefaultWidget(box);
  menu.addAction(action);
  connect(time_, &QSlider::valueChanged, this, [this] { take(false); });
  connect(automatic_, &QCheckBox::toggled, this, [this](bool on) { take(on); });
}

void ExposureControl::take(bool automatic) {
  try {
    automatic ? exposure_->set_automatic() : exposure_->set_time_ms(time_ms_at(time_->value(), state_));
    settled_.start();
  } catch (const Error& error) {
    say_(QString::fromStdString(say_message(error.what())), true);
  }
  show_state();
}

void ExposureControl::show_state() {
  try {
    state_ = exposure_->state();
  } catch (const Error& error) {
    say_(QString::fromStdString(say_message(error.what())), true);
    return;
  }
  const QSignalBlocker quiet_time(time_), quiet_automatic(automatic_);
  time_->setValue(step_of(state_));
  automatic_->setVisible(state_.has_automatic);
  automatic_->setChecked(state_.automatic);
  number_->setText(QString::fromStdString(readout::number(state_.time_ms, 1) + " ms"));
}

}  // namespace pellucida
