#include "pellucida/dynamics/ExplicitSprings.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "RingOrder.h"
#include "pellucida/linear_algebra/InstructionSet.h"

namespace pellucida {

#define PELLUCIDA_INLINE __attribute__((always_inline)) inline

/// The loops over the groups and over the nodes, to be inlined into a function for each instruction set. No product is
/// fused with a sum and square roots and quotients are exact, so every instruction set gives the same bits.
struct ExplicitSpringsKernel {
  using Group = ExplicitSprings::Group;
  using Sides = ExplicitSprings::Sides;
  static constexpr std::size_t kLanes = ExplicitSprings::kLanes;

  /// A group's lanes; the compiler spreads them over the registers there are.
  using Lanes __attribute__((vector_size(kLanes * sizeof(float)))) = float;

  struct Columns {
    float *x, *y, *z;
  };

  PELLUCIDA_INLINE static void load(Lanes& to, const float* from) { std::memcpy(&to, from, sizeof(to)); }
  PELLUCIDA_INLINE static void add(float* to, const Lanes& what) {
    Lanes sum;
    load(sum, to);
    sum += what;
    std::memcpy(to, &sum, sizeof(sum));
  }
  /// to = from[i ...] - from[j ...].
  PELLUCIDA_INLINE static void difference(Lanes& to, const float* from, const Sides& sides) {
    Lanes other;
    load(to, from + sides.i);
    load(other, from + sides.j);
    to -= other;
  }

  PELLUCIDA_INLINE static void springs(const Group* groups, const Sides* sides, std::size_t count, const Columns u,
                                       const Columns v, const Columns on_i, const Columns on_j,
                                       float damping_uN_s_per_um) {
    const Lanes none = {};
    const Lanes damping = none + damping_uN_s_per_um;
    for (std::size_t g = 0; g < count; ++g, ++groups, ++sides) {
      // Copies, which no force can overwrite.
      const Sides at = *sides;
      Lanes px, py, pz, vx, vy, vz, constant;
      difference(px, u.x, at);
      difference(py, u.y, at);
      difference(pz, u.z, at);
      load(constant, groups->rest_x);
      px += constant;
      load(constant, groups->rest_y);
      py += constant;
      load(constant, groups->rest_z);
      pz += constant;
      difference(vx, v.x, at);
      difference(vy, v.y, at);
      difference(vz, v.z, at);
      const Lanes along = vx * px + vy * py + vz * pz;

      // (|p| / L)^2; the tiny number keeps the lanes of missing connectors finite.
      Lanes per_square, k2, k1;
      load(per_square, groups->per_square);
      load(k2, groups->k2);
      load(k1, groups->k1);
      const Lanes square = (px * px + py * py + pz * pz) * per_square + 1e-12f;
      Lanes root;
      for (std::size_t l = 0; l < kLanes; ++l) root[l] = std::sqrt(square[l]);
      const Lanes inverse = 1.0f / root;
      const Lanes strain = root - 1.0f;
      const Lanes stiffness = k2 + k1 * (strain * strain);
      const Lanes pull = stiffness * (inverse - 1.0f) - (along * per_square) * (inverse * inverse) * damping;
      px *= pull;
      py *= pull;
      pz *= pull;
      add(on_i.x + at.i, px);
      add(on_i.y + at.i, py);
      add(on_i.z + at.i, pz);
      add(on_j.x + at.j, px);
      add(on_j.y + at.j, py);
      add(on_j.z + at.j, pz);
    }
  }

  /// One coordinate of all nodes: eq. (4), and forces set back to zero.
  PELLUCIDA_INLINE static void move(float* __restrict u, float* __restrict lost, float* __restrict v,
                                    const float* __restrict external, float* __restrict on_i, float* __restrict on_j,
                                    std::size_t count, float dt_per_mass, float dt_s) {
    for (std::size_t n = 0; n < count; ++n) {
      v[n] += dt_per_mass * (on_i[n] - on_j[n] + external[n]);
      on_i[n] = 0.0f;
      on_j[n] = 0.0f;
      // Compensated: what a sum loses is put into the next.
      const float increment = dt_s * v[n] - lost[n];
      const float sum = u[n] + increment;
      lost[n] = (sum - u[n]) - increment;
      u[n] = sum;
    }
  }

