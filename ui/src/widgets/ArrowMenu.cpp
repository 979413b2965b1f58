#include "widgets/ArrowMenu.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QSlider>
#include <QWidgetAction>
#include <cmath>

#include "Words.h"
#include "pellucida/visualization_vtk/MembraneView.h"

namespace pellucida {
namespace {

// A slider with its name and its value in words.
void add_slider(QGridLayout* grid, const QString& name, int least, int most, int value,
                const std::function<QString(int)>& apply) {
  const int row = grid->rowCount();
  auto* slider = new QSlider(Qt::Horizontal);
  slider->setRange(least, most);
  slider->setFixedWidth(170);
  auto* shown = new QLabel;
  shown->setMinimumWidth(48);
  shown->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  grid->addWidget(new QLabel(name), row, 0);
  grid->addWidget(slider, row, 1);
  grid->addWidget(shown, row, 2);
  QObject::connect(slider, &QSlider::valueChanged, slider, [=](int v) { shown->setText(apply(v)); });
  slider->setValue(value);
  shown->setText(apply(value));
}

}  // namespace

ArrowMenu::ArrowMenu(MembraneView& view, std::function<void()> changed, QWidget* parent) : QToolButton(parent) {
  setText(words("Arrows \u25BE"));
  setToolTip(words("How the forces on the membrane are drawn"));
  setProperty("flat", true);
  setFocusPolicy(Qt::TabFocus);
  setPopupMode(QToolButton::InstantPopup);

  auto* box = new QWidget;
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(10, 8, 10, 8);
  grid->setHorizontalSpacing(14);
  grid->setVerticalSpacing(10);
  auto* shown = new QCheckBox(words("Show node forces"));
  shown->setChecked(true);
  grid->addWidget(shown, 0, 0, 1, 3);
  connect(shown, &QCheckBox::toggled, this, [&view, changed](bool on) {
    view.show_arrows(on);
    changed();
  });
  add_slider(grid, words("Most arrows"), 20, 1000, 250, [&view, changed](int v) {
    view.set_arrow_count(v);
    changed();
    return QString::number(v);
  });
  // Lengths from a quarter to four times, in equal ratios.
  add_slider(grid, words("Length"), -20, 20, 0, [&view, changed](int v) {
    const double scale = std::pow(2.0, v / 10.0);
    view.set_arrow_scale(scale);
    changed();
    return QString::fromUtf8("\u00D7 %1").arg(scale, 0, 'f', 2);
  });
  add_slider(grid, words("Hide below"), 0, 50, 1, [&view, changed](int v) {
    view.set_arrow_threshold(v / 100.0);
    changed();
    return QString("%1 %").arg(v);
  });
  auto* logarithm = new QCheckBox(words("Lengths by the logarithm"));
  grid->addWidget(logarithm, grid->rowCount(), 0, 1, 3);
  connect(logarithm, &QCheckBox::toggled, this, [&view, changed](bool on) {
    view.set_arrow_log_scale(on);
    changed();
  });

  auto* menu = new QMenu(this);
  auto* action = new QWidgetAction(menu);
  action->setDefaultWidget(box);
  menu->addAction(action);
  setMenu(menu);
}

}  // namespace pellucida
