#include "widgets/NodePanel.h"

#include <vtkPolyData.h>

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "Words.h"
#include "widgets/Choice.h"
#include "widgets/CurvePanel.h"

namespace pellucida {
namespace {

constexpr int kMeridianAxis = 1;

QLabel* add_fact_label(QGridLayout* grid, int row, int column, const char* style) {
  auto* label = new QLabel;
  label->setObjectName(style);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(column == 1 ? Qt::TextSelectableByMouse : Qt::NoTextInteraction);
  grid->addWidget(label, row, column);
  return label;
}

}  // namespace

NodePanel::NodePanel(Actions actions, QWidget* parent) : QWidget(parent), actions_(std::move(actions)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  auto* facts = new pellucida::Panel(words("Node"), build_facts(), this);
  connect(facts->add_button(words("Close"), words("No node")), &QToolButton::clicked, this,
          [this] { actions_.close(); });
  column->addWidget(facts);
  curve_ = new CurvePanel("", {}, this);
  column->addWidget(curve_, 1);
  build_controls();
  show_progress(0, 0);
}

QWidget* NodePanel::build_facts() {
  auto* box = new QWidget;
  box->setObjectName("nodeFacts");
  box->setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(12, 2, 12, 8);
  column->setSpacing(6);
  facts_ = new QGridLayout;
  facts_->setHorizontalSpacing(12);
  facts_->setVerticalSpacing(1);
  facts_->setColumnStretch(1, 1);
  column->addLayout(facts_);
  progress_row_ = new QWidget;
  auto* row = new QHBoxLayout(progress_row_);
  row->setContentsMargins(0, 0, 0, 0);
  progress_ = new QProgressBar;
  progress_->setObjectName("nodeProgress");
  progress_->setTextVisible(false);
  progress_->setFixedHeight(8);
  row->addWidget(progress_, 1);
  auto* cancel = new QPushButton(words("Cancel"));
  cancel->setObjectName("nodeCancel");
  cancel->setFixedHeight(22);
  cancel->setFocusPolicy(Qt::TabFocus);
  connect(cancel, &QPushButton::clicked, this, [this] { actions_.cancel(); });
  row->addWidget(cancel);
  column->addWidget(progress_row_);
  return box;
}

void NodePanel::build_controls() {
  array_ = new Choice;
  array_->setObjectName("nodeArray");
  array_->setAccessibleName(words("Quantity of the node"));
  array_->setToolTip(words("What is drawn of the node"));
  for (const NodeArray array : kNodeArrays) array_->addItem(QString::fromStdString(name_of(array)));
  axis_ = new Choice;
  axis_->setObjectName("nodeAxis");
  axis_->setAccessibleName(words("Axis of the node's chart"));
  axis_->setToolTip(words("Over the session's time, or along the node's meridian in this frame"));
  axis_->addItems({words("over time"), words("along the meridian")});
  for (QComboBox* choice : {array_, axis_}) {
    choice->setFocusPolicy(Qt::TabFocus);
    choice->setFixedHeight(26);
    connect(choice, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
      fill_chart();
      render();
    });
    curve_->add_control(choice);
  }
}

void NodePanel::set_node(long number) {
  number_ = number;
  history_ = NodeHistory{};
  problem_.clear();
}

void NodePanel::show_frame(vtkPolyData* surface, double time_s) {
  surface_ = surface;
  time_s_ = time_s;
  const auto node = surface_node(surface, number_);
  show_facts(node ? node_facts(*node)
                  : std::vector<NodeFact>{{words("Node"), std::to_string(number_)},
                                          {words("Frame"), words("no surface with this node")}});
  if (axis_->currentIndex() == kMeridianAxis) fill_chart();
  place_cursor();
}

void NodePanel::show_facts(const std::vector<NodeFact>& facts) {
  const int count = static_cast<int>(facts.size());
  for (int row = facts_->rowCount(); row <= count; ++row) {
    add_fact_label(facts_, row, 0, "nodeFactName");
    add_fact_label(facts_, row, 1, "nodeFact");
  }
  // Row 0 of the grid stays empty.
  for (int row = 1; row < facts_->rowCount(); ++row) {
    auto* name = qobject_cast<QLabel*>(facts_->itemAtPosition(row, 0)->widget());
    auto* value = qobject_cast<QLabel*>(facts_->itemAtPosition(row, 1)->widget());
    const bool used = row <= count;
    name->setVisible(used);
    value->setVisible(used);
    if (!used) continue;
    name->setText(QString::fromStdString(facts[static_cast<std::size_t>(row - 1)].name));
    value->setText(QString::fromStdString(facts[static_cast<std::size_t>(row - 1)].value));
  }
}

void NodePanel::show_history(NodeHistory history) {
  history_ = std::move(history);
  fill_chart();
}

void NodePanel::show_progress(std::size_t done, std::size_t all) {
  progress_row_->setVisible(all > 0);
  if (all == 0) return;
  progress_->setRange(0, static_cast<int>(all));
  progress_->setValue(static_cast<int>(done));
  progress_->setToolTip(words("%1 of %2 frames read").arg(done).arg(all));
}

void NodePanel::show_problem(const QString& text) {
  problem_ = text;
  fill_chart();
}

void NodePanel::choose_array(NodeArray array) {
  const auto place = std::find(kNodeArrays.begin(), kNodeArrays.end(), array);
  array_->setCurrentIndex(static_cast<int>(place - kNodeArrays.begin()));
}

void NodePanel::choose_meridian(bool on) {
  axis_->setCurrentIndex(on ? kMeridianAxis : 0);
}

void NodePanel::fill_chart() {
  const NodeArray array = kNodeArrays[static_cast<std::size_t>(std::max(array_->currentIndex(), 0))];
  const bool meridian = axis_->currentIndex() == kMeridianAxis;
  CurveChartData drawn = meridian ? along_meridian(surface_, number_, array) : node_over_time(history_, array);
  if (!meridian && !problem_.isEmpty()) drawn.empty_text = problem_.toStdString();
  if (!meridian && problem_.isEmpty() && history_.times_s.empty()) drawn.empty_text = words("Reading the session");
  curve_->chart().set_data(std::move(drawn));
  curve_->set_seek(meridian ? std::function<void(double)>() : actions_.seek);
  place_cursor();
}

void NodePanel::place_cursor() {
  const bool meridian = axis_->currentIndex() == kMeridianAxis;
  const NodeArray array = kNodeArrays[static_cast<std::size_t>(std::max(array_->currentIndex(), 0))];
  const auto node = surface_node(surface_, number_);
  const double value = node ? value_of(*node, array) : CurveChart::kNowhere;
  curve_->chart().set_cursor(meridian ? polar_angle_deg(surface_, number_) : time_s_, value, !meridian);
}

void NodePanel::render() {
  curve_->render();
}

}  // namespace pellucida
