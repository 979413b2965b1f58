#include "widgets/MembranePanel.h"

#include <vtkInteractorStyleTrackballCamera.h>

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QToolButton>

#include "Words.h"
#include "pellucida/visualization_vtk/MembraneView.h"
#include "widgets/ArrowMenu.h"
#include "widgets/KeySheet.h"
#include "widgets/ViewWidget.h"

namespace pellucida {

MembranePanel::MembranePanel(MembraneView& membranes, QWidget* parent)
    : MembranePanel(membranes, new ViewWidget(membranes, 0, nullptr), parent) {}

MembranePanel::MembranePanel(MembraneView& membranes, ViewWidget* view, QWidget* parent)
    : Panel(words("Forces in 3-D"), view, parent), view_(view) {
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  view_->set_style(style);
  explain_gesture(*view_, words("Drag, wheel"), words("Turn the view, zoom"));
  add_coloring_menu(membranes);
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

void MembranePanel::add_coloring_menu(MembraneView& membranes) {
  QToolButton* button = add_button({}, words("What the colour of the outer membrane shows"));
  button->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(button);
  auto* choice = new QActionGroup(menu);
  const std::pair<QString, SurfaceColoring> entries[] = {{words("Plain"), SurfaceColoring::kPlain},
                                                         {words("Tension"), SurfaceColoring::kTension},
                                                         {words("Displacement"), SurfaceColoring::kDisplacement}};
  for (const auto& [name, coloring] : entries) {
    QAction* action = choice->addAction(menu->addAction(name));
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [=, this, &membranes, text = QString(name), kind = coloring] {
      button->setText(words("Surface: %1 \u25BE").arg(text.toLower()));
      membranes.set_coloring(kind);
      view_->render();
    });
  }
  button->setText(words("Surface: plain \u25BE"));
  choice->actions().first()->setChecked(true);
  button->setMenu(menu);
}

}  // namespace pellucida
