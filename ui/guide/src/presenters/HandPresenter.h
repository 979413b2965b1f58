#pragma once
#include <optional>
#include <string>

#include "pellucida/operation/TeleoperationRun.h"
#include "presenters/Phrase.h"

namespace pellucida {

/// Everything the hand's bar says, UTF-8.
struct HandTexts {
  Phrase state;              ///< its colour is the pill's ground
  Phrase force;              ///< on the hand, with the device's largest; or that the device gives none
  double force_share = 0.0;  ///< of the device's largest, 0..1
  Phrase contact;            ///< what the force rests on, with its age
  Phrase plane;              ///< how far the tip is out of the image plane, as the manipulator reports it
  Phrase note;               ///< what is wrong, the limits that act, or else what goes on; may be empty
  Phrase loop;               ///< the loop's own figures, for a tip
  bool stopped = false;      ///< the emergency stop is in force
};

/// Turns the hand's status into words. `doing`: what goes on when nothing is wrong. Knows no widgets.
HandTexts hand_texts(const HandStatus& status, const std::string& doing = {});

}  // namespace pellucida
