#pragma once
#include "ContourMath.h"
#include "FrameSampler.h"
#include "SceneReading.h"
#include "TipNetwork.h"

namespace pellucida {

/// A needle that lies over a cell on its way to another one seems to end at the first. Each needle of `scene` that
/// points through `crossed` (px) at one of its cells behind that is looked for there: where its tip is read between
/// the two, that is where it ends, and the crossed cell is a bystander. For detection, not for every frame.
void look_past(SceneReading& scene, const contour::Circle& crossed, const FrameSampler& image, TipNetwork& tips);

}  // namespace pellucida
