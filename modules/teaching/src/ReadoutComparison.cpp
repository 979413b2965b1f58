#include "pellucida/teaching/ReadoutComparison.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "pellucida/core/Error.h"
#include "pellucida/mechanics/RevolvedContour.h"
#include "pellucida/mechanics/ShapeAudit.h"
#include "pellucida/membrane/Indenter.h"

namespace pellucida {
namespace {

using R = ReadoutParameters;
constexpr Field<R> kReadoutParameters[] = {
    {"depth_um", "um", &R::depth_um, {1, 44}, "of the needle"},
    {"noise_um", "um", &R::noise_um, {0, 1}, "of each point of the contour, along its normal, standard deviation"},
    {"contour", "", &R::contour, {}, "whose contour is read: `finite-elements` or `model`, the spring network's own"},
    {"mesh_frequency", "", &R::mesh_frequency, {2, 9}, "of the spring network: 10 f^2 + 2 nodes"},
    {"laying",
     "",
     &R::laying,
     {},
     "where on it a node is laid: `nearest`, `equal-distances` (as the points of a snake) or `true-places`"},
    {"draw", "", &R::draw, {1, 1000000}, "number of the noise drawn"},
};

// A point of the contour for each pixel.
constexpr double kPointDistance_um = 0.825;

/// A closed line, point by point round the cell, with an angle at each.
struct AngledLine {
  Contour_um points_um;
  Eigen::VectorXd angle_rad;  ///< rising from -pi to pi
};

/// Points at equal distances along it, the first one where it begins.
AngledLine resampled(const Contour_um& line, const Eigen::VectorXd& angle_rad) {
  const Eigen::Index n = line.cols();
  Eigen::VectorXd length_um(n + 1);
  length_um[0] = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    length_um[i + 1] = length_um[i] + (line.col((i + 1) % n) - line.col(i)).norm();
  }
  const auto count = static_cast<Eigen::Index>(std::lround(length_um[n] / kPointDistance_um));
  AngledLine even{Contour_um(2, count), Eigen::VectorXd(count)};
  Eigen::Index segment = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const double at_um = length_um[n] * static_cast<double>(k) / static_cast<double>(count);
    while (length_um[segment + 1] <= at_um) ++segment;
    const double t = (at_um - length_um[segment]) / (length_um[segment + 1] - length_um[segment]);
    const Eigen::Index next = (segment + 1) % n;
    even.points_um.col(k) = (1.0 - t) * line.col(segment) + t * line.col(next);
    const double next_rad = next == 0 ? angle_rad[0] + 2.0 * std::numbers::pi : angle_rad[next];
    even.angle_rad[k] = (1.0 - t) * angle_rad[segment] + t * next_rad;
  }
  return even;
}

/// The angles that the line's points would have at rest if it were stretched evenly, from its tip both ways round.
Eigen::VectorXd even_angles_rad(const AngledLine& line) {
  const Eigen::Index n = line.points_um.cols();
  Eigen::VectorXd length_um(n + 1);
  length_um[0] = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    length_um[i + 1] = length_um[i] + (line.points_um.col((i + 1) % n) - line.points_um.col(i)).norm();
  }
  Eigen::Index tip = 0;
  line.angle_rad.cwiseAbs().minCoeff(&tip);
  return 2.0 * std::numbers::pi / length_um[n] * (length_um.head(n).array() - length_um[tip]).matrix();
}

/// The line's place at an angle, by its points' `angle_rad`.
Eigen::Vector2d place_at(const Contour_um& points_um, const Eigen::VectorXd& angle_rad, double at_rad) {
  const double turn = 2.0 * std::numbers::pi;
  const double first = angle_rad[0];
  const double wanted = at_rad - turn * std::floor((at_rad - first) / turn);
  const Eigen::Index n = angle_rad.size();
  const auto above = std::upper_bound(angle_rad.data(), angle_rad.data() + n, wanted) - angle_rad.data();
  const Eigen::Index before = above - 1, next = above == n ? 0 : above;
  const double next_rad = next == 0 ? first + turn : angle_rad[next];
  const double t = (wanted - angle_rad[before]) / (next_rad - angle_rad[before]);
  return (1.0 - t) * points_um.col(before) + t * points_um.col(next);
}

/// Outward, of a line that runs from z towards x.
Eigen::Vector2d outward_at(const Contour_um& line, Eigen::Index i) {
  const Eigen::Index n = line.cols();
  const Eigen::Vector2d along = line.col((i + 1) % n) - line.col((i + n - 1) % n);
  return Eigen::Vector2d(-along.y(), along.x()).normalized();
}

}  // namespace

