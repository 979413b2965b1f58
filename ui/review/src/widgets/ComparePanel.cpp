#include "widgets/ComparePanel.h"

#include <vtkInteractorStyleTrackballCamera.h>

#include <QGridLayout>
#include <QLabel>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "Words.h"
#include "pellucida/visualization_vtk/PanZoomStyle.h"
#include "widgets/Choice.h"
#include "widgets/CurvePanel.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

constexpr int kViewHeight_px = 170;
constexpr int kColumns = 4;  // name, this session, the other one, their difference
enum StackedView { kImageView, kForceView };

QLabel* add_cell(QGridLayout* grid, int row, int column) {
  auto* cell = new QLabel;
  cell->setObjectName(column == 0 || row == 0 ? "nodeFactName" : "nodeFact");
  cell->setTextFormat(Qt::PlainText);
  cell->setAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  grid->addWidget(cell, row, column);
  return cell;
}

QComboBox* add_choice(Panel& panel, const char* name, const QString& tip) {
  auto* choice = new Choice;
  choice->setObjectName(name);
  choice->setToolTip(tip);
  choice->setAccessibleName(tip);
  choice->setFocusPolicy(Qt::TabFocus);
  choice->setFixedHeight(26);
  panel.add_control(choice);
  return choice;
}

}  // namespace

ComparePanel::ComparePanel(Actions actions, QWidget* parent) : QWidget(parent), actions_(std::move(actions)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  head_ = new Panel(words("Compared with"), build_views(), this);
  view_choice_ = add_choice(*head_, "compareView", words("What is shown of the other session"));
  view_choice_->addItems({words("image"), words("forces in 3-D")});
  connect(view_choice_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int index) {
    views_->setCurrentIndex(index);
    refresh_view();
  });
  connect(head_->add_button(words("Close"), words("Compare no more")), &QToolButton::clicked, this,
          [this] { actions_.close(); });
  column->addWidget(head_, 1);
  column->addWidget(build_table());
  curve_ = new CurvePanel(words("Difference"), {}, this);
  alignment_ = add_choice(*curve_, "compareAlignment", words("Which frames of both sessions belong together"));
  for (const Alignment alignment : kAlignments) alignment_->addItem(QString::fromStdString(name_of(alignment)));
  connect(alignment_, qOverload<int>(&QComboBox::currentIndexChanged), this,
          [this](int index) { actions_.align(kAlignments[static_cast<std::size_t>(std::max(index, 0))]); });
  connect(curve_->add_button("SVG", words("Save the difference as SVG, PDF or PNG")), &QToolButton::clicked, this,
          [this] { actions_.save_chart(); });
  connect(curve_->add_button("CSV", words("Save the difference as a table")), &QToolButton::clicked, this,
          [this] { actions_.save_table(); });
  column->addWidget(curve_, 1);
}

// The widgets show the views: they go first.
ComparePanel::~ComparePanel() {
  delete image_;
  delete forces_;
}

QWidget* ComparePanel::build_views() {
  auto* box = new QWidget;
  box->setObjectName("nodeFacts");
  box->setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  name_ = new QLabel;
  name_->setObjectName("panelTitle");
  name_->setTextFormat(Qt::PlainText);
  name_->setContentsMargins(12, 2, 12, 4);
  name_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  column->addWidget(name_);
  text_ = new QLabel;
  text_->setObjectName("pageText");
  text_->setTextFormat(Qt::PlainText);
  text_->setWordWrap(true);
  text_->setAlignment(Qt::AlignCenter);
  column->addWidget(text_, 1);
  feed_.show_legend(false);
  feed_.set_empty_text(words("No frame at the same place"));
  membranes_.set_empty_text(words("No surface at the same place"));
  views_ = new QStackedWidget;
  views_->addWidget(image_ = new ViewWidget(feed_, 0, nullptr));
  views_->addWidget(forces_ = new ViewWidget(membranes_, 0, nullptr));
  views_->setMinimumHeight(kViewHeight_px);
  vtkNew<PanZoomStyle> pan;
  image_->set_style(pan);
  vtkNew<vtkInteractorStyleTrackballCamera> turn;
  forces_->set_style(turn);
  // What is dropped on a view is for the window.
  for (ViewWidget* view : {image_, forces_}) view->setAcceptDrops(false);
  column->addWidget(views_, 1);
  return box;
}

QWidget* ComparePanel::build_table() {
  auto* box = new QWidget;
  box->setObjectName("nodeFacts");
  box->setAttribute(Qt::WA_StyledBackground);
  table_ = new QGridLayout(box);
  table_->setContentsMargins(12, 6, 12, 8);
  table_->setHorizontalSpacing(10);
  table_->setVerticalSpacing(1);
  for (int column = 1; column < kColumns; ++column) table_->setColumnStretch(column, 1);
  int column = 0;
  for (const QString& title :
       {QString(), QString(words("This session")), QString(words("The other")), QString(words("Difference"))})
    add_cell(table_, 0, column++)->setText(title);
  return box;
}

void ComparePanel::set_session(const QString& name, const QString& facts) {
  name_->setText(name);
  name_->setToolTip("<pre>" + facts.toHtmlEscaped() + "</pre>");
  feed_.reset_camera();
  show_text({});
}

void ComparePanel::show_text(const QString& text) {
  text_->setText(text);
  text_->setVisible(!text.isEmpty());
  views_->setVisible(text.isEmpty());
}

void ComparePanel::show_scene(const Scene& scene) {
  // What was computed again from recorded contours has no images of its own.
  const bool lacks_image = scene.measurement.state && !scene.frame;
  feed_.set_empty_text(lacks_image ? words("This session has no images: choose the forces in 3-D")
                                   : words("No frame at the same place"));
  source_->SetScene(scene);
  refresh_view();
}

// Of the two views the one that is seen.
void ComparePanel::refresh_view() {
  if (views_->currentIndex() == kForceView) {
    membranes_.refresh();
    forces_->render();
  } else {
    feed_.refresh();
    image_->render();
  }
}

void ComparePanel::show_rows(const std::vector<ComparisonRow>& rows) {
  const int count = static_cast<int>(rows.size());
  for (int row = table_->rowCount(); row <= count; ++row) {
    for (int column = 0; column < kColumns; ++column) add_cell(table_, row, column);
  }
  for (int row = 1; row < table_->rowCount(); ++row) {
    const bool used = row <= count;
    const ComparisonRow* from = used ? &rows[static_cast<std::size_t>(row - 1)] : nullptr;
    int column = 0;
    for (const std::string ComparisonRow::*member :
         {&ComparisonRow::name, &ComparisonRow::shown, &ComparisonRow::other, &ComparisonRow::difference}) {
      auto* cell = qobject_cast<QLabel*>(table_->itemAtPosition(row, column++)->widget());
      cell->setVisible(used);
      if (from) cell->setText(QString::fromStdString(from->*member));
    }
  }
}

void ComparePanel::choose_alignment(Alignment alignment) {
  alignment_->setCurrentIndex(static_cast<int>(alignment));
}

void ComparePanel::choose_forces(bool in_3d) {
  view_choice_->setCurrentIndex(in_3d ? kForceView : kImageView);
}

void ComparePanel::render() {
  curve_->render();
}

}  // namespace pellucida
