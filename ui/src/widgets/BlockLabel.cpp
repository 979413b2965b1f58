#include "widgets/BlockLabel.h"

#include <QTimer>

#include "BlockWatch.h"
#include "Words.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

constexpr int kBlockLook_ms = 1000;
constexpr int kNarrow_px = 1200;

}  // namespace

BlockLabel::BlockLabel(QWidget* parent) : QLabel(parent) {
  setObjectName("statusText");
  hide();
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, [this] { look(); });
  timer->start(kBlockLook_ms);
}

void BlockLabel::look() {
  const BlockFigures blocks = window_blocks().figures();
  setVisible(blocks.count > 0);
  if (blocks.count == 0) return;
  const QString longest = QString::fromStdString(readout::milliseconds(blocks.longest_ms));
  // A narrow window needs the room for what matters more.
  const QString all = blocks.count == 1 ? words("1 block, %1").arg(longest)
                                        : words("%1 blocks, longest %2").arg(blocks.count).arg(longest);
  setText(window()->width() < kNarrow_px ? all.section(',', 0, 0) : all);
  setToolTip(
      words("How often this window was busy for more than %1 ms, in the last %2 s; the longest ended after %3 s.\n"
            "Meanwhile keys and clicks wait. The emergency stop, the hand and the recording do not.")
          .arg(BlockWatch::kBlock_ms, 0, 'f', 0)
          .arg(blocks.watched_s, 0, 'f', 0)
          .arg(blocks.longest_at_s, 0, 'f', 1));
}

}  // namespace pellucida
