#include "CellsWindow.h"

#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QShortcut>
#include <QTableWidget>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <set>

#include "Words.h"
#include "pellucida/core/Error.h"
#include "pellucida/visualization/Palette.h"
#include "pellucida/visualization/Readout.h"
#include "presenters/Phrase.h"
#include "widgets/Icons.h"
#include "widgets/TaskLine.h"

namespace pellucida {
namespace {

constexpr int kGroupsHeight_px = 150;
const char* const kGroupTitles[] = {PELLUCIDA_WORDS("Group"), PELLUCIDA_WORDS("Median (quartiles), number"),
                                    PELLUCIDA_WORDS("Hedges' g against the first"),
                                    PELLUCIDA_WORDS("Cliff's delta against the first")};

// Sorted by its number where it has one; what wasn't measured comes last.
class EntryItem : public QTableWidgetItem {
 public:
  EntryItem(const CellTable::Entry& entry, bool is_number)
      : QTableWidgetItem(QString::fromStdString(entry.text)), number_(entry.number), is_number_(is_number) {
    setTextAlignment((is_number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  }
  bool operator<(const QTableWidgetItem& other) const override {
    const auto* right = dynamic_cast<const EntryItem*>(&other);
    if (!right || !is_number_) return text().localeAwareCompare(other.text()) < 0;
    if (std::isnan(number_)) return false;
    return std::isnan(right->number_) || number_ < right->number_;
  }

 private:
  double number_;
  bool is_number_;
};

std::string effect_words(double value, double lower, double upper) {
  if (std::isnan(value)) return readout::number(value, 0);
  return readout::number(value, 2) + " (" + readout::number(lower, 2) + say(" to ") + readout::number(upper, 2) + ")";
}

QTableWidget* new_table(const char* name, const QString& accessible) {
  auto* table = new QTableWidget;
  table->setObjectName(name);
  table->setAccessibleName(accessible);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setTabKeyNavigation(false);
  table->setAlternatingRowColors(true);
  table->verticalHeader()->hide();
  table->setStyleSheet("QTableView::item { padding: 0 8px; }");
  table->horizontalHeader()->setHighlightSections(false);
  return table;
}

}  // namespace

// What came of one folder.
struct CellsWindow::Read {
  std::vector<SessionCell> cells;
  std::vector<std::string> problems;
};

CellsWindow::CellsWindow(FileChoice choice, Open open, QWidget* parent)
    : QWidget(parent, Qt::Window), choice_(std::move(choice)), open_(std::move(open)) {
  setObjectName("cellsWindow");
  setWindowTitle(words("Pellucida - Cells of several sessions"));
  setWindowIcon(make_icon(Pictogram::kProgram));
  setAttribute(Qt::WA_StyledBackground);
  setAcceptDrops(true);
  resize(1180, 560);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(16, 8, 16, 8);
  bar->setSpacing(8);
  bar->addWidget(add_button("cellsAdd", words("Add sessions"),
                            words("A session, or a folder with sessions in it; they can be dropped here as well"),
                            [this] {
                              const auto folder = choice_.session(words("Add sessions"));
                              if (!folder.empty()) add(folder);
                            }));
  bar->addWidget(remove_ = add_button("cellsRemove", words("Take out"), words("Takes the rows chosen out of the table"),
                                      [this] { take_out(); }));
  bar->addWidget(save_ = add_button("cellsSave", words("Table as CSV"),
                                    words("All columns of the report's cells.csv, with the group of each"),
                                    [this] { save(); }));
  bar->addStretch(1);
  column->addLayout(bar);
  table_ = new_table("cells", words("Cells"));
  table_->setToolTip(words("A double click opens the session at the touch; a click on a column's title sorts"));
  table_->setColumnCount(static_cast<int>(CellTable::column_count()));
  for (int c = 0; c < table_->columnCount(); ++c) {
    table_->setHorizontalHeaderItem(
        c, new QTableWidgetItem(QString::fromStdString(CellTable::column_title(static_cast<std::size_t>(c)))));
  }
  column->addWidget(table_, 1);
  group_title_ = new QLabel;
  group_title_->setObjectName("panelTitle");
  group_title_->setTextFormat(Qt::PlainText);
  group_title_->setContentsMargins(16, 8, 16, 4);
  column->addWidget(group_title_);
  groups_ = new_table("cellGroups", words("Groups"));
  groups_->setColumnCount(static_cast<int>(std::size(kGroupTitles)));
  for (int c = 0; c < groups_->columnCount(); ++c) {
    groups_->setHorizontalHeaderItem(c, new QTableWidgetItem(words(kGroupTitles[c])));
  }
  groups_->setMaximumHeight(kGroupsHeight_px);
  groups_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  column->addWidget(groups_);
  column->addWidget(line_ = new TaskLine(
                        [this] {
                          waiting_.clear();
                          reading_.cancel();
                          line_->show_work({}, 0, 0);
                        },
                        this));
  connect(table_, &QTableWidget::itemDoubleClicked, this, [this] { open_row(); });
  connect(table_, &QTableWidget::itemSelectionChanged, this,
          [this] { remove_->setEnabled(!table_->selectedItems().isEmpty()); });
  connect(table_->horizontalHeader(), &QHeaderView::sectionClicked, this, [this](int clicked) {
    column_ = static_cast<std::size_t>(std::max(clicked, 0));
    fill_groups();
  });
  table_->installEventFilter(this);
  connect(new QShortcut(QKeySequence(Qt::Key_Escape), this), &QShortcut::activated, this, [this] { close(); });
  fill();
}

QPushButton* CellsWindow::add_button(const char* name, const QString& text, const QString& tip,
                                     std::function<void()> act) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setFixedHeight(30);
  connect(button, &QPushButton::clicked, this, std::move(act));
  return button;
}

void CellsWindow::add(const std::filesystem::path& folder) {
  waiting_.push_back(folder);
  if (!reading_.running()) read_next();
}

void CellsWindow::read_next() {
  if (waiting_.empty()) return;
  const std::filesystem::path folder = waiting_.front();
  waiting_.erase(waiting_.begin());
  last_ = folder;
  const QString text = words("Reading ") + QString::fromStdString(folder.filename().string());
  line_->show_work(text, 0, 0);
  reading_.run(
      [this, folder](const BackgroundTask::Control& control) -> std::function<void()> {
        auto read = std::make_shared<Read>();
        const auto sessions = sessions_in(folder);
        for (std::size_t i = 0; i < sessions.size(); ++i) {
          control.progress(i, sessions.size());
          try {
            const auto cells =
                cells_of(sessions[i], [&](std::size_t, std::size_t) { control.progress(i, sessions.size()); });
            read->cells.insert(read->cells.end(), cells.begin(), cells.end());
          } catch (const InputError& error) {
            read->problems.emplace_back(error.what());
          }
        }
        return [this, read, count = sessions.size()] {
          line_->show_work({}, 0, 0);
          cells_.add(read->cells);
          fill();
          const QString done = words("Cells read: %1, from sessions: %2").arg(read->cells.size()).arg(count);
          line_->show_notice(read->problems.empty() ? Phrase{done.toStdString(), current_theme().text_dim}
                                                    : Phrase{(done + "; " + words("left out: ")).toStdString() +
                                                                 say_message(read->problems.front()),
                                                             current_theme().warning});
          read_next();
        };
      },
      [this, text](std::size_t done, std::size_t all) { line_->show_work(text, done, all); },
      [this](const std::string& error) {
        line_->show_work({}, 0, 0);
        line_->show_notice({error, current_theme().warning});
        read_next();
      });
}

void CellsWindow::fill() {
  table_->setSortingEnabled(false);
  table_->setRowCount(static_cast<int>(cells_.rows().size()));
  for (std::size_t row = 0; row < cells_.rows().size(); ++row) {
    for (std::size_t column = 0; column < CellTable::column_count(); ++column) {
      const CellTable::Entry entry = cells_.entry(row, column);
      const bool is_number = CellTable::is_quantity(column) || std::isfinite(entry.number);
      auto* item = new EntryItem(entry, is_number);
      if (column == 0) item->setData(Qt::UserRole, static_cast<int>(row));
      if (!is_number) {
        const auto& doubts = cells_.rows()[row].passport.main_contact().doubts;
        item->setToolTip(
            "<p>" +
            QString::fromStdString(cells_.rows()[row].session.folder.string() + (doubts.empty() ? "" : ": " + doubts))
                .toHtmlEscaped() +
            "</p>");
      }
      table_->setItem(static_cast<int>(row), static_cast<int>(column), item);
    }
  }
  table_->setSortingEnabled(true);
  table_->resizeColumnsToContents();
  const bool has_rows = !cells_.rows().empty();
  save_->setEnabled(has_rows);
  remove_->setEnabled(false);
  if (!has_rows) {
    line_->show_notice({words("Add sessions, or drop them here: a row for each cell"), current_theme().text_dim});
  }
  fill_groups();
}

void CellsWindow::fill_groups() {
  const std::size_t column = CellTable::is_quantity(column_) ? column_ : CellTable::kPeakForce;
  const auto groups = cells_.groups(column);
  group_title_->setText(words("Groups by ") + QString::fromStdString(CellTable::column_title(column)));
  groups_->setRowCount(static_cast<int>(groups.size()));
  for (std::size_t k = 0; k < groups.size(); ++k) {
    const GroupRow& group = groups[k];
    const std::string texts[] = {group.group, group_words(group),
                                 effect_words(group.hedges_g, group.hedges_g_lower, group.hedges_g_upper),
                                 effect_words(group.cliffs_delta, group.cliffs_delta_lower, group.cliffs_delta_upper)};
    for (int c = 0; c < groups_->columnCount(); ++c) {
      auto* item = new QTableWidgetItem(QString::fromStdString(texts[c]));
      item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
      groups_->setItem(static_cast<int>(k), c, item);
    }
  }
  const bool compares = groups.size() > 1;
  groups_->setVisible(compares);
  group_title_->setVisible(compares);
}

std::size_t CellsWindow::row_of(int shown) const {
  return static_cast<std::size_t>(table_->item(shown, 0)->data(Qt::UserRole).toInt());
}

void CellsWindow::take_out() {
  std::set<std::size_t, std::greater<>> rows;
  for (const QTableWidgetItem* item : table_->selectedItems()) rows.insert(row_of(item->row()));
  for (const std::size_t row : rows) cells_.remove(row);
  fill();
}

void CellsWindow::open_row() {
  if (table_->currentRow() < 0) return;
  const SessionCell& cell = cells_.rows()[row_of(table_->currentRow())];
  const double touch_s = cell.passport.main_contact().touch_s;
  open_(cell.session.folder, std::isfinite(touch_s) ? touch_s : cell.passport.found_s);
}

void CellsWindow::save() {
  const auto file =
      choice_.file_to_write(words("Table as CSV"), last_.parent_path() / "all-cells.csv", words("Table (*.csv)"));
  if (file.empty()) return;
  try {
    cells_.write(file);
    line_->show_notice(
        {(words("Saved ") + QString::fromStdString(file.string())).toStdString(), current_theme().accent});
  } catch (const Error& error) {
    line_->show_notice({words_of(error).toStdString(), current_theme().warning});
  }
}

bool CellsWindow::eventFilter(QObject* target, QEvent* event) {
  if (target != table_ || event->type() != QEvent::KeyPress) return false;
  const int key = static_cast<const QKeyEvent*>(event)->key();
  if (key == Qt::Key_Delete) {
    take_out();
  } else if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    open_row();
  } else {
    return false;
  }
  return true;
}

void CellsWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void CellsWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  for (const QUrl& url : event->mimeData()->urls()) {
    if (url.isLocalFile()) add(url.toLocalFile().toStdString());
  }
}

}  // namespace pellucida
