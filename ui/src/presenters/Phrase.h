#pragma once
#include <string>

#include "pellucida/visualization/Palette.h"

namespace pellucida {

/// A text and the colour it is written in.
struct Phrase {
  std::string text;
  Color color = palette::kText;
};

}  // namespace pellucida