FieldList fields_of(ReadoutParameters& parameters) {
  FieldList list;
  list.add("", kReadoutParameters, parameters);
  return list;
}

Laying laying_of(const std::string& name) {
  if (name == "nearest") return Laying::kNearest;
  if (name == "equal-distances") return Laying::kEqualDistances;
  if (name == "true-places") return Laying::kTruePlaces;
  throw UsageError("laying " + name + ": not known; known are nearest, equal-distances, true-places");
}

bool is_of_finite_elements(const ReadoutParameters& parameters) {
  if (parameters.contour == "finite-elements") return true;
  if (parameters.contour == "model") return false;
  throw UsageError("contour " + parameters.contour + ": not known; known are finite-elements, model");
}

void require_valid(const ReadoutParameters& parameters) {
  ReadoutParameters copy = parameters;
  if (const auto fault = range_fault(fields_of(copy))) throw UsageError(*fault);
  is_of_finite_elements(parameters);
  laying_of(parameters.laying);
}

class ReadoutComparison::Impl {
 public:
  explicit Impl(int mesh_frequency)
      : profile_(profile_with(mesh_frequency)),
        indenter_(profile_, setup_for_configuration(profile_, 1)),
        model_(profile_, setup_for_configuration(profile_, 1)),
        mesh_(std::make_shared<CellMesh>(mesh_of(model_, profile_))) {
    auditor_.set_model(model_.rest());
    // In the image x is C's x and y its z.
    rotation_WC_ << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  }

  bool press(double depth_um) { return indenter_.advance_to(depth_um).report.status == SolveStatus::kConverged; }

  TrueSection own_section(double depth_um) {
    TrueSection section;
    section.force_uN = indenter_.advance_to(depth_um).push_force_uN;
    const auto& nodes = auditor_.nodes();
    const auto count = static_cast<Eigen::Index>(nodes.size());
    Contour_um middle(2, count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const Eigen::Vector3d x_um = indenter_.positions_um().col(nodes[static_cast<std::size_t>(k)]);
      middle.col(k) = Eigen::Vector2d(x_um.x(), x_um.z());
    }
    section.outer_um = section.inner_um = middle;
    section.angle_rad = Eigen::Map<const Eigen::VectorXd>(auditor_.rest_angle_rad().data(), count);
    for (Eigen::Index k = 0; k < count; ++k) {
      // Rest angles rise from z towards x.
      const Eigen::Vector2d half_um = 0.5 * mesh_->thickness_um * outward_at(middle, k);
      section.outer_um.col(k) += half_um;
      section.inner_um.col(k) -= half_um;
    }
    return section;
  }

  expected<ReadoutPair, StepFailure> read(const ReadoutParameters& p, const TrueSection& section,
                                          std::optional<int> node) {
    require_valid(p);
    ReadoutPair pair;
    pair.parameters = p;
    pair.true_force_uN = section.force_uN;
    std::mt19937_64 random(static_cast<std::uint64_t>(p.draw));
    AngledLine outer = resampled(section.outer_um, section.angle_rad);
    AngledLine inner = resampled(section.inner_um, section.angle_rad);
    pair.seen_depth_um = p.depth_um + add_noise(p.noise_um, random, outer.points_um);
    add_noise(p.noise_um, random, inner.points_um);

    const IndentationState state = indenter_.advance_to(std::max(0.0, pair.seen_depth_um));
    if (state.report.status != SolveStatus::kConverged) {
      return unexpected<StepFailure>(StepFailure{"no equilibrium: " + std::string(to_string(state.report.status))});
    }
    pair.equilibrium.force_uN = state.push_force_uN;
    model_.set_depth(std::max(0.0, pair.seen_depth_um));
    show(indenter_.positions_um(), p, node, pair.seen_depth_um, pair.equilibrium);

    const Eigen::Matrix3Xd laid = lay(laying_of(p.laying), outer, inner);
    pair.prescribed.force_uN = naive_force_uN(model_, laid);
    show(laid, p, node, pair.seen_depth_um, pair.prescribed);
    return pair;
  }

 private:
  static CellProfile profile_with(int mesh_frequency) {
    TeachingParameters parameters;
    parameters.mesh_frequency = mesh_frequency;
    return profile_of(parameters);
  }

