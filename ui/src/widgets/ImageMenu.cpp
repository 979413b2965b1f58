#include "widgets/ImageMenu.h"

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QSlider>
#include <QWidgetAction>
#include <cmath>

#include "Words.h"
#include "pellucida/visualization_vtk/FeedView.h"

namespace pellucida {
namespace {

// The contrast doubles with so many steps of its slider.
constexpr double kStepsPerDoubling = 20.0;

}  // namespace

ImageMenu::ImageMenu(FeedView& view, std::function<void()> changed, QWidget* parent)
    : QToolButton(parent), view_(view), changed_(std::move(changed)) {
  setObjectName("image");
  setText(words("Image \u25BE"));
  setToolTip(words("How much of the image is shown, and how bright: the measurement stays the same"));
  setProperty("flat", true);
  setFocusPolicy(Qt::TabFocus);
  setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(this);
  QAction* whole = menu->addAction(words("Whole frame"));
  whole->setObjectName("wholeFrame");
  whole->setCheckable(true);
  whole->setShortcut(Qt::Key_W);
  connect(whole, &QAction::toggled, this, [this](bool on) {
    view_.set_framing(on ? FeedFraming::kFrame : FeedFraming::kCell);
    changed_();
  });
  QAction* reset = menu->addAction(words("Undo panning and zooming"));
  reset->setShortcut(Qt::Key_F);
  connect(reset, &QAction::triggered, this, [this] {
    view_.reset_camera();
    changed_();
  });
  menu->addSeparator();
  follows_ = menu->addAction(words("Black and white follow the image"));
  follows_->setObjectName("imageFollows");
  follows_->setCheckable(true);
  connect(follows_, &QAction::toggled, this, [this](bool on) {
    ImageLook look = view_.image_look();
    look.follows = on;
    apply(look);
  });
  auto* sliders = new QWidgetAction(menu);
  sliders->setDefaultWidget(build_look());
  menu->addAction(sliders);
  QAction* normal = menu->addAction(words("As at the start"));
  connect(normal, &QAction::triggered, this, [this] { apply({}); });
  // Keys of a menu that isn't open act too.
  addActions({whole, reset});
  setMenu(menu);
  show_look();
}

QWidget* ImageMenu::build_look() {
  auto* box = new QWidget;
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(10, 6, 10, 6);
  grid->setHorizontalSpacing(12);
  const auto add = [&](int row, const QString& name, const char* key, int most) {
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setObjectName(key);
    slider->setAccessibleName(name);
    slider->setRange(-most, most);
    slider->setFixedWidth(170);
    grid->addWidget(new QLabel(name), row, 0);
    grid->addWidget(slider, row, 1);
    numbers_[row] = new QLabel;
    numbers_[row]->setMinimumWidth(52);
    numbers_[row]->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    grid->addWidget(numbers_[row], row, 2);
    connect(slider, &QSlider::valueChanged, this, [this] {
      ImageLook look = view_.image_look();
      look.brightness = brightness_->value() / 100.0;
      look.contrast = std::pow(2.0, contrast_->value() / kStepsPerDoubling);
      apply(look);
    });
    return slider;
  };
  brightness_ = add(0, words("Brightness"), "brightness", 100);
  contrast_ = add(1, words("Contrast"), "contrast", 60);
  auto* note = new QLabel(words("On the screen alone: the measurement stays the same."));
  note->setProperty("figureNote", true);
  grid->addWidget(note, 2, 0, 1, 3);
  return box;
}

void ImageMenu::apply(const ImageLook& look) {
  view_.set_image_look(look);
  show_look();
  changed_();
}

void ImageMenu::show_look() {
  const ImageLook& look = view_.image_look();
  const QSignalBlocker quiet_follows(follows_), quiet_brightness(brightness_), quiet_contrast(contrast_);
  follows_->setChecked(look.follows);
  brightness_->setValue(static_cast<int>(std::lround(100.0 * look.brightness)));
  contrast_->setValue(static_cast<int>(std::lround(kStepsPerDoubling * std::log2(look.contrast))));
  numbers_[0]->setText(QString("%1 %").arg(brightness_->value()));
  numbers_[1]->setText(QString::fromUtf8("\u00D7 %1").arg(look.contrast, 0, 'f', 2));
}

}  // namespace pellucida
