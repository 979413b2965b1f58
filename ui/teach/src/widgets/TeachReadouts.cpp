#include "widgets/TeachReadouts.h"

#include <QHBoxLayout>
#include <algorithm>

#include "Theme.h"
#include "Words.h"
#include "presenters/TeachPresenter.h"
#include "widgets/PhraseLabel.h"

namespace pellucida {
namespace {

constexpr int kNoteGap_px = 10;

}  // namespace

TeachReadouts::TeachReadouts(QWidget* parent) : QFrame(parent) {
  setObjectName("readoutBar");
  setAttribute(Qt::WA_StyledBackground);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* row = new QHBoxLayout(this);
  row->setSizeConstraint(QLayout::SetNoConstraint);
  row->setContentsMargins(16, 6, 16, 8);
  row->setSpacing(22);
  state_ = new FigureLabel(words("   In contact   "), this);
  state_->setObjectName("statePill");
  state_->setAlignment(Qt::AlignCenter);
  state_->setFixedHeight(30);
  row->addWidget(state_);
  depth_ = add_figure(*row, *this, "depth", words("DEPTH"), "-00.0 µm");
  force_ = add_figure(*row, *this, "force", words("FORCE"), "00.00 µN", words("at rest: 00.00 µN"));
  volume_ = add_figure(*row, *this, "volume", words("VOLUME"), "-00.00 %");
  energy_ = add_figure(*row, *this, "energy", words("ENERGY"), words("0.000 pJ"));
  speed_ = add_figure(*row, *this, "speed", words("FASTEST NODE"), "00000 µm/s");
  rate_ = add_figure(*row, *this, "rate", words("STEPS, PACE"), "00000 /s, 0.00×");
  row->addStretch(1);
}

void TeachReadouts::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  show_what_fits();
}

// By the labels' own widths: a layout knows of hidden ones only later.
void TeachReadouts::show_what_fits() {
  const auto width_of = [](const Figure& figure) {
    return std::max(figure.heading->sizeHint().width(), figure.value->sizeHint().width());
  };
  const auto* row = static_cast<QHBoxLayout*>(layout());
  int room = width() - row->contentsMargins().left() - row->contentsMargins().right() - state_->sizeHint().width();
  for (const Figure& figure : {depth_, force_, rate_}) room -= row->spacing() + width_of(figure);
  // The more important ones first.
  for (const Figure& figure : {volume_, energy_, speed_}) {
    room -= row->spacing() + width_of(figure);
    figure.heading->setVisible(room >= 0);
    figure.value->setVisible(room >= 0);
  }
  room -= kNoteGap_px + force_.note->sizeHint().width();
  force_.note->setVisible(room >= 0);
}

void TeachReadouts::show_texts(const TeachTexts& texts) {
  state_->setText(QString::fromStdString(texts.state.text));
  set_sheet(*state_, "background: " + QString::fromStdString(texts.state.color.css()));
  show_what_fits();
  show_phrase(*depth_.value, texts.depth);
  show_phrase(*force_.value, texts.force);
  show_phrase(*force_.note, texts.force_note);
  show_phrase(*volume_.value, texts.volume);
  show_phrase(*energy_.value, texts.energy);
  show_phrase(*speed_.value, texts.speed);
  show_phrase(*rate_.value, texts.rate);
}

}  // namespace pellucida
