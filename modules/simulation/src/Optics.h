#pragma once
#include <opencv2/core.hpp>

#include "EdgeProfile.h"
#include "pellucida/simulation/Scenario.h"

namespace pellucida {

/// How far from a contour an edge is drawn, um.
inline constexpr double kBand_um = 9.0;

/// Transmittance across each edge against the signed distance, um, positive outside. The dark line's minimum lies at 0
/// exactly, but for the holder's, whose glass refracts over its whole rounded wall.
EdgeProfile make_outer_edge(const Scenario& scenario);  ///< the zona's outer edge
EdgeProfile make_inner_edge(
    const Scenario& scenario);  ///< the zona's inner edge, with the ooplasm where no gap is seen
EdgeProfile make_ooplasm_edge(const Scenario& scenario);  ///< the oolemma behind a gap
EdgeProfile make_holder_edge(const Scenario& scenario);
EdgeProfile make_needle_edge(const Scenario& scenario);
/// An air bubble's rim: a broad dark ring inside it, bright within. `radius_um` its radius.
EdgeProfile make_bubble_edge(const Scenario& scenario, double radius_um);
/// A droplet in the ooplasm: a dark rim, bright within.
EdgeProfile make_droplet_edge(const Scenario& scenario);
/// Weight of the ooplasm's grain: 0 outside, 1 inside.
EdgeProfile make_inside_weight();

/// Light of the empty field, ratio of full scale (CV_32F): gradient, vignette, debris.
cv::Mat1f make_field_of_light(const Scenario& scenario);

}  // namespace pellucida
