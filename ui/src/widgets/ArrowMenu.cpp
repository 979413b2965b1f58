#include "widgets/ArrowMenu.h"

#include <QAction>
#include <QButtonGroup>
#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QRadioButton>
#include <QSlider>
#include <QWidgetAction>
#include <cmath>

#include "WindowMemory.h"
#include "Words.h"
#include "pellucida/visualization_vtk/MembraneView.h"

namespace pellucida {
namespace {

// A slider with its name and its value in words.
void add_slider(QGridLayout* grid, const char* key, const QString& name, int least, int most, int value,
                const std::function<QString(int)>& apply) {
  const int row = grid->rowCount();
  auto* slider = new QSlider(Qt::Horizontal);
  slider->setRange(least, most);
  slider->setFixedWidth(170);
  keep_as(*slider, key);
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

ArrowMenu::ArrowMenu(MembraneView& view, std::function<void()> changed, QWidget* parent)
    : QToolButton(parent), view_(view), changed_(std::move(changed)) {
  setObjectName("arrows");
  setProperty("flat", true);
  setFocusPolicy(Qt::TabFocus);
  setPopupMode(QToolButton::InstantPopup);

  auto* box = new QWidget;
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(10, 8, 10, 8);
  grid->setHorizontalSpacing(14);
  grid->setVerticalSpacing(5);
  add_kinds(grid);
  add_looks(grid);
  show_kind();

  auto* menu = new QMenu(this);
  auto* action = new QWidgetAction(menu);
  action->setDefaultWidget(box);
  menu->addAction(action);
  setMenu(menu);
}

// Which force: its name, and below it what it is.
void ArrowMenu::add_kinds(QGridLayout* grid) {
  constexpr int kSentence_px = 330;
  auto* kinds = new QButtonGroup(this);
  for (const NodeForceKind kind : kNodeForceKinds) {
    auto* button = new QRadioButton(QString::fromStdString(node_force_name(kind)));
    button->setObjectName("nodeForce" + QString::number(static_cast<int>(kind)));
    keep_as(*button, button->objectName());
    button->setAccessibleDescription(QString::fromStdString(node_force_explanation(kind)));
    button->setChecked(kind == view_.node_force());
    kinds->addButton(button, static_cast<int>(kind));
    auto* sentence = new QLabel(QString::fromStdString(node_force_explanation(kind)));
    sentence->setProperty("figureNote", true);
    sentence->setWordWrap(true);
    sentence->setContentsMargins(21, 0, 0, 4);
    sentence->setFixedWidth(kSentence_px);
    const int row = grid->rowCount();
    grid->addWidget(button, row, 0, 1, 3);
    grid->addWidget(sentence, row + 1, 0, 1, 3);
  }
  connect(kinds, &QButtonGroup::idToggled, this, [this](int id, bool on) {
    if (!on) return;
    view_.set_node_force(static_cast<NodeForceKind>(id));
    show_kind();
    changed_();
  });
  auto* next = new QAction(words("Arrows show the next force"), this);
  next->setObjectName("nextNodeForce");
  next->setText(words("Arrows: the next force"));
  next->setShortcut(Qt::Key_7);
  addAction(next);
  connect(next, &QAction::triggered, this, [kinds] {
    kinds->button((kinds->checkedId() + 1) % static_cast<int>(kNodeForceKinds.size()))->setChecked(true);
  });
}

void ArrowMenu::show_kind() {
  setText(words("Arrows \u25BE"));
  setToolTip(words("Which forces on the membrane the arrows show, and how. Now: ") +
             QString::fromStdString(node_force_name(view_.node_force())) +
             words("; key 6 shows or hides them, key 7 shows the next force"));
}

void ArrowMenu::add_looks(QGridLayout* grid) {
  const auto add_check = [&](const char* key, const QString& name, bool on, const std::function<void(bool)>& apply) {
    auto* box = new QCheckBox(name);
    box->setChecked(on);
    keep_as(*box, key);
    grid->addWidget(box, grid->rowCount(), 0, 1, 3);
    connect(box, &QCheckBox::toggled, this, [this, apply](bool now) {
      apply(now);
      changed_();
    });
    return box;
  };
  auto* shown = add_check("arrows_shown", words("Show node forces"), true, [this](bool on) { view_.show_arrows(on); });
  auto* toggle = new QAction(words("Arrows on and off"), this);
  toggle->setObjectName("showArrows");
  toggle->setText(words("Show or hide the arrows"));
  toggle->setShortcut(Qt::Key_6);
  addAction(toggle);
  connect(toggle, &QAction::triggered, shown, &QCheckBox::toggle);
  add_check("arrows_intervals", words("95 % interval at each arrow"), false, [this](bool on) {
    view_.show_error_bars(on);
  })->setObjectName("errorBars");
  add_slider(grid, "arrows_most", words("Most arrows"), 20, 1000, 250, [this](int v) {
    view_.set_arrow_count(v);
    changed_();
    return QString::number(v);
  });
  // Lengths from a quarter to four times, in equal ratios.
  add_slider(grid, "arrows_length", words("Length"), -20, 20, 0, [this](int v) {
    const double scale = std::pow(2.0, v / 10.0);
    view_.set_arrow_scale(scale);
    changed_();
    return QString::fromUtf8("\u00D7 %1").arg(scale, 0, 'f', 2);
  });
  add_slider(grid, "arrows_hidden_below", words("Hide below"), 0, 50, 1, [this](int v) {
    view_.set_arrow_threshold(v / 100.0);
    changed_();
    return QString("%1 %").arg(v);
  });
  add_check("arrows_logarithm", words("Lengths by the logarithm"), false,
            [this](bool on) { view_.set_arrow_log_scale(on); });
}

}  // namespace pellucida
