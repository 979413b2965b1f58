#include "pellucida/membrane/IndentedSolid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "pellucida/core/Error.h"
#include "pellucida/core/Resources.h"

namespace pellucida {
namespace {

using Json = nlohmann::json;

/// The force's usual power in the thickness; the fit holds what differs from it.
constexpr double kThicknessPower = 1.2;
/// See `stiffening_effect`.
constexpr double kStiffeningScale = 0.3;
/// Powers are below this.
constexpr std::size_t kDegrees = 8;

Eigen::MatrixXd matrix_of(const Json& rows) {
  const auto lists = rows.get<std::vector<std::vector<double>>>();
  if (lists.empty()) throw InputError("a table is empty");
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(lists.size()), static_cast<Eigen::Index>(lists.front().size()));
  for (std::size_t r = 0; r < lists.size(); ++r) {
    if (lists[r].size() != lists.front().size()) throw InputError("the rows of a table differ in length");
    for (std::size_t c = 0; c < lists[r].size(); ++c)
      matrix(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = lists[r][c];
  }
  return matrix;
}

Eigen::VectorXd vector_of(const Json& list) {
  const auto values = list.get<std::vector<double>>();
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

double stiffening_effect(double stiffening) noexcept {
  return std::log1p(stiffening / kStiffeningScale);
}

double stiffening_of(double effect) noexcept {
  return kStiffeningScale * std::expm1(effect);
}

const IndentedSolid& IndentedSolid::shipped() {
  static const IndentedSolid solid = [] {
    const auto path = find_resource("shapes", "indented_solid", ".json");
    IndentedSolid made;
    try {
      std::ifstream file(path);
      const Json json = Json::parse(file);
      made.centre_ = vector_of(json.at("parameter_centre"));
      made.width_ = vector_of(json.at("parameter_width"));
      made.lowest_ = vector_of(json.at("parameter_from"));
      made.highest_ = vector_of(json.at("parameter_to"));
      made.depth_centre_ = json.at("depth_centre").get<double>();
      made.deepest_ratio_ = json.at("deepest_ratio").get<double>();
      const Eigen::MatrixXd powers = matrix_of(json.at("powers")).transpose();
      if (powers.rows() != made.powers_.rows() || powers.minCoeff() < 0 || powers.maxCoeff() >= kDegrees)
        throw InputError("its powers are none of six variables to degree 7");
      made.powers_ = powers.cast<int>();
      made.angle_rad_ = std::numbers::pi / 180.0 * vector_of(json.at("angle_deg"));
      made.section_ = matrix_of(json.at("components")).transpose() * matrix_of(json.at("section_terms")).transpose();
      made.force_ = vector_of(json.at("force_terms"));
      made.pressure_ = vector_of(json.at("pressure_terms"));
    } catch (const std::exception& error) {
      throw InputError(path.string() + ": " + error.what() + "; install the program again");
    }
    const Eigen::Index terms = made.powers_.cols(), n = made.angle_rad_.size();
    if (made.section_.rows() != 2 * n || made.section_.cols() != terms || made.force_.size() != terms ||
        made.pressure_.size() != terms)
      throw InputError(path.string() + ": its tables don't fit each other; install the program again");
    return made;
  }();
  return solid;
}

SolidParameters IndentedSolid::within_range(const SolidParameters& parameters) const {
  return parameters.cwiseMax(lowest_).cwiseMin(highest_);
}

// By the angle of a point's direction.
std::array<Eigen::Matrix2Xd, 2> IndentedSolid::rest(double elongation) const {
  const Eigen::ArrayXd sine = angle_rad_.array().sin(), cosine = angle_rad_.array().cos();
  const Eigen::ArrayXd along = std::exp(-elongation) * cosine.square(), across = std::exp(elongation) * sine.square();
  const Eigen::ArrayXd radius = (along + across).rsqrt();
  const Eigen::ArrayXd slope = 0.5 * radius.cube() * (along - across);
  std::array<Eigen::Matrix2Xd, 2> both;
  for (Eigen::Matrix2Xd& one : both) one.resize(2, angle_rad_.size());
  both[0] << (radius * sine).transpose(), (radius * cosine).transpose();
  both[1] << (slope * sine).transpose(), (slope * cosine).transpose();
  return both;
}

IndentedSolid::Basis IndentedSolid::basis(const SolidParameters& parameters, double depth_ratio) const {
  const SolidParameters u = (within_range(parameters) - centre_).cwiseQuotient(width_);
  const double depth = std::clamp(depth_ratio, 0.0, deepest_ratio_) / depth_centre_ - 1.0;
  // Powers of each parameter, and Chebyshev's polynomials of the depth, with their derivatives.
  using Powers = std::array<std::array<double, kDegrees>, kParameters + 1>;
  Powers power, slope;
  for (std::size_t p = 0; p < kParameters; ++p) {
    const auto at = static_cast<Eigen::Index>(p);
    power[p][0] = 1.0;
    slope[p][0] = 0.0;
    for (std::size_t k = 1; k < kDegrees; ++k) {
      power[p][k] = power[p][k - 1] * u[at];
      slope[p][k] = static_cast<double>(k) * power[p][k - 1] / width_[at];
    }
  }
  auto &value = power[kParameters], &by_depth = slope[kParameters];
  value = {1.0, depth};
  by_depth = {0.0, 1.0};
  for (std::size_t k = 2; k < kDegrees; ++k) {
    value[k] = 2.0 * depth * value[k - 1] - value[k - 2];
    by_depth[k] = 2.0 * value[k - 1] + 2.0 * depth * by_depth[k - 1] - by_depth[k - 2];
  }
  for (double& one : by_depth) one /= depth_centre_;

  Basis sloped(powers_.cols(), kParameters + 2);
  for (Eigen::Index k = 0; k < powers_.cols(); ++k) {
    std::array<double, kParameters + 1> factor, factor_slope;
    double before = 1.0;  // product of the factors before
    for (std::size_t p = 0; p <= kParameters; ++p) {
      const auto degree = static_cast<std::size_t>(powers_(static_cast<Eigen::Index>(p), k));
      factor[p] = power[p][degree];
      factor_slope[p] = slope[p][degree];
    }
    double after[kParameters + 2];
    after[kParameters + 1] = 1.0;
    for (std::size_t p = kParameters + 1; p-- > 0;) after[p] = after[p + 1] * factor[p];
    sloped(k, 0) = after[0];
    for (std::size_t p = 0; p <= kParameters; ++p) {
      sloped(k, static_cast<Eigen::Index>(p) + 1) = before * factor_slope[p] * after[p + 1];
      before *= factor[p];
    }
  }
  return sloped;
}

IndentedSolid::Section IndentedSolid::section(const SolidParameters& parameters, double depth_ratio) const {
  const double depth = std::clamp(depth_ratio, 0.0, deepest_ratio_);
  const Basis moved = section_ * basis(parameters, depth);
  const auto part = [&](int column) { return moved.col(column).reshaped(2, angle_rad_.size()); };
  const auto [rest, rest_slope] = this->rest(within_range(parameters)[kElongation]);
  Section section;
  section.places = rest + depth * part(0);
  section.by_depth = part(0) + depth * part(kParameters + 1);
  for (int p = 0; p < kParameters; ++p) section.by_parameter[static_cast<std::size_t>(p)] = depth * part(p + 1);
  section.by_parameter[kElongation] += rest_slope;
  return section;
}

IndentedSolid::Load IndentedSolid::load(const SolidParameters& parameters, double depth_ratio) const {
  const Basis at = basis(parameters, depth_ratio);
  const double depth = std::min(depth_ratio, deepest_ratio_);
  Load load;
  load.log_force = at.col(0).dot(force_) + kThicknessPower * within_range(parameters)[0] + std::log(depth);
  load.log_pressure = load.log_force + at.col(0).dot(pressure_);
  load.by_parameter = at.middleCols<kParameters>(1).transpose() * force_;
  load.by_parameter[0] += kThicknessPower;
  load.by_depth = at.col(kParameters + 1).dot(force_) + 1.0 / depth;
  if (depth_ratio <= depth) return load;
  const double power = load.by_depth * depth;
  load.log_force += power * std::log(depth_ratio / depth);
  load.by_depth = power / depth_ratio;
  return load;
}

}  // namespace pellucida
