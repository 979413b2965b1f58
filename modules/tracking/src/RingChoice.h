#pragma once
#include "GrayImage.h"
#include "SceneReader.h"

namespace pellucida {

/// Adds to a scene that shows no cell the one that lines found at `found`, where the network that knows cells sees one
/// in a ring about it: a halo, or the oolemma, is as clear a line as the zona, and what the lines found may be that.
/// The ring that it is surest of counts; nothing is added where it is sure of none. Where the scene's tools are at
/// something else than `found`, the next best that lines find in `whole` takes its place. For detection: 20 ms, 40 ms
/// for the second search.
void add_likeliest_ring(SceneReading& scene, const GrayImage& whole, const TrackerOptions& options,
                        const contour::Circle& found, const FrameSampler& image, SceneReader& reader);

/// Adds to a scene that shows no cell the next best one that lines find in `whole` where a needle points at it through
/// `found`, and the network that knows cells is sure of it: `found` may be a bystander that the needle lies over. For
/// detection: 40 ms where a needle points at `found`.
void add_ring_behind(SceneReading& scene, const GrayImage& whole, const TrackerOptions& options,
                     const contour::Circle& found, const FrameSampler& image, SceneReader& reader);

}  // namespace pellucida
