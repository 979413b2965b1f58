#pragma once
#include "pellucida/pipeline/HandRig.h"
#include "presenters/StatusPresenter.h"

namespace pellucida {

/// Everything the hand's bar says, UTF-8.
struct HandTexts {
  Phrase state;              ///< its colour is the pill's ground
  Phrase force;              ///< on the hand, with the device's largest; what it would be where the device gives none
  double force_share = 0.0;  ///< of the device's largest, 0..1
  Phrase contact;            ///< what the force rests on, with its age
  Phrase limit;              ///< the limits and guides that act now; empty for none
  Phrase loop;               ///< the loop's own figures, for a tip
  bool stopped = false;      ///< the emergency stop is in force
};

/// Turns the hand's status into words. Knows no widgets.
HandTexts hand_texts(const HandStatus& status);

}  // namespace pellucida
