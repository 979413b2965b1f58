#include "ContactSight.h"

#include <algorithm>
#include <cmath>

#include "pellucida/core/NearestOnContour.h"

namespace pellucida {
namespace {

/// Noise of the indentation when the tracker gives none: a quarter of a pixel at 0.8 um; and of the tip along the
/// needle.
constexpr double kDefaultDepthSigma_um = 0.2, kDefaultTipSigma_um = 0.4;

/// Means over flanks and sides are known to this share of a contour's usual standard deviation: what a contour is off
/// by is alike over some 20 degrees. With 0.7, of 54 punctures of tuning and validation films one more is seen late.
constexpr double kShapeSigma_ratio = 0.4;

/// A tip that is off by this share of its depth looks pierced, or pushed, when it isn't (`PunctureNetwork`).
constexpr double kTellingShare_ratio = 0.2;

/// What the picture about a tip says, as far as the tip lies where the picture was looked at: it may be off by its
/// standard deviation.
double pierced_about(double pierced, double depth_um, double tip_sigma_um) {
  const double off = std::erfc(kTellingShare_ratio * std::max(0.0, depth_um) / (std::sqrt(2.0) * tip_sigma_um));
  return (1.0 - off) * std::min(1.0, pierced) + 0.5 * off;
}

}  // namespace

PunctureVerdict::Sight sight_of(const Observation& o, const NeedleContact& contact) {
  PunctureVerdict::Sight sight;
  sight.is_tracked_punctured = o.state == CellState::kPunctured;
  sight.has_depths = o.needle && std::isfinite(o.indentation_um);
  if (!sight.has_depths) return sight;
  sight.tip_um = contact.tip_depth_um;
  sight.tip_sigma_um = o.needle->tip_sigma_um > 0.0 ? o.needle->tip_sigma_um : kDefaultTipSigma_um;
  sight.membrane_um = o.indentation_um;
  const bool has_sigma = std::isfinite(o.indentation_sigma_um) && o.indentation_sigma_um > 0.0;
  sight.membrane_sigma_um = has_sigma ? o.indentation_sigma_um : kDefaultDepthSigma_um;
  sight.rest_radius_um = o.rest_outer_radius_um;
  if (o.side_bulge_um > 0.0) sight.side_um = o.side_bulge_um;
  if (o.pierced_probability >= 0.0)
    sight.pierced_probability = pierced_about(o.pierced_probability, sight.tip_um, sight.tip_sigma_um);
  sight.flank_um = flank_depth_um(o, contact);
  if (o.outer) sight.shape_sigma_um = kShapeSigma_ratio * usual_sigma_um(*o.outer);
  // A needle's confidence is a product of several, each of which says how well it was seen.
  sight.confidence = std::min(o.confidence, std::sqrt(std::max(0.0, o.needle->confidence)));
  return sight;
}

}  // namespace pellucida
