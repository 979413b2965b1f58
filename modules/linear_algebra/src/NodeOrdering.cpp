#include "NodeOrdering.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>

namespace pellucida {
namespace {

/// Parts of no more nodes aren't cut any further.
constexpr std::size_t kSmallPart = 48;
/// Each side of a cut keeps at least this share of the nodes, where the graph allows it.
constexpr double kSmallestShare = 0.3;

std::vector<int> minimum_degree(const NodeGraph& graph, const std::vector<int>& nodes, std::vector<int>& place) {
  const int n = static_cast<int>(nodes.size());
  for (int k = 0; k < n; ++k) place[static_cast<std::size_t>(nodes[static_cast<std::size_t>(k)])] = k;
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 0; k < n; ++k) {
    entries.emplace_back(k, k, 1.0);
    for (const int neighbour : graph[static_cast<std::size_t>(nodes[static_cast<std::size_t>(k)])]) {
      if (place[static_cast<std::size_t>(neighbour)] >= 0) {
        entries.emplace_back(place[static_cast<std::size_t>(neighbour)], k, 1.0);
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::AMDOrdering<int>::PermutationType permutation;
  Eigen::AMDOrdering<int>()(matrix, permutation);

  std::vector<int> order;
  for (int k = 0; k < n; ++k) order.push_back(nodes[static_cast<std::size_t>(permutation.indices()[k])]);
  for (const int node : nodes) place[static_cast<std::size_t>(node)] = -1;
  return order;
}

/// Cuts parts of one graph. `part_` states which nodes belong to the present part.
class Dissection {
 public:
  explicit Dissection(const NodeGraph& graph)
      : graph_(graph), part_(graph.size(), 0), level_(graph.size(), -1), place_(graph.size(), -1) {}

  void order(const std::vector<int>& nodes, std::vector<int>& result) {
    if (nodes.size() <= kSmallPart) {
      append(result, minimum_degree(graph_, nodes, place_));
      return;
    }

    // Breadth-first from one end; twice, so that it begins at a far end.
    const int part = ++last_part_;
    for (const int node : nodes) part_[static_cast<std::size_t>(node)] = part;
    std::vector<int> visited = breadth_first(nodes.front(), part);
    visited = breadth_first(visited.back(), part);
    if (visited.size() < nodes.size()) {
      // Not connected: piece by piece.
      std::vector<int> others;
      for (const int node : nodes) {
        if (level_[static_cast<std::size_t>(node)] < 0) others.push_back(node);
      }
      clear_levels(visited);
      order(visited, result);
      order(others, result);
      return;
    }

    // The level that cuts best: few nodes, both sides large. Its nodes that touch nothing beyond join the near side.
    const int cut = best_level(visited);
    std::vector<int> near, separator, far;
    for (const int node : visited) {
      const int level = level_[static_cast<std::size_t>(node)];
      if (level == cut && touches_level(node, cut + 1, part)) {
        separator.push_back(node);
      } else {
        (level <= cut ? near : far).push_back(node);
      }
    }
    clear_levels(visited);
    if (near.empty() || far.empty()) {
      append(result, minimum_degree(graph_, nodes, place_));
      return;
    }
    order(near, result);
    order(far, result);
    append(result, separator);
  }

 private:
  static void append(std::vector<int>& to, const std::vector<int>& from) {
    to.insert(to.end(), from.begin(), from.end());
  }

  std::vector<int> breadth_first(int start, int part) {
    for (std::size_t node = 0; node < graph_.size(); ++node) {
      if (part_[node] == part) level_[node] = -1;
    }
    std::vector<int> visited{start};
    level_[static_cast<std::size_t>(start)] = 0;
    for (std::size_t k = 0; k < visited.size(); ++k) {
      for (const int neighbour : graph_[static_cast<std::size_t>(visited[k])]) {
        const auto n = static_cast<std::size_t>(neighbour);
        if (part_[n] != part || level_[n] >= 0) continue;
        level_[n] = level_[static_cast<std::size_t>(visited[k])] + 1;
        visited.push_back(neighbour);
      }
    }
    return visited;
  }

  int best_level(const std::vector<int>& visited) const {
    std::vector<double> size(static_cast<std::size_t>(level_[static_cast<std::size_t>(visited.back())]) + 1, 0.0);
    for (const int node : visited) size[static_cast<std::size_t>(level_[static_cast<std::size_t>(node)])] += 1.0;
    const auto total = static_cast<double>(visited.size());
    double before = 0.0, best_cost = 0.0;
    int best = -1;
    for (std::size_t level = 0; level < size.size(); ++level) {
      const double smaller = std::min(before, total - before - size[level]);
      before += size[level];
      if (smaller <= 0.0) continue;
      const double cost = size[level] * (smaller < kSmallestShare * total ? kSmallestShare * total / smaller : 1.0);
      if (best < 0 || cost < best_cost) {
        best = static_cast<int>(level);
        best_cost = cost;
      }
    }
    return best;
  }

  bool touches_level(int node, int level, int part) const {
    const auto& neighbours = graph_[static_cast<std::size_t>(node)];
    return std::any_of(neighbours.begin(), neighbours.end(), [&](int neighbour) {
      return part_[static_cast<std::size_t>(neighbour)] == part && level_[static_cast<std::size_t>(neighbour)] == level;
    });
  }

  void clear_levels(const std::vector<int>& nodes) {
    for (const int node : nodes) level_[static_cast<std::size_t>(node)] = -1;
  }

  const NodeGraph& graph_;
  std::vector<int> part_;
  std::vector<int> level_;
  std::vector<int> place_;
  int last_part_ = 0;
};

std::vector<int> all_nodes(const NodeGraph& graph) {
  std::vector<int> nodes(graph.size());
  for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k] = static_cast<int>(k);
  return nodes;
}

}  // namespace

std::vector<int> dissection_order(const NodeGraph& graph) {
  std::vector<int> result;
  result.reserve(graph.size());
  Dissection(graph).order(all_nodes(graph), result);
  return result;
}

std::vector<int> minimum_degree_order(const NodeGraph& graph) {
  std::vector<int> place(graph.size(), -1);
  return minimum_degree(graph, all_nodes(graph), place);
}

}  // namespace pellucida
