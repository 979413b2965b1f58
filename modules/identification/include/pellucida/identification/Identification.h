#pragma once
#include <functional>
#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

#include "pellucida/identification/ConstantsFit.h"
#include "pellucida/identification/ForceScale.h"
#include "pellucida/identification/MeasuredCurve.h"
#include "pellucida/identification/ReferenceCurves.h"
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

/// The mouse oocyte of the paper's Table I as a cell to identify: geometry, material, tools and mesh; no constants yet.
CellProfile table_one_oocyte();

struct IdentificationRequest {
  /// Geometry, Young's modulus, Poisson's ratio, puncture point, tools, the mesh's frequency, name and sources. What
  /// identification finds (constants, regions, grading, effective modulus and its uncertainty, m, b, errors) is
  /// overwritten; constants already present are the start of the fit.
  CellProfile cell = table_one_oocyte();
  std::optional<MeasuredCurve> measured;    ///< anchors the force scale; without it the puncture point does
  double assumed_scale_sigma_ratio = 0.05;  ///< of the scale, where one point alone anchors it
  double max_indentation_um = 0.0;          ///< of the curves; 0: the deeper of the puncture and 1.06 R
  double step_um = 2.0;                     ///< between their points
  double edge_length_ratio = 1.0;           ///< of the finite-element mesh, see ShellOptions
  int threads = 0;                          ///< 0: as many as the machine has cores
};

/// One configuration as it was identified. Forces in uN at the reference's depths, both scaled to the anchor.
struct IdentifiedCurve {
  ReferenceCurve reference;
  Eigen::VectorXd model_force_uN;  ///< as many as the model reached
  CurveError error;                ///< from 4 um to the puncture
};

struct Identification {
  CellProfile profile;
  std::vector<IdentifiedCurve> curves;   ///< configurations 1 to 4, thin shell
  std::optional<IdentifiedCurve> solid;  ///< configuration 1, solid of revolution, where that could be solved
  ForceScale scale;                      ///< of the model
  FitReport fit;
  double reference_s = 0.0;  ///< wall time of the finite elements
  double fit_s = 0.0;        ///< of the fit
};

/// Runs the finite-element reference in the four configurations, fits the nine constants to its curves, and sets the
/// force scale to the anchor. The same request gives the same profile. `progress` is called with the current stage and
/// its share done, 0 to 1, from any thread, one call at a time. Throws UsageError for a geometry or a number outside
/// its range, NothingMeasuredError when no usable curve or constants resulted, Error (internal error) on cancellation.
Identification identify(const IdentificationRequest& request,
                        const std::function<void(std::string_view stage, double share)>& progress = {},
                        const std::stop_token& cancel = {});

/// The cost of an identification with the defaults, for the benchmark.
struct IdentificationTimes {
  double wall_s = 0.0;
  double processor_s = 0.0;  ///< of all threads
  double reference_s = 0.0;  ///< wall time of the finite elements
  double fit_s = 0.0;        ///< wall time of the fit
  int fit_evaluations = 0;
};
IdentificationTimes measure_identification();

}  // namespace pellucida
