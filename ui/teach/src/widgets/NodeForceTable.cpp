#include "widgets/NodeForceTable.h"

#include <QCheckBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "Theme.h"
#include "Words.h"
#include "pellucida/core/Html.h"
#include "pellucida/teaching_vtk/PokedCellView.h"
#include "presenters/TeachPresenter.h"

namespace pellucida {
namespace {

constexpr int kNumberColumns = 4;
constexpr int kForceDecimals = 3;
// The names of the terms (teaching/NodeForces), for lupdate.
[[maybe_unused]] constexpr const char* kTermTexts[] = {
    PELLUCIDA_WORDS("Meridian springs"), PELLUCIDA_WORDS("Parallel springs"), PELLUCIDA_WORDS("Diagonals (X)"),
    PELLUCIDA_WORDS("Hinges"),           PELLUCIDA_WORDS("Pressure"),         PELLUCIDA_WORDS("Needle"),
    PELLUCIDA_WORDS("Holder"),           PELLUCIDA_WORDS("Dampers"),          PELLUCIDA_WORDS("Inertia, \u2212m a")};
constexpr const char* kForceHeads[] = {PELLUCIDA_WORDS("Force, µN"), "x", "y", "z", "|F|"};

}  // namespace

NodeForceTable::NodeForceTable(QWidget* parent) : QWidget(parent) {
  setObjectName("page");
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(14, 12, 14, 12);
  column->setSpacing(10);
  auto* law = new QLabel(words("(1) &nbsp;<b>f<sub>ij</sub></b> = k (L/|p| \u2212 1) p \u2212 b (v\u00b7p)/(p\u00b7p) p"
                               "<br>(2) &nbsp;<b>m a</b> = \u03a3 <b>f</b>"),
                         this);
  law->setObjectName("lessonText");
  law->setWordWrap(true);
  column->addWidget(law);
  title_ = new QLabel(this);
  title_->setObjectName("parameterNote");
  title_->setWordWrap(true);
  column->addWidget(title_);

  table_ = new QTableWidget(static_cast<int>(kForceTermCount) + 1, 1 + kNumberColumns, this);
  table_->setObjectName("nodeForces");
  QStringList heads;
  for (const char* head : kForceHeads) heads << words(head);
  table_->setHorizontalHeaderLabels(heads);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setFocusPolicy(Qt::NoFocus);
  table_->setShowGrid(false);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  for (int row = 0; row < table_->rowCount(); ++row) {
    for (int k = 0; k < table_->columnCount(); ++k) {
      auto* item = new QTableWidgetItem;
      item->setTextAlignment(k == 0 ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(row, k, item);
    }
  }
  table_->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
  table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->setWordWrap(false);
  // All rows; the page scrolls.
  table_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  column->addWidget(table_);
  head_to_tail_ = new QCheckBox(words("Arrows head to tail: a balance closes"), this);
  column->addWidget(head_to_tail_);
  column->addStretch(1);
  show_hint();
}

void NodeForceTable::show_hint() {
  title_->setText(words("Click a node of the cell: each term of the equations becomes an arrow."));
  table_->hide();
  head_to_tail_->hide();
}

void NodeForceTable::resizeEvent(QResizeEvent*) {
  constexpr int kPadding_px = 8;
  const QFontMetrics letters = table_->fontMetrics();
  int name_px = 0;
  for (const char* term : kTermTexts) {
    name_px = std::max(name_px, letters.horizontalAdvance(QString::fromUtf8("\u25cf ") + words(term)));
  }
  const int number_px = letters.horizontalAdvance("-0.000") + kPadding_px;
  const QMargins around = layout()->contentsMargins();
  const int room_px = width() - around.left() - around.right();
  // The longest name may lose its last letters.
  const bool is_narrow = room_px < 3 * name_px / 4 + kPadding_px + kNumberColumns * number_px;
  for (const int column : {1, 2}) table_->setColumnHidden(column, is_narrow);
}

void NodeForceTable::show_forces(const NodeForces& forces, const ThemeColors& theme) {
  table_->setFixedHeight(table_->horizontalHeader()->height() + table_->verticalHeader()->length() + 2);
  title_->setText(
      words("Node %1. z: the needle's axis, outwards. The residual is the error of the time step.").arg(forces.node));
  table_->show();
  head_to_tail_->show();
  const auto rows = force_rows(forces);
  for (int row = 0; row < table_->rowCount(); ++row) {
    const ForceRow& one = rows[static_cast<std::size_t>(row)];
    const QColor color = to_qt(one.is_residual ? theme.record : term_color(static_cast<ForceTerm>(row), theme));
    const double numbers[kNumberColumns] = {one.force_uN.x(), one.force_uN.y(), one.force_uN.z(), one.force_uN.norm()};
    table_->item(row, 0)->setText(QString::fromUtf8("\u25cf ") + words(one.name.c_str()));
    table_->item(row, 0)->setToolTip(words(one.name.c_str()));
    table_->item(row, 0)->setForeground(color);
    for (int k = 0; k < kNumberColumns; ++k) {
      table_->item(row, k + 1)->setText(QString::fromStdString(fixed_number(numbers[k], kForceDecimals)));
      table_->item(row, k + 1)->setForeground(to_qt(theme.text));
    }
  }
}

}  // namespace pellucida
