#include "widgets/HandBar.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>

#include "presenters/HandPresenter.h"

namespace pellucida {
namespace {

constexpr int kForceSteps = 1000;
constexpr double kDeepest_um = 200.0;

}  // namespace

HandBar::HandBar(const QStringList& hands, const QStringList& scales, Actions actions, QWidget* parent)
    : QFrame(parent), actions_(std::move(actions)) {
  setObjectName("handBar");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(42);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 4, 16, 6);
  row->setSpacing(10);

  auto* title = new QLabel("HAND", this);
  title->setObjectName("readoutName");
  row->addWidget(title);
  hand_ = new QComboBox(this);
  hand_->addItems(hands);
  hand_->setToolTip("Who holds the pipette");
  hand_->setFocusPolicy(Qt::TabFocus);
  row->addWidget(hand_);
  connect(hand_, qOverload<int>(&QComboBox::activated), this, [this](int index) { actions_.choose_hand(index); });

  state_ = new QLabel(this);
  state_->setObjectName("handPill");
  state_->setAlignment(Qt::AlignCenter);
  state_->setFixedSize(84, 22);
  row->addWidget(state_);

  guide_ = add_button(row, "Guide", "Hold the tip on the planned line, in and out (G)");
  guide_->setObjectName("guide");
  guide_->setCheckable(true);
  guide_->setChecked(true);
  guide_->setShortcut(Qt::Key_G);
  connect(guide_, &QPushButton::toggled, this, [this](bool on) { actions_.guide(on); });

  scale_ = new QComboBox(this);
  scale_->addItems(scales);
  scale_->setToolTip("How far the tip goes for a way of the hand");
  scale_->setFocusPolicy(Qt::TabFocus);
  row->addWidget(scale_);
  connect(scale_, qOverload<int>(&QComboBox::activated), this, [this](int index) { actions_.choose_scale(index); });

  auto* stop_name = new QLabel("Depth stop", this);
  stop_name->setObjectName("statusText");
  row->addWidget(stop_name);
  depth_stop_ = new QDoubleSpinBox(this);
  depth_stop_->setRange(1.0, kDeepest_um);
  depth_stop_->setDecimals(0);
  depth_stop_->setSuffix(QString::fromUtf8(" µm"));
  depth_stop_->setToolTip("The tip goes no deeper behind the entry");
  depth_stop_->setFocusPolicy(Qt::ClickFocus);
  depth_stop_->setKeyboardTracking(false);
  row->addWidget(depth_stop_);
  connect(depth_stop_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this](double depth_um) { actions_.depth_stop(depth_um); });

  force_bar_ = new QProgressBar(this);
  force_bar_->setRange(0, kForceSteps);
  force_bar_->setTextVisible(false);
  force_bar_->setFixedSize(70, 8);
  row->addWidget(force_bar_);
  force_ = add_text(row, "0.00 N of 3.3 N");
  contact_ = add_text(row, "contact, 000 ms old");
  limit_ = new QLabel(this);
  limit_->setObjectName("statusText");
  limit_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->addWidget(limit_, 1);

  inject_ = add_button(row, "Deposit", "Deposit while held down (D)");
  inject_->setShortcut(Qt::Key_D);
  connect(inject_, &QPushButton::pressed, this, [this] { actions_.inject(true); });
  connect(inject_, &QPushButton::released, this, [this] { actions_.inject(false); });
  retract_ = add_button(row, "Retract", "Take the pipette out along the line while held down (X)");
  retract_->setShortcut(Qt::Key_X);
  connect(retract_, &QPushButton::pressed, this, [this] { actions_.retract(true); });
  connect(retract_, &QPushButton::released, this, [this] { actions_.retract(false); });
  if (actions_.new_cell) {
    QPushButton* renew = add_button(row, "New cell", "A whole cell in the place of this one (C)");
    renew->setShortcut(Qt::Key_C);
    connect(renew, &QPushButton::clicked, this, [this] { actions_.new_cell(); });
  }
  stop_ = add_button(row, "STOP", "Halt the pipette and release the hand at once (Esc)");
  stop_->setObjectName("emergencyStop");
  stop_->setMinimumWidth(92);
  connect(stop_, &QPushButton::clicked, this, [this] { toggle_stop(); });
}

QLabel* HandBar::add_text(QHBoxLayout* row, const char* widest) {
  auto* label = new QLabel(this);
  label->setObjectName("statusText");
  QFont letters = label->font();
  letters.setPixelSize(12);
  label->setMinimumWidth(QFontMetrics(letters).horizontalAdvance(QString::fromUtf8(widest)) + 6);
  row->addWidget(label);
  return label;
}

QPushButton* HandBar::add_button(QHBoxLayout* row, const QString& text, const QString& tip) {
  auto* button = new QPushButton(text, this);
  button->setToolTip(tip);
  button->setFixedHeight(28);
  button->setFocusPolicy(Qt::TabFocus);
  row->addWidget(button);
  return button;
}

void HandBar::show_phrase(QLabel* label, const Phrase& phrase) {
  label->setText(QString::fromStdString(phrase.text));
  label->setStyleSheet("color: " + QString::fromStdString(phrase.color.css()));
}

void HandBar::show_texts(const HandTexts& texts) {
  state_->setText(QString::fromStdString(texts.state.text));
  state_->setStyleSheet("background: " + QString::fromStdString(texts.state.color.css()));
  force_bar_->setValue(static_cast<int>(kForceSteps * texts.force_share));
  show_phrase(force_, texts.force);
  show_phrase(contact_, texts.contact);
  show_phrase(limit_, texts.limit);
  limit_->setToolTip(QString::fromStdString(texts.limit.text));
  state_->setToolTip(QString::fromStdString(texts.loop.text));
  if (texts.stopped == stopped_) return;
  stopped_ = texts.stopped;
  stop_->setText(stopped_ ? "Release stop" : "STOP");
}

void HandBar::set_hand(int index) {
  const QSignalBlocker quiet(hand_);
  hand_->setCurrentIndex(index);
}

void HandBar::set_depth_stop_um(double depth_um) {
  const QSignalBlocker quiet(depth_stop_);
  depth_stop_->setValue(depth_um);
}

void HandBar::set_manual(bool manual) {
  inject_->setEnabled(manual);
  retract_->setEnabled(manual);
  scale_->setEnabled(manual);
}

void HandBar::toggle_stop() {
  actions_.stop(!stopped_);
}

}  // namespace pellucida
