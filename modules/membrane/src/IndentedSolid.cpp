#include "pellucida/membrane/IndentedSolid.h"

#include <algorithm>
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

const IndentedSolid& IndentedSolid::shipped() {
  static const IndentedSolid solid = [] {
    const auto path = find_resource("shapes", "indented_solid", ".json");
    IndentedSolid made;
    try {
      std::ifstream file(path);
      const Json json = Json::parse(file);
      made.centre_ = vector_of(json.at("log_size_centre"));
      made.width_ = vector_of(json.at("log_size_width"));
      made.lowest_ = vector_of(json.at("log_size_from"));
      made.highest_ = vector_of(json.at("log_size_to"));
      made.depth_centre_ = json.at("depth_centre").get<double>();
      made.deepest_ratio_ = json.at("deepest_ratio").get<double>();
      made.powers_ = matrix_of(json.at("powers")).transpose().cast<int>();
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
    made.rest_.resize(2, n);
    made.rest_.row(0) = made.angle_rad_.array().sin().matrix().transpose();
    made.rest_.row(1) = made.angle_rad_.array().cos().matrix().transpose();
    return made;
  }();
  return solid;
}

LogSizes IndentedSolid::within_range(const LogSizes& sizes) const {
  return sizes.cwiseMax(lowest_).cwiseMin(highest_);
}

Eigen::VectorXd IndentedSolid::basis(const LogSizes& sizes, double depth_ratio) const {
  const LogSizes u = (within_range(sizes) - centre_).cwiseQuotient(width_);
  const double depth = std::clamp(depth_ratio, 0.0, deepest_ratio_) / depth_centre_ - 1.0;
  const double angle = std::acos(std::clamp(depth, -1.0, 1.0));
  Eigen::VectorXd values(powers_.cols());
  for (Eigen::Index k = 0; k < powers_.cols(); ++k) {
    values[k] = std::pow(u[0], powers_(0, k)) * std::pow(u[1], powers_(1, k)) * std::pow(u[2], powers_(2, k)) *
                std::cos(powers_(3, k) * angle);  // Chebyshev's polynomial
  }
  return values;
}

Eigen::Matrix2Xd IndentedSolid::section(const LogSizes& sizes, double depth_ratio) const {
  const double depth = std::clamp(depth_ratio, 0.0, deepest_ratio_);
  const Eigen::VectorXd moved = depth * (section_ * basis(sizes, depth));
  return rest_ + moved.reshaped(2, rest_.cols());
}

double IndentedSolid::log_force(const LogSizes& sizes, double depth_ratio) const {
  return force_.dot(basis(sizes, depth_ratio)) + kThicknessPower * within_range(sizes)[0] +
         std::log(std::min(depth_ratio, deepest_ratio_));
}

double IndentedSolid::log_pressure(const LogSizes& sizes, double depth_ratio) const {
  return log_force(sizes, depth_ratio) + pressure_.dot(basis(sizes, depth_ratio));
}

}  // namespace pellucida
