#include "widgets/PixelSizeDialog.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "FramePicture.h"
#include "Words.h"
#include "widgets/CardFields.h"
#include "widgets/RulerCanvas.h"

namespace pellucida {
namespace {

constexpr int kLengthWidth_px = 150;

}  // namespace

PixelSizeDialog::PixelSizeDialog(std::string source, std::function<void(const PixelMeasure&)> use, QWidget* parent)
    : QDialog(parent), use_(std::move(use)) {
  setWindowTitle(words("Measure a pixel"));
  setObjectName("pixelSizeDialog");
  setAttribute(Qt::WA_DeleteOnClose);
  resize(820, 640);
  auto* column = new QVBoxLayout(this);
  column->setSpacing(10);
  auto* sentence = new QLabel(words(
      "Drag a line along a scale bar, or across a needle whose diameter you know; the longer, the more exact. The "
      "wheel zooms, Shift keeps the line level or upright, arrow keys move the end marked by a circle."));
  sentence->setWordWrap(true);
  column->addWidget(sentence);
  column->addWidget(ruler_ = new RulerCanvas([this] { show_measure(); }), 1);

  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  auto* caption = new QLabel(words("Its length"));
  row->addWidget(caption);
  length_ = make_number_line("µm", words("such as 100"), {});
  length_->setObjectName("knownLength");
  length_->setAccessibleName(caption->text());
  length_->setFixedWidth(kLengthWidth_px);
  caption->setBuddy(length_);
  row->addWidget(length_);
  result_ = new QLabel;
  result_->setObjectName("measuredPixel");
  result_->setWordWrap(true);
  row->addWidget(result_, 1);
  auto* cancel = new QPushButton(words("Cancel"));
  accept_ = new QPushButton(words("Use it"));
  accept_->setObjectName("usePixelSize");
  accept_->setDefault(true);
  for (QPushButton* button : {cancel, accept_}) {
    button->setFixedHeight(30);
    row->addWidget(button);
  }
  column->addLayout(row);
  connect(length_, &QLineEdit::textChanged, this, [this] { show_measure(); });
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(accept_, &QPushButton::clicked, this, [this] {
    use_(measure_pixel(ruler_->line(), length_->text().toStdString()));
    accept();
  });
  show_measure();
  load(source);
}

void PixelSizeDialog::load(const std::string& source) {
  result_->setText(words("Reading an image ..."));
  loading_.run(
      [this, source](const BackgroundTask::Control&) {
        const QImage picture = first_picture(source);
        return [this, picture] {
          ruler_->set_image(picture);
          length_->setFocus();
        };
      },
      {}, [this](const std::string& text) { result_->setText(QString::fromStdString(text)); });
}

void PixelSizeDialog::show_measure() {
  const PixelMeasure measure = measure_pixel(ruler_->line(), length_->text().toStdString());
  accept_->setEnabled(ruler_->has_image() && measure.pixel_size_um > 0.0);
  if (ruler_->has_image()) result_->setText(QString::fromStdString(measure.text));
}

}  // namespace pellucida