  static Columns columns(ExplicitSprings::Nodes& nodes) { return {nodes.x.data(), nodes.y.data(), nodes.z.data()}; }

  PELLUCIDA_INLINE static void run(ExplicitSprings& s, float dt_s, int steps) {
    const Columns u = columns(s.displacement_), lost = columns(s.lost_), v = columns(s.velocity_),
                  external = columns(s.external_), on_i = columns(s.force_i_), on_j = columns(s.force_j_);
    const std::size_t nodes = s.place_.size();
    const float dt_per_mass = dt_s * s.per_mass_;
    for (int k = 0; k < steps; ++k) {
      springs(s.groups_.data(), s.sides_.data(), s.groups_.size(), u, v, on_i, on_j, s.damping_uN_s_per_um_);
      move(u.x, lost.x, v.x, external.x, on_i.x, on_j.x, nodes, dt_per_mass, dt_s);
      move(u.y, lost.y, v.y, external.y, on_i.y, on_j.y, nodes, dt_per_mass, dt_s);
      move(u.z, lost.z, v.z, external.z, on_i.z, on_j.z, nodes, dt_per_mass, dt_s);
    }
  }

  static void run_plain(ExplicitSprings& s, float dt_s, int steps) { run(s, dt_s, steps); }
#if defined(__x86_64__)
  __attribute__((target("avx2"))) static void run_avx2(ExplicitSprings& s, float dt_s, int steps) {
    run(s, dt_s, steps);
  }
#endif
};

void ExplicitSprings::Nodes::resize(std::size_t count) {
  for (auto* column : {&x, &y, &z}) column->assign(count, 0.0f);
}

ExplicitSprings::ExplicitSprings(const TriangleMesh& rest, const SpringTerm& springs, double node_mass_kg,
                                 double damping_uN_s_per_um)
    : rest_um_(rest.points_um),
      place_(ring_order(rest)),
      spring_count_(springs.count()),
      per_mass_(static_cast<float>(1.0 / node_mass_kg)),
      damping_uN_s_per_um_(static_cast<float>(damping_uN_s_per_um)) {
  // A group may reach past the last node.
  const std::size_t padded = place_.size() + kLanes;
  for (Nodes* nodes : {&displacement_, &lost_, &velocity_, &external_, &force_i_, &force_j_}) nodes->resize(padded);

  // Connectors from the lower to the higher number, by the difference of the two, then by the lower: what can share a
  // group follows one another. Two connectors between the same nodes are in different groups.
  struct Placed {
    int i, j;
    const SpringTerm::Spring* spring;
  };
  std::vector<Placed> placed;
  for (const auto& spring : springs.springs()) {
    const int a = place_[static_cast<std::size_t>(spring.i)], b = place_[static_cast<std::size_t>(spring.j)];
    placed.push_back({std::min(a, b), std::max(a, b), &spring});
  }
  std::stable_sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) {
    return a.j - a.i != b.j - b.i ? a.j - a.i < b.j - b.i : a.i < b.i;
  });

  std::vector<int> node_at(place_.size());
  for (std::size_t node = 0; node < place_.size(); ++node) {
    node_at[static_cast<std::size_t>(place_[node])] = static_cast<int>(node);
  }
  int last_i = 0;
  for (const Placed& p : placed) {
    const bool fits = !sides_.empty() && sides_.back().j - sides_.back().i == p.j - p.i &&
                      p.i - sides_.back().i < static_cast<int>(kLanes) && p.i > last_i;
    if (!fits) {
      groups_.push_back({});
      sides_.push_back({p.i, p.j});
      for (std::size_t l = 0; l < kLanes; ++l) groups_.back().rest_x[l] = 1.0f;
    }
    last_i = p.i;
    Group& group = groups_.back();
    const auto l = static_cast<std::size_t>(p.i - sides_.back().i);
    const Eigen::Vector3d at_rest =
        rest_um_.col(node_at[static_cast<std::size_t>(p.i)]) - rest_um_.col(node_at[static_cast<std::size_t>(p.j)]);
    const double length_um = p.spring->rest_length_um;
    const double scale = p.spring->area_um2 / (length_um * length_um);
    group.rest_x[l] = static_cast<float>(at_rest.x());
    group.rest_y[l] = static_cast<float>(at_rest.y());
    group.rest_z[l] = static_cast<float>(at_rest.z());
    group.per_square[l] = static_cast<float>(1.0 / (length_um * length_um));
    group.k2[l] = static_cast<float>(scale * p.spring->k2_uN_per_um);
    group.k1[l] = static_cast<float>(scale * p.spring->k1_uN_per_um);
  }

  // Stretch by stretch of nodes, and in each by direction as before.
  std::vector<std::size_t> order(groups_.size());
  for (std::size_t g = 0; g < order.size(); ++g) order[g] = g;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sides_[a].i / kStretch < sides_[b].i / kStretch; });
  std::vector<Group> sorted;
  std::vector<Sides> sorted_sides;
  for (const std::size_t g : order) {
    sorted.push_back(groups_[g]);
    sorted_sides.push_back(sides_[g]);
  }
  groups_ = std::move(sorted);
  sides_ = std::move(sorted_sides);
}

