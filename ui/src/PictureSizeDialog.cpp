#include "PictureSizeDialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>
#include <cmath>

#include "Words.h"
#include "widgets/Choice.h"

namespace pellucida {
namespace {

constexpr int kLeast_px = 100;
constexpr int kFactors[] = {1, 2, 4};

QSpinBox* new_length(int value, const QString& name) {
  auto* length = new QSpinBox;
  length->setRange(kLeast_px, PictureSizeDialog::kMost_px);
  length->setSuffix(" px");
  length->setValue(value);
  length->setAccessibleName(name);
  return length;
}

}  // namespace

PictureSizeDialog::PictureSizeDialog(const QString& title, QSize seen, bool keeps_shape, QWidget* parent)
    : QDialog(parent), seen_(seen), keeps_shape_(keeps_shape) {
  setWindowTitle(title);
  auto* form = new QFormLayout(this);
  choice_ = new Choice;
  choice_->setObjectName("pictureSize");
  choice_->setAccessibleName(words("Size of the picture"));
  for (const int factor : kFactors) {
    const QSize size = factor * seen;
    if (std::max(size.width(), size.height()) > kMost_px) continue;
    const QString name = factor == 1 ? QString(words("as on screen")) : QString(words("%1 times")).arg(factor);
    choice_->addItem(QString("%1, %2 \u00D7 %3 px").arg(name).arg(size.width()).arg(size.height()), size);
  }
  choice_->addItem(words("a size of your own"));
  form->addRow(words("Size"), choice_);
  width_ = new_length(seen.width(), words("Width"));
  height_ = new_length(seen.height(), words("Height"));
  width_->setObjectName("pictureWidth");
  height_->setObjectName("pictureHeight");
  auto* lengths = new QHBoxLayout;
  lengths->addWidget(width_);
  lengths->addWidget(new QLabel("\u00D7"));
  lengths->addWidget(height_);
  form->addRow(words("Width and height"), lengths);
  auto* text = new QLabel(words("Drawn anew at this size: lines and letters stay sharp."));
  text->setWordWrap(true);
  form->addRow(text);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(choice_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int index) { choose(index); });
  connect(width_, qOverload<int>(&QSpinBox::valueChanged), this, [this](int width_px) { follow_width(width_px); });
  choose(0);
}

void PictureSizeDialog::choose(int index) {
  const QVariant size = choice_->itemData(index);
  const bool own = !size.isValid();
  width_->setEnabled(own);
  height_->setEnabled(own && !keeps_shape_);
  if (own) return;
  const QSignalBlocker quiet(width_);
  width_->setValue(size.toSize().width());
  height_->setValue(size.toSize().height());
}

void PictureSizeDialog::follow_width(int width_px) {
  if (keeps_shape_) height_->setValue(static_cast<int>(std::lround(1.0 * width_px * seen_.height() / seen_.width())));
}

QSize PictureSizeDialog::chosen() const {
  return {width_->value(), height_->value()};
}

}  // namespace pellucida
