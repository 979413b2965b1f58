#pragma once
#include <iosfwd>
#include <string>
#include <vector>

#include "pellucida/simulation/Scenario.h"

namespace pellucida::test {

/// One cell of the grid: what a microscope, a camera or a cell may bring, and a human could still judge.
struct GridCondition {
  std::string name;  ///< also the scenario's
  Scenario scenario;
  int stride = 1;               ///< every how manyeth frame reaches the tracker; the others are lost
  bool representative = false;  ///< also part of the test; the tool runs all
};

void PrintTo(const GridCondition& condition, std::ostream* out);

/// The grid. All but the first three conditions move faster than the shipped scenarios (30 um/s towards the cell, 24
/// um/s into it: 1 px a frame at 0.825 um/px), so that 75 frames show approach, touch, the whole depth and a hold.
std::vector<GridCondition> grid_conditions();

}  // namespace pellucida::test
