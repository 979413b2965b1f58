#pragma once
#include <string>
#include <vector>

#include "pellucida/core/Measurement.h"
#include "pellucida/teaching/CellSnapshot.h"
#include "presenters/Phrase.h"

namespace pellucida {

/// What Teach mode says about a poked cell, UTF-8.
struct TeachTexts {
  Phrase state;  ///< its colour is the pill's
  Phrase depth, force, volume, energy, speed, rate;
  Phrase force_note;    ///< the quasi-static force at that depth
  std::string blow_up;  ///< what ended the motion and what helps; empty while it runs
};

/// `quasi_static_uN`: force of the equilibrium at this depth; NaN: not known.
TeachTexts teach_texts(const CellSnapshot& snapshot, double quasi_static_uN, const ThemeColors& theme);

/// The curve's force at a depth, linear between its points; NaN outside of it.
double force_at_uN(const std::vector<double>& depth_um, const std::vector<double>& force_uN, double at_um);

/// A row of the table of forces on a node.
struct ForceRow {
  std::string name;
  Eigen::Vector3d force_uN = Eigen::Vector3d::Zero();
  bool is_residual = false;
};
/// All terms, then what they leave.
std::vector<ForceRow> force_rows(const NodeForces& forces);

/// A row for the chart of force over depth.
Measurement chart_row(const CurvePoint& point, long index);

}  // namespace pellucida
