#include "widgets/TransportBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "Words.h"
#include "pellucida/visualization/Readout.h"
#include "presenters/Playback.h"
#include "widgets/ButtonKey.h"
#include "widgets/Choice.h"
#include "widgets/Icons.h"
#include "widgets/PhraseLabel.h"

namespace pellucida {
namespace {

constexpr long kManyFrames = 10;

QString speed_text(double ratio) {
  return QString::fromUtf8("\u00D7 ") + QString::fromStdString(readout::plain(ratio));
}

}  // namespace

const std::vector<double>& TransportBar::speeds() {
  static const std::vector<double> kSpeeds{0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0};
  return kSpeeds;
}

TransportBar::TransportBar(Actions actions, QWidget* parent) : QFrame(parent), actions_(std::move(actions)) {
  setObjectName("transportBar");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(42);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 2, 16, 8);
  row->setSpacing(6);
  const auto step = [this](long count) { return [this, count] { actions_.step_by(count); }; };
  add_button(row, Pictogram::kRestart, Qt::Key_Home, words("First frame"), [this] { actions_.to_end(false); });
  add_button(
      row, Pictogram::kEventBack, Qt::Key_PageUp, words("Event before"), [this] { actions_.to_event(false); }, true);
  add_button(row, Pictogram::kTenBack, QKeySequence("Shift+Left"), words("Ten frames back"), step(-kManyFrames), true);
  add_button(row, Pictogram::kStepBack, Qt::Key_Left, words("One frame back"), step(-1), true);
  play_ = add_button(row, Pictogram::kPlay, Qt::Key_Space, words("Play or pause"), [this] { actions_.toggle_play(); });
  play_->setObjectName("play");
  play_->setFixedWidth(96);
  add_button(row, Pictogram::kStepForward, Qt::Key_Right, words("One frame forward"), step(1), true);
  add_button(row, Pictogram::kTenForward, QKeySequence("Shift+Right"), words("Ten frames forward"), step(kManyFrames),
             true);
  add_button(
      row, Pictogram::kEventForward, Qt::Key_PageDown, words("Next event"), [this] { actions_.to_event(true); }, true);
  add_button(row, Pictogram::kEnd, Qt::Key_End, words("Last frame"), [this] { actions_.to_end(true); });
  row->addSpacing(10);
  add_speed(row);
  loop_ = add_toggle(row, Pictogram::kLoop, Qt::Key_L, words("From the end on from the beginning"), actions_.set_loop);
  backwards_ = add_toggle(row, Pictogram::kBackwards, Qt::Key_B, words("Play backwards"), actions_.set_backwards);
  row->addSpacing(10);
  place_ = new QLabel(this);
  place_->setObjectName("place");
  row->addWidget(place_);
  row->addStretch(1);
}

QPushButton* TransportBar::add_button(QHBoxLayout* row, Pictogram pictogram, const QKeySequence& key,
                                      const QString& tip, std::function<void()> action, bool repeats) {
  auto* button = new QPushButton(this);
  button->setIcon(make_icon(pictogram));
  button->setFixedSize(36, 30);
  button->setFocusPolicy(Qt::TabFocus);
  button->setAccessibleName(tip);
  bind_key(*button, key, tip, repeats);
  if (action) connect(button, &QPushButton::clicked, this, std::move(action));
  row->addWidget(button);
  return button;
}

QPushButton* TransportBar::add_toggle(QHBoxLayout* row, Pictogram pictogram, const QKeySequence& key,
                                      const QString& tip, const std::function<void(bool)>& action) {
  QPushButton* button = add_button(row, pictogram, key, tip, {});
  button->setCheckable(true);
  button->setProperty("lit", true);
  connect(button, &QPushButton::toggled, this, action);
  return button;
}

void TransportBar::add_speed(QHBoxLayout* row) {
  const auto add = [&](const char* text, const QKeySequence& key, const QString& tip, int by) {
    auto* button = new QPushButton(QString::fromUtf8(text), this);
    button->setFixedSize(28, 30);
    button->setFocusPolicy(Qt::TabFocus);
    button->setProperty("narrow", true);
    bind_key(*button, key, tip, true);
    connect(button, &QPushButton::clicked, this, [this, by] { change_speed(by); });
    row->addWidget(button);
  };
  add("\u2212", Qt::Key_Minus, words("Slower"), -1);
  speed_ = new Choice(this);
  speed_->setObjectName("speed");
  speed_->setAccessibleName(words("Speed"));
  speed_->setToolTip(words("Speed: times the session's own"));
  speed_->setFixedSize(82, 30);
  speed_->setFocusPolicy(Qt::TabFocus);
  for (const double ratio : speeds()) speed_->addItem(speed_text(ratio));
  connect(speed_, qOverload<int>(&QComboBox::activated), this,
          [this](int index) { actions_.set_speed(speeds()[static_cast<std::size_t>(index)]); });
  row->addWidget(speed_);
  add("+", Qt::Key_Plus, words("Faster"), 1);
}

void TransportBar::change_speed(int by) {
  const int index = std::clamp(speed_->currentIndex() + by, 0, speed_->count() - 1);
  actions_.set_speed(speeds()[static_cast<std::size_t>(index)]);
}

void TransportBar::show_state(const Playback& playback, long frame) {
  const QSignalBlocker no_loop(loop_), no_backwards(backwards_);
  play_->setText(playback.playing() ? words("Pause") : words("Play"));
  play_->setIcon(make_icon(playback.playing() ? Pictogram::kPause : Pictogram::kPlay));
  loop_->setChecked(playback.loop());
  backwards_->setChecked(playback.backwards());
  // A speed of the command line may lie between those of the list: the nearest one is shown.
  const auto nearest = std::min_element(speeds().begin(), speeds().end(), [&](double a, double b) {
    return std::abs(std::log(a / playback.speed_ratio())) < std::abs(std::log(b / playback.speed_ratio()));
  });
  speed_->setCurrentIndex(static_cast<int>(nearest - speeds().begin()));
  place_->setText(words("%1  \u00B7  frame %2  \u00B7  %3 of %4")
                      .arg(QString::fromStdString(readout::time(playback.position_s())))
                      .arg(frame)
                      .arg(playback.step() + 1)
                      .arg(playback.step_count()));
}

}  // namespace pellucida
