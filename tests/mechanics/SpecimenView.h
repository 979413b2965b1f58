#pragma once
#include "pellucida/core/Observation.h"
#include "pellucida/simulation/CellReference.h"

namespace pellucida::testing {

/// A specimen in view at a depth: needle from +x, holder opposite, centre at the origin.
inline Observation view_of(const CellReference& cell, double depth_um, long frame = 0) {
  Observation o;
  o.time_s = static_cast<double>(frame) / 30.0;
  o.frame_index = frame;
  o.state = depth_um > 0.0 ? CellState::kContact : CellState::kFree;
  o.confidence = 1.0;
  o.axis = Eigen::Vector2d::UnitX();
  o.rest_outer_radius_um = cell.outer_radius_um();
  const CellReference::Section section = cell.section(depth_um);
  o.outer.emplace();
  o.outer->points_um.resize(2, section.outer_um.cols());
  o.outer->points_um.row(0) = section.outer_um.row(1);  // z towards the needle
  o.outer->points_um.row(1) = -section.outer_um.row(0);
  o.needle = NeedlePose{.tip_um = {cell.outer_radius_um() - depth_um, 0.0},
                        .direction = -Eigen::Vector2d::UnitX(),
                        .tip_radius_um = cell.geometry().tip_radius_um,
                        .confidence = 1.0,
                        .tip_sigma_um = 0.1};
  o.holder = HolderPose{.mouth_um = {-cell.outer_radius_um(), 0.0}, .direction = -Eigen::Vector2d::UnitX()};
  o.holder->outer_radius_um = cell.geometry().holder_ring_um + cell.geometry().holder_half_width_um;
  o.indentation_um = depth_um;
  o.indentation_sigma_um = 0.15;
  return o;
}

}  // namespace pellucida::testing
