#include "widgets/FigureBar.h"

#include <QHBoxLayout>
#include <algorithm>

#include "Theme.h"
#include "widgets/PhraseLabel.h"

namespace pellucida {
namespace {

constexpr int kNoteGap_px = 10;

}  // namespace

FigureBar::FigureBar(const QString& widest_state, std::vector<Entry> entries, QWidget* parent)
    : QFrame(parent), entries_(std::move(entries)) {
  setObjectName("readoutBar");
  setAttribute(Qt::WA_StyledBackground);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* row = new QHBoxLayout(this);
  row->setSizeConstraint(QLayout::SetNoConstraint);
  row->setContentsMargins(16, 6, 16, 8);
  row->setSpacing(22);
  state_ = new FigureLabel("   " + widest_state + "   ", this);
  state_->setObjectName("statePill");
  state_->setAlignment(Qt::AlignCenter);
  state_->setFixedHeight(30);
  row->addWidget(state_);
  for (const Entry& entry : entries_) {
    figures_.push_back(add_figure(*row, *this, entry.name, entry.heading, entry.widest, entry.widest_note));
  }
  row->addStretch(1);
}

void FigureBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  show_what_fits();
}

// By the labels' own widths: a layout knows of hidden ones only later.
void FigureBar::show_what_fits() {
  const auto width_of = [](const Figure& figure) {
    return std::max(figure.heading->sizeHint().width(), figure.value->sizeHint().width());
  };
  const auto* row = static_cast<QHBoxLayout*>(layout());
  int room = width() - row->contentsMargins().left() - row->contentsMargins().right() - state_->sizeHint().width();
  for (std::size_t k = 0; k < figures_.size(); ++k) {
    if (entries_[k].is_essential) room -= row->spacing() + width_of(figures_[k]);
  }
  for (std::size_t k = 0; k < figures_.size(); ++k) {
    if (entries_[k].is_essential) continue;
    room -= row->spacing() + width_of(figures_[k]);
    figures_[k].heading->setVisible(room >= 0);
    figures_[k].value->setVisible(room >= 0);
  }
  for (const Figure& figure : figures_) {
    if (!figure.note) continue;
    room -= kNoteGap_px + figure.note->sizeHint().width();
    figure.note->setVisible(room >= 0);
  }
}

void FigureBar::show_state(const Phrase& state) {
  state_->setText(QString::fromStdString(state.text));
  set_sheet(*state_, "background: " + QString::fromStdString(state.color.css()));
}

void FigureBar::show_figures(const std::vector<Phrase>& figures) {
  show_what_fits();
  for (std::size_t k = 0; k < figures_.size(); ++k) show_phrase(*figures_[k].value, figures[k]);
}

void FigureBar::show_note(std::size_t figure, const Phrase& note) {
  show_phrase(*figures_[figure].note, note);
}

}  // namespace pellucida
