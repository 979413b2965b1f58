#include "widgets/ParameterSlider.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <cmath>

#include "Theme.h"
#include "Words.h"
#include "pellucida/visualization/Palette.h"

namespace pellucida {
namespace {

constexpr int kPlaces = 1000;
constexpr int kHandleHalf_px = 7;  // of the theme's slider
constexpr int kStripHeight_px = 4;

// The wheel scrolls the page, not the number under the pointer.
class QuietSlider final : public QSlider {
 public:
  using QSlider::QSlider;

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

}  // namespace

/// The stable part of a slider's range as a strip below it.
class StableStrip final : public QWidget {
 public:
  explicit StableStrip(QWidget* parent) : QWidget(parent) { setFixedHeight(kStripHeight_px); }

  void show_part(double from, double to) {
    if (from == from_ && to == to_) return;
    from_ = from;
    to_ = to;
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    const double width = this->width() - 2.0 * kHandleHalf_px;
    const auto paint = [&](double from, double to, const Color& color) {
      painter.fillRect(QRectF(kHandleHalf_px + from * width, 0, (to - from) * width, kStripHeight_px), to_qt(color));
    };
    paint(0.0, 1.0, current_theme().record);
    paint(from_, to_, current_theme().good);
  }

 private:
  double from_ = 0.0;
  double to_ = 1.0;
};

ParameterSlider::ParameterSlider(const NumberScale& scale, std::function<void(double)> changed, QWidget* parent)
    : QWidget(parent), scale_(scale), changed_(std::move(changed)) {
  setToolTip(words(scale_.tip));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(3);
  auto* head = new QHBoxLayout;
  auto* name = new QLabel(words(scale_.name), this);
  name->setObjectName("parameterName");
  head->addWidget(name);
  head->addStretch(1);
  value_ = new QLabel(this);
  value_->setObjectName("parameterValue");
  head->addWidget(value_);
  column->addLayout(head);

  slider_ = new QuietSlider(Qt::Horizontal, this);
  slider_->setRange(0, kPlaces);
  slider_->setSingleStep(std::max(1, static_cast<int>(std::lround(kPlaces * scale_.key_step))));
  slider_->setPageStep(10 * slider_->singleStep());
  slider_->setFocusPolicy(Qt::StrongFocus);
  slider_->setAccessibleName(name->text());
  name->setBuddy(slider_);
  column->addWidget(slider_);
  column->addWidget(strip_ = new StableStrip(this));
  note_ = new QLabel(this);
  note_->setObjectName("parameterNote");
  column->addWidget(note_);
  strip_->hide();
  note_->hide();
  connect(slider_, &QSlider::valueChanged, this, [this](int place) {
    const double value = scale_.value_at(static_cast<double>(place) / kPlaces);
    show_text(value);
    changed_(value);
  });
}

void ParameterSlider::show_value(double value) {
  if (slider_->isSliderDown()) return;
  const QSignalBlocker quiet(slider_);
  slider_->setValue(static_cast<int>(std::lround(kPlaces * scale_.place_of(value))));
  show_text(value);
}

// The value is also what a screen reader says of the slider.
void ParameterSlider::show_text(double value) {
  const QString text = QString::fromStdString(scale_.text(value));
  value_->setText(text);
  slider_->setAccessibleDescription(text);
}

void ParameterSlider::show_stable_part(const StablePart& part) {
  const bool known = !part.text.empty();
  strip_->setVisible(known);
  note_->setVisible(known);
  strip_->show_part(part.from, part.to);
  note_->setText(QString::fromStdString(part.text));
}

}  // namespace pellucida