namespace {

template <class Nodes>
void put(Nodes& nodes, std::size_t place, const Eigen::Vector3d& value) {
  nodes.x[place] = static_cast<float>(value.x());
  nodes.y[place] = static_cast<float>(value.y());
  nodes.z[place] = static_cast<float>(value.z());
}

template <class Nodes>
Eigen::Vector3d get(const Nodes& nodes, std::size_t place) {
  return {nodes.x[place], nodes.y[place], nodes.z[place]};
}

}  // namespace

void ExplicitSprings::set_external_force(const Eigen::Matrix3Xd& force_uN) {
  for (Eigen::Index n = 0; n < force_uN.cols(); ++n) {
    put(external_, static_cast<std::size_t>(place_[static_cast<std::size_t>(n)]), force_uN.col(n));
  }
}

void ExplicitSprings::set_state(const MotionState& state) {
  lost_.resize(place_.size() + kLanes);
  for (Eigen::Index n = 0; n < state.x_um.cols(); ++n) {
    const auto place = static_cast<std::size_t>(place_[static_cast<std::size_t>(n)]);
    put(displacement_, place, state.x_um.col(n) - rest_um_.col(n));
    put(velocity_, place, state.v_um_per_s.col(n));
  }
}

MotionState ExplicitSprings::state() const {
  MotionState state{rest_um_, Eigen::Matrix3Xd(3, rest_um_.cols())};
  for (Eigen::Index n = 0; n < rest_um_.cols(); ++n) {
    const auto place = static_cast<std::size_t>(place_[static_cast<std::size_t>(n)]);
    state.x_um.col(n) += get(displacement_, place) - get(lost_, place);
    state.v_um_per_s.col(n) = get(velocity_, place);
  }
  return state;
}

void ExplicitSprings::step(double dt_s, int count) {
#if defined(__x86_64__)
  if (instruction_set() >= InstructionSet::kAvx2) {
    return ExplicitSpringsKernel::run_avx2(*this, static_cast<float>(dt_s), count);
  }
#endif
  ExplicitSpringsKernel::run_plain(*this, static_cast<float>(dt_s), count);
}

Eigen::Matrix3Xd ExplicitSprings::spring_force_uN() {
  using Kernel = ExplicitSpringsKernel;
  Kernel::springs(groups_.data(), sides_.data(), groups_.size(), Kernel::columns(displacement_),
                  Kernel::columns(velocity_), Kernel::columns(force_i_), Kernel::columns(force_j_),
                  damping_uN_s_per_um_);
  Eigen::Matrix3Xd force(3, rest_um_.cols());
  for (Eigen::Index n = 0; n < force.cols(); ++n) {
    const auto place = static_cast<std::size_t>(place_[static_cast<std::size_t>(n)]);
    force.col(n) = get(force_i_, place) - get(force_j_, place);
  }
  force_i_.resize(place_.size() + kLanes);
  force_j_.resize(place_.size() + kLanes);
  return force;
}

double ExplicitSprings::lane_use_ratio() const noexcept {
  return static_cast<double>(spring_count_) / static_cast<double>(kLanes * groups_.size());
}

}  // namespace pellucida