  /// Returns by how much deeper the membrane under the tip is seen.
  double add_noise(double noise_um, std::mt19937_64& random, Contour_um& points_um) const {
    std::normal_distribution<double> noise(0.0, 1.0);
    const Contour_um clean = points_um;
    double deeper_um = 0.0;
    int under_tip = 0;
    for (Eigen::Index i = 0; i < clean.cols(); ++i) {
      const Eigen::Vector2d outward = outward_at(clean, i);
      const Eigen::Vector2d off_um = noise_um * noise(random) * outward;
      points_um.col(i) += off_um;
      if (std::abs(clean(0, i)) > mesh_->tip_radius_um || outward.y() < 0.5) continue;
      deeper_um -= off_um.y();
      ++under_tip;
    }
    return under_tip > 0 ? deeper_um / under_tip : 0.0;
  }

  Eigen::Matrix3Xd lay(Laying laying, const AngledLine& outer, const AngledLine& inner) {
    if (laying == Laying::kNearest) {
      Observation seen;
      seen.outer = MembraneContour{.membrane = Membrane::kOuter, .points_um = outer.points_um};
      seen.inner = MembraneContour{.membrane = Membrane::kInner, .points_um = inner.points_um};
      auditor_.audit(seen, indenter_.positions_um(), rotation_WC_, Eigen::Vector3d::Zero(), mesh_->thickness_um);
      return lay_on_contour(model_.rest(), indenter_.positions_um(), auditor_);
    }
    const bool evenly = laying == Laying::kEqualDistances;
    const Eigen::VectorXd outer_rad = evenly ? even_angles_rad(outer) : outer.angle_rad;
    const Eigen::VectorXd inner_rad = evenly ? even_angles_rad(inner) : inner.angle_rad;
    const auto middle_at = [&](double angle_rad) -> Eigen::Vector2d {
      return 0.5 * (place_at(outer.points_um, outer_rad, angle_rad) + place_at(inner.points_um, inner_rad, angle_rad));
    };
    // Between the section's two sides the mean, weighted by the azimuth, as in `revolve_residual`.
    const Eigen::Matrix3Xd& rest_um = model_.rest().points_um;
    Eigen::Matrix3Xd laid_um(3, rest_um.cols());
    for (Eigen::Index n = 0; n < rest_um.cols(); ++n) {
      const double across_um = std::hypot(rest_um(0, n), rest_um(1, n));
      const double angle_rad = std::atan2(across_um, rest_um(2, n));
      const Eigen::Vector2d azimuth =
          across_um > 0.0 ? Eigen::Vector2d(rest_um.col(n).head<2>() / across_um) : Eigen::Vector2d::UnitX();
      const double right = across_um > 0.0 ? 0.5 + 0.5 * azimuth.x() : 0.5;
      const Eigen::Vector2d one = middle_at(angle_rad), other = middle_at(-angle_rad);
      const double off_um = across_um > 0.0 ? right * one.x() - (1.0 - right) * other.x() : 0.0;
      laid_um.col(n) << off_um * azimuth.x(), off_um * azimuth.y(), right * one.y() + (1.0 - right) * other.y();
    }
    return laid_um;
  }

  void show(const Eigen::Matrix3Xd& x_um, const ReadoutParameters& p, std::optional<int> node, double depth_um,
            Readout& readout) const {
    CellSnapshot& s = readout.shape;
    s.mesh = mesh_;
    s.parameters.mesh_frequency = p.mesh_frequency;
    s.x_um = x_um;
    s.spring_pull_uN = spring_pulls_uN(model_.springs(), x_um);
    s.tip_um = depth_um * mesh_->push;
    s.hand_along_um = s.depth_um = depth_um;
    s.force_uN = readout.force_uN;
    s.field_uN = model_.elastic_force_uN(x_um);
    if (!node || *node >= x_um.cols()) return;
    const Eigen::Matrix3Xd still = Eigen::Matrix3Xd::Zero(3, x_um.cols());
    s.node_forces = node_forces(model_, mesh_->directions, 0.0, 0.0, {x_um, still}, still, *node);
  }

  CellProfile profile_;
  Indenter indenter_;
  MembraneModel model_;  // to read shapes with
  std::shared_ptr<const CellMesh> mesh_;
  ShapeAuditor auditor_;
  Eigen::Matrix3d rotation_WC_;
};

ReadoutComparison::ReadoutComparison(int mesh_frequency) : impl_(std::make_unique<Impl>(mesh_frequency)) {}
ReadoutComparison::~ReadoutComparison() = default;

TrueSection ReadoutComparison::own_section(double depth_um) {
  return impl_->own_section(depth_um);
}

expected<ReadoutPair, StepFailure> ReadoutComparison::read(const ReadoutParameters& parameters,
                                                           const TrueSection& section, std::optional<int> node) {
  return impl_->read(parameters, section, node);
}

}  // namespace pellucida
