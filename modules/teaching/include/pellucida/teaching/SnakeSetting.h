#pragma once
#include <string>

#include "pellucida/teaching/KassSnake.h"

namespace pellucida {

/// A snake on a picture, as a lesson sets it up.
struct SnakeSetting {
  std::string picture = "virtual:default";  ///< a source as on the command line, or a recorded session's folder
  double time_s = 2.0;                      ///< of the frame in it
  double start_x_um = 264.0;
  double start_y_um = 200.0;
  double start_radius_um = 33.0;  ///< of the circle that the snake begins on
  bool runs = false;              ///< from the beginning, without a key
  SnakeParameters parameters;
};

/// Keys, units and ranges, those of the parameters included.
FieldList fields_of(SnakeSetting& setting);
/// Throws UsageError for a number out of its range or an unknown attraction.
void require_valid(const SnakeSetting& setting);

}  // namespace pellucida
