#include "ForceTransfer.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <vector>

namespace pellucida {
namespace {

/// A direction as a mix of three model nodes.
struct Place {
  std::array<int, 3> nodes{};
  Eigen::Vector3d shares = Eigen::Vector3d::Zero();
};

/// The model's triangles, searched round the node nearest to a direction, then a ring farther.
class Locator {
 public:
  Locator(const Eigen::Matrix3Xd& directions, const Eigen::Matrix3Xi& triangles)
      : directions_(directions), triangles_(triangles) {
    triangles_of_.resize(static_cast<std::size_t>(directions.cols()));
    for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
      for (int corner = 0; corner < 3; ++corner) {
        triangles_of_[static_cast<std::size_t>(triangles(corner, t))].push_back(static_cast<int>(t));
      }
    }
  }

  int nearest(const Eigen::Vector3d& direction) const {
    Eigen::Index node = 0;
    (directions_.transpose() * direction).maxCoeff(&node);
    return static_cast<int>(node);
  }

  /// From `node` uphill to the nearest, as a rule.
  int climb(int node, const Eigen::Vector3d& direction) const {
    double height = directions_.col(node).dot(direction);
    for (bool higher = true; higher;) {
      higher = false;
      for (const int t : triangles_of_[static_cast<std::size_t>(node)]) {
        for (int corner = 0; corner < 3; ++corner) {
          const int other = triangles_(corner, t);
          if (directions_.col(other).dot(direction) <= height) continue;
          height = directions_.col(other).dot(direction);
          node = other;
          higher = true;
        }
        if (higher) break;
      }
    }
    return node;
  }

  /// `near_node`: a node to start from, the nearer the quicker; set to the nearest.
  Place find(const Eigen::Vector3d& direction, int& near_node) const {
    // The triangle that has the direction inside: nearly always one at the nearest node, else one a ring farther, else
    // the one that has it least outside.
    near_node = climb(near_node, direction);
    Place best;
    double best_inside = -1e9;
    const auto has_inside = [&](int t) {
      Eigen::Matrix3d corners;
      for (int k = 0; k < 3; ++k) corners.col(k) = directions_.col(triangles_(k, t));
      Eigen::Vector3d shares = corners.inverse() * direction;
      shares /= shares.sum();
      if (shares.minCoeff() > best_inside) {
        best_inside = shares.minCoeff();
        best = {{triangles_(0, t), triangles_(1, t), triangles_(2, t)}, shares};
      }
      return best_inside >= 0.0;
    };
    const auto any_of = [&](int node) {
      const auto& triangles = triangles_of_[static_cast<std::size_t>(node)];
      return std::any_of(triangles.begin(), triangles.end(), has_inside);
    };
    const auto is_found_round = [&](int node) {
      if (any_of(node)) return true;
      const auto& round = triangles_of_[static_cast<std::size_t>(node)];
      return std::any_of(round.begin(), round.end(), [&](int t) {
        return any_of(triangles_(0, t)) || any_of(triangles_(1, t)) || any_of(triangles_(2, t));
      });
    };
    if (!is_found_round(near_node)) {
      near_node = nearest(direction);
      is_found_round(near_node);
    }
    // Rounding may leave it a hair outside.
    best.shares = best.shares.cwiseMax(0.0);
    best.shares /= best.shares.sum();
    return best;
  }

 private:
  const Eigen::Matrix3Xd& directions_;
  const Eigen::Matrix3Xi& triangles_;
  std::vector<std::vector<int>> triangles_of_;
};

}  // namespace

ForceTransfer::ForceTransfer(const Eigen::Matrix3Xd& model_directions, const Eigen::Matrix3Xi& triangles,
                             const Eigen::Matrix3Xd& surface_directions, const Eigen::VectorXd& surface_areas)
    : extensive_(surface_directions.cols(), model_directions.cols()),
      intensive_(surface_directions.cols(), model_directions.cols()) {
  const Locator locator(model_directions, triangles);
  int near_node = 0;
  std::vector<Eigen::Triplet<double>> interpolation, lumps;
  Eigen::VectorXd received = Eigen::VectorXd::Zero(model_directions.cols());
  for (Eigen::Index s = 0; s < surface_directions.cols(); ++s) {
    const Place place = locator.find(surface_directions.col(s), near_node);
    for (int k = 0; k < 3; ++k) {
      const double share = place.shares[k];
      interpolation.emplace_back(static_cast<int>(s), place.nodes[static_cast<std::size_t>(k)], share);
      const double lump = share * surface_areas[s];
      if (lump <= 0.0) continue;
      lumps.emplace_back(static_cast<int>(s), place.nodes[static_cast<std::size_t>(k)], lump);
      received[place.nodes[static_cast<std::size_t>(k)]] += lump;
    }
  }
  intensive_.setFromTriplets(interpolation.begin(), interpolation.end());

  // Every model node gives all it has.
  std::vector<Eigen::Triplet<double>> shares;
  for (const auto& lump : lumps) shares.emplace_back(lump.row(), lump.col(), lump.value() / received[lump.col()]);
  for (Eigen::Index n = 0; n < model_directions.cols(); ++n) {
    if (received[n] > 0.0) continue;
    Eigen::Index nearest = -1;
    double closest = -2.0;
    for (Eigen::Index s = 0; s < surface_directions.cols(); ++s) {
      const double cosine = surface_directions.col(s).dot(model_directions.col(n));
      if (surface_areas[s] > 0.0 && cosine > closest) {
        closest = cosine;
        nearest = s;
      }
    }
    if (nearest >= 0) shares.emplace_back(static_cast<int>(nearest), static_cast<int>(n), 1.0);
  }
  extensive_.setFromTriplets(shares.begin(), shares.end());
}

}  // namespace pellucida
