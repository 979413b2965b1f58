#include "widgets/CellDrawer.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "Theme.h"
#include "Words.h"
#include "pellucida/visualization/Palette.h"
#include "widgets/KeySheet.h"

namespace pellucida {
namespace {

constexpr int kDrawer_px = 410;

}  // namespace

CellDrawer::CellDrawer(Actions actions, QWidget* parent) : QFrame(parent) {
  setObjectName("cellDrawer");
  setAttribute(Qt::WA_StyledBackground);
  setFixedWidth(kDrawer_px);
  set_key_group(*this, words("Cells"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 4, 8, 10);
  column->setSpacing(6);
  auto* head = new QHBoxLayout;
  auto* title = new QLabel(words("Cells of this run"), this);
  title->setObjectName("panelTitle");
  head->addWidget(title);
  head->addStretch(1);
  save_ = add_button(words("Save as CSV"), words("Write the list as a table, with the columns of a report's cells.csv"),
                     std::move(actions.save));
  save_->setObjectName("saveCells");
  head->addWidget(save_);
  QPushButton* close = add_button(QString::fromUtf8("\u2715"), words("Close the list"), std::move(actions.close));
  close->setProperty("narrow", true);
  close->setFixedWidth(28);
  close->setAccessibleName(words("Close the list"));
  head->addWidget(close);
  column->addLayout(head);

  list_ = new QTreeWidget(this);
  list_->setObjectName("cells");
  list_->setAccessibleName(words("Cells of this run"));
  list_->setRootIsDecorated(false);
  list_->setSelectionMode(QAbstractItemView::NoSelection);
  list_->setHeaderLabels({words("Cell"), words("Outcome"), "µN", "µm", "pJ", "s"});
  const QString tips[] = {words("Name, or number in this run"),
                          words("How the contact with the cell ended"),
                          words("Force at the puncture; without one, the largest"),
                          words("Indentation at that force"),
                          words("Work of the needle up to it"),
                          words("When it was, since the source began")};
  for (int k = 0; k < 6; ++k) {
    list_->headerItem()->setToolTip(k, tips[k]);
    if (k >= 2) list_->headerItem()->setTextAlignment(k, Qt::AlignRight | Qt::AlignVCenter);
  }
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(1, QHeaderView::Stretch);
  column->addWidget(list_, 1);

  auto* place = new QHBoxLayout;
  auto* heading = new QLabel(words("Recordings in"), this);
  heading->setObjectName("statusText");
  place->addWidget(heading);
  folder_ = new QLabel(this);
  folder_->setObjectName("recordingsFolder");
  folder_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  place->addWidget(folder_, 1);
  QPushButton* choose =
      add_button(words("Change") + QString::fromUtf8("\u2026"),
                 words("Choose the folder for recordings, pictures and tables"), std::move(actions.choose_folder));
  choose->setObjectName("chooseFolder");
  place->addWidget(choose);
  column->addLayout(place);
}

QPushButton* CellDrawer::add_button(const QString& text, const QString& tip, std::function<void()> action) {
  auto* button = new QPushButton(text, this);
  button->setFixedHeight(28);
  button->setToolTip(tip);
  button->setFocusPolicy(Qt::TabFocus);
  connect(button, &QPushButton::clicked, this, std::move(action));
  return button;
}

void CellDrawer::show_cells(std::span<const CellRow> cells) {
  save_->setEnabled(!cells.empty());
  // A list that stays the same keeps its place.
  if (std::equal(cells.begin(), cells.end(), shown_.begin(), shown_.end())) return;
  shown_.assign(cells.begin(), cells.end());
  list_->clear();
  for (const CellRow& cell : cells) {
    auto* item = new QTreeWidgetItem(list_);
    const std::string* texts[] = {&cell.name, &cell.outcome, &cell.force, &cell.depth, &cell.work, &cell.time};
    for (int k = 0; k < 6; ++k) {
      item->setText(k, QString::fromStdString(*texts[k]));
      if (k >= 2) item->setTextAlignment(k, Qt::AlignRight | Qt::AlignVCenter);
    }
    if (!cell.is_punctured) {
      for (int k = 1; k < 6; ++k) item->setForeground(k, to_qt(current_theme().text_dim));
    }
  }
  list_->scrollToBottom();
}

void CellDrawer::show_folder(const QString& folder) {
  folder_text_ = folder;
  folder_->setToolTip(folder);
  resizeEvent(nullptr);
}

void CellDrawer::resizeEvent(QResizeEvent*) {
  folder_->setText(folder_->fontMetrics().elidedText(folder_text_, Qt::ElideLeft, folder_->width()));
}

}  // namespace pellucida
