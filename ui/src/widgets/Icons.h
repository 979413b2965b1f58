#pragma once
#include <QIcon>

namespace pellucida {

/// The window's pictograms, drawn in the palette's colours at any size.
enum class Pictogram {
  kProgram,
  kRecord,
  kStop,
  kPause,
  kPlay,
  kCamera,
  kNote,
  kScale,
  kRestart,
  kEnd,
  kStepBack,
  kStepForward,
  kTenBack,
  kTenForward,
  kEventBack,
  kEventForward,
  kLoop,
  kBackwards,
  kOpen,
  kLesson,
  kCompare,
  kHome,
};
QIcon make_icon(Pictogram pictogram);

}  // namespace pellucida
