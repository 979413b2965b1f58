#pragma once
#include <string>

#include "pellucida/visualization/Palette.h"

namespace pellucida {

/// A text and the colour it is written in.
struct Phrase {
  std::string text;
  Color color = current_theme().text;
};

}  // namespace pellucida
