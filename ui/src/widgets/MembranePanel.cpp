#include "widgets/MembranePanel.h"

#include <vtkInteractorStyleTrackballCamera.h>

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QToolButton>

#include "WindowMemory.h"
#include "Words.h"
#include "pellucida/visualization_vtk/MembraneView.h"
#include "widgets/ArrowMenu.h"
#include "widgets/KeySheet.h"
#include "widgets/ViewWidget.h"

namespace pellucida {

MembranePanel::MembranePanel(MembraneView& membranes, QWidget* parent, bool has_model)
    : MembranePanel(membranes, new ViewWidget(membranes, 0, nullptr), parent, has_model) {}

MembranePanel::MembranePanel(MembraneView& membranes, ViewWidget* view, QWidget* parent, bool has_model)
    : Panel(words("Forces in 3-D"), view, parent), view_(view) {
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  view_->set_style(style);
  explain_gesture(*view_, words("Drag, wheel"), words("Turn the view, zoom"));
  add_surface_menu(membranes, has_model);
  add_control(new ArrowMenu(
      membranes, [this] { view_->render(); }, this));
  connect(add_toggle(words("Tools"), words("Needle and holding pipette"), Qt::Key_4, true), &QToolButton::toggled, this,
          [this, &membranes](bool on) {
            membranes.show_tools(on);
            view_->render();
          });
  connect(add_button(words("Reset"), words("Back to the first point of view"), Qt::Key_V), &QToolButton::clicked, this,
          [this, &membranes] {
            membranes.reset_camera();
            view_->render();
          });
}

void MembranePanel::add_surface_menu(MembraneView& membranes, bool has_model) {
  QToolButton* button =
      add_button({}, words("What the colour of the outer membrane shows; key 8 shows the next quantity"));
  button->setObjectName("surface");
  button->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(button);
  menu->setToolTipsVisible(true);
  auto* choice = new QActionGroup(menu);
  const auto show = [button](SurfaceColoring coloring) {
    button->setText(words("Surface: %1 \u25BE").arg(QString::fromStdString(coloring_name(coloring)).toLower()));
  };
  for (const SurfaceColoring coloring : kSurfaceColorings) {
    QAction* action = choice->addAction(menu->addAction(QString::fromStdString(coloring_name(coloring))));
    action->setObjectName("coloring" + QString::number(static_cast<int>(coloring)));
    action->setToolTip(QString::fromStdString(coloring_explanation(coloring)));
    action->setCheckable(true);
    keep_as(*action, QString("surface_%1").arg(static_cast<int>(coloring)));
    action->setChecked(coloring == membranes.coloring());
    connect(action, &QAction::toggled, this, [=, this, &membranes](bool on) {
      if (!on) return;
      show(coloring);
      membranes.set_coloring(coloring);
      view_->render();
    });
  }
  show(membranes.coloring());
  auto* next = new QAction(words("The next colouring of the surface"), this);
  next->setObjectName("nextColoring");
  next->setText(words("Surface: the next quantity"));
  next->setShortcut(Qt::Key_8);
  addAction(next);
  connect(next, &QAction::triggered, this, [choice] {
    const QList<QAction*> all = choice->actions();
    all[(all.indexOf(choice->checkedAction()) + 1) % all.size()]->setChecked(true);
  });

  menu->addSeparator();
  QAction* model = menu->addAction(words("The model's own surface"));
  model->setObjectName("modelSurface");
  model->setCheckable(true);
  model->setEnabled(has_model);
  model->setToolTip(has_model ? words("The mesh that the forces are computed on, as a wire: where it leaves the seen "
                                      "surface, model and image disagree")
                              : words("A recording doesn't hold the model's mesh"));
  if (has_model) {
    model->setShortcut(Qt::Key_5);
    // The key of a menu that isn't open acts too.
    addAction(model);
  }
  connect(model, &QAction::toggled, this, [this, &membranes](bool on) {
    membranes.show_model(on);
    view_->render();
  });
  button->setMenu(menu);
}

}  // namespace pellucida
