#pragma once
#include <optional>

#include "pellucida/core/Observation.h"
#include "pellucida/membrane/IndentedSolid.h"
#include "pellucida/membrane/MembraneGeometry.h"

namespace pellucida {

/// The geometry of the cell and the tools in view: each length as it is seen, or the profile's where it is not, with
/// what either is worth. Tools are measured until the needle touches, while their outlines are clear, and kept in
/// contact. One thread at a time.
class GeometryEstimate {
 public:
  explicit GeometryEstimate(const CellProfile& profile) : profile_(&profile) {}

  /// Precondition: a rest radius above 0.
  void update(const Observation& observation);
  void forget() { *this = GeometryEstimate(*profile_); }

  const MembraneGeometry& geometry() const noexcept { return geometry_; }
  /// The inner membrane was not seen at rest: what is likely of the profile's kind, and of a zona whose edge is missed.
  bool thickness_assumed() const noexcept { return thickness_assumed_; }
  double thickness_um() const noexcept { return seen_thickness_um_; }  ///< as seen, or what is likely
  /// Standard deviations of the logarithms of thickness, tip and holder.
  LogSizes log_sigmas() const noexcept {
    return {thickness_sigma_um_ / geometry_.thickness_um, tip_sigma_, holder_sigma_};
  }
  /// Standard deviation of ln force from all lengths. `by_solid`: that from thickness, tip and holder at a depth, and
  /// of the force's law, where the solid says; else by usual powers, with `springs_spread_ratio`.
  double force_sigma_ratio(std::optional<double> by_solid = std::nullopt) const noexcept;
  /// What the springs' force with its factor differs by from the solid's, of its logarithm, in this geometry.
  double springs_spread_ratio() const noexcept;

  /// With its standard deviation.
  struct Thickness {
    double mean_um = 0.0, sigma_um = 0.0;
  };

 private:
  /// The mean of the logarithm of a length over the frames that show it, and that of its standard deviation.
  struct Seen {
    double log_um = 0.0, sigma = 0.0;
    int count = 0;
    void add(double length_um, double log_sigma);
  };
  /// With the standard deviation of its logarithm.
  struct Length {
    double length_um = 0.0, sigma = 0.0;
  };
  bool is_likely_holder(double radius_um) const noexcept;
  static Length known_holder(const Seen& seen, const Length& usual);

  const CellProfile* profile_;
  MembraneGeometry geometry_;
  double seen_thickness_um_ = 0.0, thickness_sigma_um_ = 0.0, tip_sigma_ = 0.0, holder_sigma_ = 0.0;
  bool thickness_assumed_ = false;
  Seen tip_, holder_;
};

}  // namespace pellucida
