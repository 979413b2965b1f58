#include "widgets/StatePill.h"

#include <algorithm>
#include <optional>

#include "Theme.h"
#include "Words.h"
#include "pellucida/core/Observation.h"
#include "pellucida/visualization/Readout.h"
#include "presenters/Phrase.h"

namespace pellucida {

StatePill::StatePill(QWidget* parent) : QLabel(parent) {
  setObjectName("statePill");
  setAlignment(Qt::AlignCenter);
  ensurePolished();
  constexpr int kEdge_px = 11;
  int widest_px = 0;
  for (const CellState state :
       {CellState::kNoCell, CellState::kFree, CellState::kContact, CellState::kPunctured, CellState::kLost}) {
    const QString name = QString::fromStdString(readout::state(state));
    widest_px = std::max(widest_px, fontMetrics().horizontalAdvance(name));
  }
  setToolTip(words("What the picture shows of the cell: whether it is seen, touched, punctured or lost"));
  setFixedSize(widest_px + 2 * kEdge_px, 30);
}

void StatePill::show_state(const Phrase& state) {
  setText(QString::fromStdString(state.text));
  set_sheet(*this, "background: " + QString::fromStdString(state.color.css()));
}

}  // namespace pellucida
