#include "widgets/HandBar.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyle>
#include <QVBoxLayout>
#include <QWheelEvent>

#include "Theme.h"
#include "Words.h"
#include "pellucida/visualization/Palette.h"
#include "presenters/HandPresenter.h"
#include "widgets/ButtonKey.h"
#include "widgets/Choice.h"
#include "widgets/HoldButton.h"
#include "widgets/KeySheet.h"
#include "widgets/PhraseLabel.h"

namespace pellucida {
namespace {

constexpr int kForceSteps = 1000;
constexpr double kShallowest_um = 1.0;
constexpr double kDeepest_um = 200.0;
// What the console calls hands and motions, for lupdate.
[[maybe_unused]] constexpr const char* kConsoleNames[] = {
    PELLUCIDA_WORDS("Demonstration"), PELLUCIDA_WORDS("Mouse and keyboard"), PELLUCIDA_WORDS("Coarse 100:1"),
    PELLUCIDA_WORDS("Fine 500:1"), PELLUCIDA_WORDS("Finest 2000:1")};
constexpr const char* kStopText = PELLUCIDA_WORDS("STOP");

// A number that the wheel changes only while the box has the focus.
class DepthBox final : public QDoubleSpinBox {
 public:
  using QDoubleSpinBox::QDoubleSpinBox;

 protected:
  void wheelEvent(QWheelEvent* event) override {
    if (hasFocus()) {
      QDoubleSpinBox::wheelEvent(event);
    } else {
      event->ignore();
    }
  }
};

}  // namespace

HandBar::HandBar(const QStringList& hands, const QStringList& scales, Actions actions, QWidget* parent)
    : QFrame(parent), actions_(std::move(actions)) {
  setObjectName("handBar");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(76);
  set_key_group(*this, words("Hand"));
  // What the hand does above, what can be done below; the stop beside both.
  auto* bar = new QHBoxLayout(this);
  bar->setContentsMargins(16, 7, 16, 8);
  bar->setSpacing(18);
  auto* lines = new QVBoxLayout;
  lines->setSpacing(7);
  bar->addLayout(lines, 1);
  lines->addLayout(build_readouts());
  lines->addLayout(build_controls(hands, scales));
  build_stop(bar);
}

void HandBar::build_stop(QHBoxLayout* bar) {
  release_ = new HoldButton(
      words("Release\n(hold)"), [this] { actions_.release_stop(); }, this);
  release_->setObjectName("releaseStop");
  release_->setToolTip(
      tip_with_key(words("Hold for a second to release the emergency stop"), QKeySequence("Shift+Esc")));
  release_->setFocusPolicy(Qt::NoFocus);
  release_->setFixedSize(96, 54);
  release_->hide();
  bar->addWidget(release_);
  stop_ = new QPushButton(words(kStopText), this);
  stop_->setObjectName("emergencyStop");
  stop_->setToolTip(tip_with_key(words("Stop the pipette and release the force on the hand at once"), Qt::Key_Escape));
  stop_->setFocusPolicy(Qt::TabFocus);
  stop_->setFixedSize(132, 54);
  bar->addWidget(stop_);
  // When the button goes down, not when it comes up again.
  connect(stop_, &QPushButton::pressed, this, [this] { actions_.stop(); });
}

QHBoxLayout* HandBar::build_readouts() {
  auto* row = new QHBoxLayout;
  row->setSpacing(14);
  auto* title = new QLabel(words("HAND"), this);
  title->setObjectName("readoutName");
  row->addWidget(title);
  state_ = new QLabel(this);
  state_->setObjectName("handPill");
  state_->setAlignment(Qt::AlignCenter);
  state_->setFixedSize(92, 22);
  row->addWidget(state_);
  force_bar_ = new QProgressBar(this);
  force_bar_->setRange(0, kForceSteps);
  force_bar_->setTextVisible(false);
  force_bar_->setFixedSize(96, 8);
  force_bar_->setToolTip(words("Force on the hand; full: the largest force of the device"));
  row->addWidget(force_bar_);
  force_ = add_phrase_label(*row, words("0.00 N of 0.0 N"));
  contact_ = add_phrase_label(*row, words("Punctured, 000 ms old"));
  plane_ = add_phrase_label(*row, "z +000.0 µm");
  plane_->setObjectName("tipPlane");
  plane_->setToolTip(
      words("How far the tip is out of the image plane, as the manipulator reports it: above 0 behind it, away from "
            "you; below 0 before it"));
  // The rest of the line; a long text must not widen the window.
  note_ = new QLabel(this);
  note_->setObjectName("statusText");
  note_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->addWidget(note_, 1);
  return row;
}

QHBoxLayout* HandBar::build_controls(const QStringList& hands, const QStringList& scales) {
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  hand_ = add_choice(row, hands, words("What moves the pipette"));
  connect(hand_, qOverload<int>(&QComboBox::activated), this, [this](int index) { actions_.choose_hand(index); });
  scale_ = add_choice(row, scales, words("Motion of the tip: 100:1 is 100 \u00b5m for 10 mm of the hand"));
  connect(scale_, qOverload<int>(&QComboBox::activated), this, [this](int index) { actions_.choose_scale(index); });
  row->addSpacing(8);

  guide_ = add_button(row, words("Guide"));
  bind_key(*guide_, Qt::Key_G, words("Keep the tip on the planned line, in and out"));
  guide_->setObjectName("guide");
  guide_->setCheckable(true);
  guide_->setChecked(true);
  connect(guide_, &QPushButton::toggled, this, [this](bool on) { actions_.guide(on); });
  auto* stop_name = new QLabel(words("Depth stop"), this);
  stop_name->setObjectName("statusText");
  row->addWidget(stop_name);
  depth_stop_ = new DepthBox(this);
  depth_stop_->setRange(kShallowest_um, kDeepest_um);
  depth_stop_->setDecimals(0);
  depth_stop_->setSuffix(QString::fromUtf8(" \u00b5m"));
  depth_stop_->setToolTip(words("The tip goes no deeper than this beyond the entry"));
  depth_stop_->setAccessibleName(words("Depth stop"));
  depth_stop_->setFocusPolicy(Qt::StrongFocus);
  depth_stop_->setKeyboardTracking(false);
  depth_stop_->setButtonSymbols(QAbstractSpinBox::NoButtons);  // wheel, arrow keys, digits
  depth_stop_->setFixedSize(68, 28);
  row->addWidget(depth_stop_);
  connect(depth_stop_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this](double depth_um) { actions_.depth_stop(depth_um); });
  // The window's keys work again once a number has been typed.
  connect(depth_stop_, &QDoubleSpinBox::editingFinished, depth_stop_, &QWidget::clearFocus);

