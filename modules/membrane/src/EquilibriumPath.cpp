#include "pellucida/membrane/EquilibriumPath.h"

#include <cmath>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "pellucida/core/Background.h"

namespace pellucida {
namespace {

/// An equilibrium of the path, and how its read-outs change with the depth.
struct PathNode {
  SolvedShape shape;
  ToolForces slope_per_um;
};

/// The cubic that passes through two ends with given slopes, at `s` (0 to 1) of the way `step`: weights of the first
/// end's value and slope, and of the second's; for the value, and for its derivative.
struct HermiteWeights {
  HermiteWeights(double s, double step) {
    const double r = 1.0 - s;
    value[0] = r * r * (1.0 + 2.0 * s);
    value[1] = step * s * r * r;
    value[2] = s * s * (3.0 - 2.0 * s);
    value[3] = -step * s * s * r;
    slope[0] = -6.0 * s * r / step;
    slope[1] = r * (1.0 - 3.0 * s);
    slope[2] = -slope[0];
    slope[3] = s * (3.0 * s - 2.0);
  }
  double value[4], slope[4];
};

template <class T>
T mix(const double (&w)[4], const T& a, const T& a_slope, const T& b, const T& b_slope) {
  return w[0] * a + w[1] * a_slope + w[2] * b + w[3] * b_slope;
}

SolvedShape between(const PathNode& a, const PathNode& b, double depth_um) {
  const double step_um = b.shape.depth_um - a.shape.depth_um;
  const double s = (depth_um - a.shape.depth_um) / step_um;
  const HermiteWeights w(s, step_um);
  const ToolForces &fa = a.shape.forces, &fb = b.shape.forces, &sa = a.slope_per_um, &sb = b.slope_per_um;
  SolvedShape shape;
  shape.depth_um = depth_um;
  shape.positions_um = w.value[0] * a.shape.positions_um + w.value[1] * a.shape.depth_tangent +
                       w.value[2] * b.shape.positions_um + w.value[3] * b.shape.depth_tangent;
  shape.depth_tangent = w.slope[0] * a.shape.positions_um + w.slope[1] * a.shape.depth_tangent +
                        w.slope[2] * b.shape.positions_um + w.slope[3] * b.shape.depth_tangent;
  // For the nodes' intervals alone: linear is enough.
  shape.elastic_slope_uN_per_um = (1.0 - s) * a.shape.elastic_slope_uN_per_um + s * b.shape.elastic_slope_uN_per_um;
  shape.forces.tip_uN = mix<Eigen::Vector3d>(w.value, fa.tip_uN, sa.tip_uN, fb.tip_uN, sb.tip_uN);
  shape.forces.holder_uN = mix<Eigen::Vector3d>(w.value, fa.holder_uN, sa.holder_uN, fb.holder_uN, sb.holder_uN);
  shape.forces.push_uN = mix(w.value, fa.push_uN, sa.push_uN, fb.push_uN, sb.push_uN);
  shape.forces.pressure_Pa = mix(w.value, fa.pressure_Pa, sa.pressure_Pa, fb.pressure_Pa, sb.pressure_Pa);
  shape.forces.volume_um3 = mix(w.value, fa.volume_um3, sa.volume_um3, fb.volume_um3, sb.volume_um3);
  shape.stiffness_uN_per_um = mix(w.slope, fa.push_uN, sa.push_uN, fb.push_uN, sb.push_uN);
  shape.force_scale_uN_per_um = a.shape.force_scale_uN_per_um;
  shape.report.status = SolveStatus::kConverged;
  return shape;
}

}  // namespace

class EquilibriumPath::Impl {
 public:
  Impl(const CellProfile& kind, const MembraneGeometry& geometry, const Eigen::Vector3d& push,
       const Eigen::Vector3d& holder)
      : kind_(kind), geometry_(geometry), push_(push), holder_(holder) {
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }

  std::optional<SolvedShape> at(double depth_um) {
    const auto before = static_cast<std::size_t>(depth_um / kStep_um);
    std::unique_lock lock(mutex_);
    wanted_um_ = depth_um + kAhead_um;
    wanted_.notify_all();
    solved_.wait(lock, [&] { return nodes_.size() > before + 1 || has_ended_; });
    if (nodes_.size() <= before + 1) return std::nullopt;
    // The nodes stay where they are while the thread adds others behind them.
    const PathNode &a = nodes_[before], &b = nodes_[before + 1];
    lock.unlock();
    return between(a, b, depth_um);
  }

  std::optional<SolvedShape> end() const {
    const std::scoped_lock lock(mutex_);
    return end_;
  }

  double solved_to_um() const {
    const std::scoped_lock lock(mutex_);
    return nodes_.empty() ? 0.0 : nodes_.back().shape.depth_um;
  }

 private:
  void run(const std::stop_token& stop) {
    work_in_background();
    try {
      Indenter indenter(kind_, geometry_, push_, holder_);
      while (wait_for_wish(stop) && add_node(indenter)) {
      }
    } catch (const std::exception&) {
      // Out of memory, say: the path ends here, and its reader solves by itself.
    }
    const std::scoped_lock lock(mutex_);
    has_ended_ = true;
    solved_.notify_all();
  }

  /// False: enough.
  bool wait_for_wish(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    return wanted_.wait(lock, stop,
                        [this] { return static_cast<double>(nodes_.size()) * kStep_um <= wanted_um_ + kStep_um; });
  }

  bool add_node(Indenter& indenter) {
    const IndentationState state = indenter.advance_to(static_cast<double>(nodes_.size()) * kStep_um);
    if (state.report.status != SolveStatus::kConverged) {
      SolvedShape end = indenter.shape(state.report);
      const std::scoped_lock lock(mutex_);
      end_ = std::move(end);
      return false;
    }
    PathNode node{indenter.shape(state.report), indenter.force_slopes()};
    const std::scoped_lock lock(mutex_);
    nodes_.push_back(std::move(node));
    solved_.notify_all();
    return true;
  }

  const CellProfile kind_;
  const MembraneGeometry geometry_;
  const Eigen::Vector3d push_, holder_;
  mutable std::mutex mutex_;
  std::condition_variable_any wanted_, solved_;
  std::deque<PathNode> nodes_;  // `kStep_um` apart, from 0; only the thread adds
  double wanted_um_ = kAhead_um;
  bool has_ended_ = false;
  std::optional<SolvedShape> end_;
  std::jthread thread_;  // last: it uses all of the above
};

EquilibriumPath::EquilibriumPath(const CellProfile& kind, const MembraneGeometry& geometry, const Eigen::Vector3d& push,
                                 const Eigen::Vector3d& holder)
    : impl_(std::make_unique<Impl>(kind, geometry, push, holder)) {}
EquilibriumPath::~EquilibriumPath() = default;

std::optional<SolvedShape> EquilibriumPath::at(double depth_um) {
  return impl_->at(depth_um);
}
std::optional<SolvedShape> EquilibriumPath::end() const {
  return impl_->end();
}
double EquilibriumPath::solved_to_um() const {
  return impl_->solved_to_um();
}

}  // namespace pellucida
