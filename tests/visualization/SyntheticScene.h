#pragma once
#include <vector>

#include "pellucida/core_vtk/Scene.h"

namespace pellucida::test {

/// A cell of 48 um radius held on the left and indented from the right by `indentation_um`, with everything a scene may
/// hold: noisy 8-bit frame of 728 x 486 at 0.825 um, contours, tools, surfaces with forces, model, observation, row.
/// The force follows 0.004 uN/um^2 d^2.
Scene synthetic_scene(double indentation_um, long frame_index = 0);

/// Rows of an approach of `count` frames to `deepest_um`, a scene's row each.
std::vector<Measurement> synthetic_rows(int count, double deepest_um);

}  // namespace pellucida::test