  row->addStretch(1);
  inject_ = add_button(row, words("Deposit"));
  inject_->setToolTip(tip_with_key(words("Deposit while held down"), Qt::Key_D));
  connect(inject_, &QPushButton::pressed, this, [this] { actions_.inject(true); });
  connect(inject_, &QPushButton::released, this, [this] { actions_.inject(false); });
  retract_ = add_button(row, words("Retract"));
  retract_->setToolTip(tip_with_key(words("Take the pipette out along its axis while held down"), Qt::Key_X));
  connect(retract_, &QPushButton::pressed, this, [this] { actions_.retract(true); });
  connect(retract_, &QPushButton::released, this, [this] { actions_.retract(false); });
  if (actions_.new_cell) {
    QPushButton* renew = add_button(row, words("New cell"));
    bind_key(*renew, Qt::Key_C, words("Take the needle out, then replace the cell by an intact one"));
    connect(renew, &QPushButton::clicked, this, [this] { actions_.new_cell(); });
  }
  return row;
}

QComboBox* HandBar::add_choice(QHBoxLayout* row, const QStringList& names, const QString& tip) {
  auto* choice = new Choice(this);
  for (const QString& name : names) choice->addItem(words(name.toUtf8().constData()));
  choice->setToolTip(tip);
  choice->setAccessibleName(tip);
  choice->setFocusPolicy(Qt::TabFocus);
  choice->setFixedHeight(28);
  row->addWidget(choice);
  return choice;
}

QPushButton* HandBar::add_button(QHBoxLayout* row, const QString& text) {
  auto* button = new QPushButton(text, this);
  button->setFixedHeight(28);
  button->setFocusPolicy(Qt::TabFocus);
  // Wide enough for the bold letters that a checked one has.
  QFont letters = button->font();
  letters.setPixelSize(12);
  letters.setBold(true);
  button->setMinimumWidth(QFontMetrics(letters).horizontalAdvance(text) + 28);
  row->addWidget(button);
  return button;
}

void HandBar::show_texts(const HandTexts& texts) {
  state_->setText(QString::fromStdString(texts.state.text));
  set_sheet(*state_, "background: " + QString::fromStdString(texts.state.color.css()));
  force_bar_->setValue(static_cast<int>(kForceSteps * texts.force_share));
  show_phrase(*force_, texts.force);
  show_phrase(*contact_, texts.contact);
  show_phrase(*plane_, texts.plane);
  show_phrase(*note_, texts.note);
  // A narrow window shows the beginning; the tool tip shows all of it.
  const QString note = QString::fromStdString(texts.note.text);
  note_->setText(note_->fontMetrics().elidedText(note, Qt::ElideRight, note_->width()));
  note_->setToolTip(note);
  state_->setToolTip(QString::fromStdString(texts.loop.text));
  if (texts.stopped == stopped_) return;
  stopped_ = texts.stopped;
  stop_->setText(stopped_ ? words("STOPPED") : words(kStopText));
  stop_->setProperty("latched", stopped_);
  stop_->style()->unpolish(stop_);
  stop_->style()->polish(stop_);
  release_->setVisible(stopped_);
}

void HandBar::set_choice(int hand, int scale) {
  const QSignalBlocker quiet_hand(hand_), quiet_scale(scale_);
  hand_->setCurrentIndex(hand);
  scale_->setCurrentIndex(scale);
}

void HandBar::set_depth_stop_um(double depth_um) {
  // Not while the user types.
  if (depth_stop_->hasFocus()) return;
  const QSignalBlocker quiet(depth_stop_);
  depth_stop_->setEnabled(depth_um > 0.0);
  depth_stop_->setSpecialValueText(depth_um > 0.0 ? QString() : QString::fromUtf8("\u2013"));
  depth_stop_->setValue(depth_um);
}

void HandBar::set_manual(bool manual) {
  inject_->setEnabled(manual);
  retract_->setEnabled(manual);
  scale_->setEnabled(manual);
}

void HandBar::set_guided(bool on) {
  guide_->setChecked(on);
}

void HandBar::hold_release(bool held) {
  release_->hold(held && stopped_);
}

void HandBar::explain_late_stop(const std::string& reason) {
  stop_->setToolTip(stop_->toolTip() + words("; waits until a rendering has finished: ") +
                    QString::fromStdString(reason));
}

const QWidget& HandBar::stop_button() const {
  return *stop_;
}

}  // namespace pellucida
