#pragma once
#include <Eigen/Core>
#include <array>
#include <limits>
#include <optional>
#include <string>

#include "pellucida/core_vtk/Scene.h"
#include "pellucida/haptics/CellGuards.h"
#include "pellucida/planning/InjectionPlan.h"
#include "presenters/Phrase.h"

namespace pellucida {

/// How a gauge must be seen.
enum class GaugeLevel {
  kCalm,   ///< within its limit
  kNear,   ///< from where the push is slowed on
  kOver,   ///< at its limit or beyond
  kDoubt,  ///< there is a number, and something speaks against it
  kNone    ///< no number where one is needed
};

/// One gauge: a number, and a bar on which `kLimitShare` of the length is the limit, the same place on every gauge.
/// Texts are UTF-8; shares are of the bar, 0..1, cut off at its ends; NaN: not drawn.
struct Gauge {
  static constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  static constexpr double kLimitShare = 0.8;

  std::string key;    ///< of its parts in the window
  std::string name;   ///< "FORCE"
  std::string value;  ///< "5.96 µN"
  std::string note;   ///< its interval, or what it means
  std::string limit;  ///< "limit 9.4 µN": what the mark is
  std::string alarm;  ///< a few words where the level isn't calm; else empty
  std::string truth;  ///< "true 5.90": of a virtual specimen, where it is to be shown; else empty
  std::string tip;
  GaugeLevel level = GaugeLevel::kCalm;
  double share = kNothing;
  double from = kNothing, to = kNothing;              ///< the whole 95 % interval
  double inner_from = kNothing, inner_to = kNothing;  ///< the part of it that the picture leaves open
  double limit_share = kNothing;
  double truth_share = kNothing;  ///< a mark of its own
  double usual_share = kNothing;  ///< a fine mark: where a cell of this kind and these sizes is expected to give way

  /// Looks the same, NaN beside NaN included.
  bool operator==(const Gauge& other) const;
};

/// What the gauges are made from. No number is the gauges' own: limits come from the hand's settings, the profile and
/// the plan.
struct GaugeInput {
  const Scene* scene = nullptr;  ///< the one shown; nullptr: none was measured yet
  bool has_hand = false;         ///< its limits are kept by a hand at work; else they are the profile's puncture
  CellLimits limits;
  CellStrength strength;                  ///< of the profile's kind
  const InjectionPlan* plan = nullptr;    ///< nullptr: none
  double depth_stop_um = 0.0;             ///< beyond the entry; counts with a plan
  std::optional<Eigen::Vector3d> tip_um;  ///< as the manipulator reports it
  std::optional<double> speed_um_per_s;   ///< of the tip, above 0 into the cell
  std::optional<double> true_force_uN;    ///< of a virtual specimen in this frame, where it is to be shown
  double frame_age_s = 0.0;               ///< of the newest measured frame
  bool is_still = false;                  ///< paused, or the source has ended: no age counts
};

/// Force, depth, speed, distance to the target.
std::array<Gauge, 4> make_gauges(const GaugeInput& input);

/// The plan's way into the cell, else the one the needle of `scene` points; zero without either.
Eigen::Vector3d way_inwards(const InjectionPlan* plan, const Scene* scene);

/// Velocity of a tip from its positions: their mean over the last tenths of a second, since a hand and a manipulator
/// advance in steps.
class TipSpeed {
 public:
  /// Takes the position at `time_s`; one at the same time as the last adds nothing. um/s; nothing before a second
  /// position.
  std::optional<Eigen::Vector3d> update(double time_s, const Eigen::Vector3d& tip_um);
  /// The same as a speed, um/s, above 0 along `way`.
  std::optional<double> update(double time_s, const Eigen::Vector3d& tip_um, const Eigen::Vector3d& way);
  /// The velocity from the next measured scene, along the needle. um/s, above 0 into the cell; nothing while no tip is
  /// seen.
  std::optional<double> update(const Scene& scene);
  /// The next position begins anew.
  void forget();

 private:
  std::optional<Eigen::Vector3d> tip_um_, velocity_um_per_s_;
  double time_s_ = 0.0;
};

}  // namespace pellucida
