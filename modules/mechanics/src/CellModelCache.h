#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "CellPlacement.h"
#include "GeometryEstimate.h"
#include "pellucida/core/Observation.h"
#include "pellucida/mechanics/ScaleMeasurement.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/membrane/EquilibriumPath.h"
#include "pellucida/membrane/Indenter.h"

namespace pellucida {

/// The membrane model of the cell that is seen: of its size, pushed and held as it is. Its equilibria are solved ahead
/// of the needle, on a thread of their own. One thread at a time.
class CellModelCache {
 public:
  explicit CellModelCache(const CellProfile& profile) : profile_(profile), geometry_(profile) {}

  /// Takes over sizes, needle and holder. The model is built anew, at rest, where the radius or the needle's offset
  /// have changed, out of contact also where the thickness or a tool's width have; then true. Precondition: a rest
  /// radius above 0.
  bool fit(const Observation& observation, const CellPlacement& placement);
  void forget() {
    forget_path();
    indenter_.reset();
    geometry_.forget();
  }
  bool exists() const noexcept { return indenter_ != nullptr; }

  // All further ones: only where it exists.
  Indenter& indenter() noexcept { return *indenter_; }
  const Indenter& indenter() const noexcept { return *indenter_; }
  const MembraneModel& model() const noexcept { return indenter_->model(); }

  /// Equilibrium at a depth: `known` (may be null), if it is one at this depth, as the model of another modulus found
  /// it; else read off the path ahead; else, where that ends or the holder has turned since the contact began, solved
  /// from the last one, after a failure from rest. Deeper than the model was found to reach: the deepest one, whose
  /// report says so, at once.
  IndentationState press(double depth_um, const SolvedShape* known = nullptr);
  /// The same, always solved from the last one: with a contour that pulls.
  IndentationState press_solved(double depth_um);
  /// At rest.
  IndentationState release();

  const GeometryEstimate& geometry() const noexcept { return geometry_; }
  const MembraneGeometry& built_geometry() const noexcept {
    return built_;
  }  ///< the model's; `geometry` may differ by
     ///< less than what is built anew for
  double outer_radius_um() const noexcept { return outer_radius_um_; }
  double offset_um() const noexcept { return offset_um_; }  ///< of the needle, as the model has it
  double rest_stiffness_uN_per_um() const noexcept { return rest_stiffness_uN_per_um_; }
  double deepest_um() const noexcept { return 1.4 * model().setup().mid_radius_um; }  ///< that the model reaches

  /// What measurements say of this cell's scale, see `ScaleEstimate`; nothing where the model finds no force at the
  /// depth of a push. Leaves it at rest.
  std::optional<CellScale> scale_after(std::span<const ScaleMeasurement> measurements);
  /// See `ForceObserver::puncture_risk`. Leaves it at rest.
  std::vector<PunctureRisk> puncture_risk(double step_um, const CellScale& scale);

 private:
  struct PushModel {
    double value = 0.0;         // the model's force or stiffness there
    double slope_per_um = 0.0;  // by depth
    double sigma_ratio = 0.0;   // of the model
  };
  std::optional<PushModel> model_of(const Palpation& push);

  void start_path();
  void forget_path();
  void set_deepest(std::optional<SolvedShape> shape);

  const CellProfile& profile_;
  std::unique_ptr<Indenter> indenter_;
  std::unique_ptr<EquilibriumPath> path_;
  int steady_frames_ = 0;    // free ones since the model was built or its holder moved
  bool has_turned_ = false;  // the holder, in this contact: the path is another's
  bool start_anew_ = false;
  std::optional<SolvedShape> deepest_;  // once a deeper one was not found, from rest or on the path
  GeometryEstimate geometry_;
  MembraneGeometry built_;  // the model's
  double outer_radius_um_ = 0.0, offset_um_ = 0.0;
  double rest_stiffness_uN_per_um_ = 0.0;
};

}  // namespace pellucida
