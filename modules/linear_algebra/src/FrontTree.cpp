#include "FrontTree.h"

#include <algorithm>

namespace pellucida {
namespace {

/// A front joins its parent while both together have no more nodes than this, or the zeros are a smaller share.
constexpr int kSmallFront = 6;
constexpr double kZeroShare = 0.12;

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

std::vector<int> inverse(const std::vector<int>& order) {
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[at(order[k])] = static_cast<int>(k);
  return place;
}

/// Parent of each place in the elimination tree (Liu), -1 for roots.
std::vector<int> elimination_tree(const NodeGraph& graph, const std::vector<int>& order,
                                  const std::vector<int>& place) {
  std::vector<int> parent(order.size(), -1), ancestor(order.size(), -1);
  for (int j = 0; j < static_cast<int>(order.size()); ++j) {
    for (const int neighbour : graph[at(order[at(j)])]) {
      int k = place[at(neighbour)];
      // Climb to the root of k's subtree, shortening the way for the next.
      while (k < j && k >= 0) {
        const int next = ancestor[at(k)];
        ancestor[at(k)] = j;
        if (next < 0) {
          parent[at(k)] = j;
          break;
        }
        k = next;
      }
    }
  }
  return parent;
}

/// The order in which every subtree's places follow one another, its root last.
std::vector<int> postorder(const std::vector<int>& parent) {
  const int n = static_cast<int>(parent.size());
  std::vector<std::vector<int>> children(parent.size());
  std::vector<int> roots, sequence;
  for (int k = 0; k < n; ++k) (parent[at(k)] < 0 ? roots : children[at(parent[at(k)])]).push_back(k);
  for (const int root : roots) {
    std::vector<std::pair<int, std::size_t>> path{{root, 0}};
    while (!path.empty()) {
      auto& [node, next] = path.back();
      if (next < children[at(node)].size()) {
        const int child = children[at(node)][next++];
        path.emplace_back(child, 0);
      } else {
        sequence.push_back(node);
        path.pop_back();
      }
    }
  }
  return sequence;
}

/// The later places that each column reaches once all before it are eliminated.
std::vector<std::vector<int>> column_patterns(const NodeGraph& graph, const FrontTree& tree,
                                              const std::vector<int>& parent) {
  const int n = static_cast<int>(tree.order.size());
  std::vector<std::vector<int>> pattern(tree.order.size());
  for (int j = 0; j < n; ++j) {
    auto& rows = pattern[at(j)];
    for (const int neighbour : graph[at(tree.order[at(j)])]) {
      if (tree.place[at(neighbour)] > j) rows.push_back(tree.place[at(neighbour)]);
    }
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  }
  // Each column hands what it reaches to its parent, which comes later.
  std::vector<int> merged;
  for (int j = 0; j < n; ++j) {
    if (parent[at(j)] < 0) continue;
    auto& rows = pattern[at(parent[at(j)])];
    merged.clear();
    std::set_union(rows.begin(), rows.end(), pattern[at(j)].begin() + 1, pattern[at(j)].end(),
                   std::back_inserter(merged));
    rows.swap(merged);
  }
  return pattern;
}

/// Blocks in the columns of a front, the lower half.
double block_count(double count, double rows) {
  return count * (0.5 * (count + 1.0) + rows);
}

/// `filled`: blocks of both that aren't zero.
bool worth_merging(const Front& child, const Front& parent, double filled) {
  const int count = child.count + parent.count;
  const double all = block_count(count, static_cast<double>(parent.rows.size()));
  return count <= kSmallFront || all - filled <= kZeroShare * all;
}

}  // namespace

FrontTree make_front_tree(const NodeGraph& graph, const std::vector<int>& order) {
  // Postorder, then the tree of single columns in it.
  FrontTree tree;
  {
    const std::vector<int> sequence = postorder(elimination_tree(graph, order, inverse(order)));
    for (const int k : sequence) tree.order.push_back(order[at(k)]);
    tree.place = inverse(tree.order);
  }
  const std::vector<int> parent = elimination_tree(graph, tree.order, tree.place);
  std::vector<std::vector<int>> pattern = column_patterns(graph, tree, parent);

  // Columns one by one; a front on top of the stack, which ends just before, joins the new one if that is its parent
  // and it is cheap.
  std::vector<Front>& fronts = tree.fronts;
  std::vector<double> filled;
  for (int j = 0; j < static_cast<int>(tree.order.size()); ++j) {
    Front front;
    front.first = j;
    front.count = 1;
    front.rows = std::move(pattern[at(j)]);
    double front_filled = block_count(1.0, static_cast<double>(front.rows.size()));
    while (!fronts.empty() && !fronts.back().rows.empty() && fronts.back().rows.front() < front.first + front.count &&
           worth_merging(fronts.back(), front, filled.back() + front_filled)) {
      front_filled += filled.back();
      filled.pop_back();
      front.first = fronts.back().first;
      front.count += fronts.back().count;
      fronts.pop_back();
    }
    fronts.push_back(std::move(front));
    filled.push_back(front_filled);
  }

  // Who is whose parent, and where each row lies there.
  std::vector<int> front_of(tree.order.size());
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    for (int k = 0; k < fronts[f].count; ++k) front_of[at(fronts[f].first + k)] = static_cast<int>(f);
  }
  for (std::size_t f = fronts.size(); f-- > 0;) {
    Front& front = fronts[f];
    const double p = 3.0 * front.count, r = 3.0 * static_cast<double>(front.rows.size());
    tree.operation_count += p * (p * p / 6.0 + 0.5 * p * r + 0.5 * r * r);
    if (front.rows.empty()) continue;
    front.parent = front_of[at(front.rows.front())];
    const Front& above = fronts[at(front.parent)];
    front.depth = above.depth + 1;
    for (const int row : front.rows) {
      const int inside = row - above.first;
      const auto found = std::lower_bound(above.rows.begin(), above.rows.end(), row) - above.rows.begin();
      front.parent_rows.push_back(inside < above.count ? inside : above.count + static_cast<int>(found));
    }
  }
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    if (fronts[f].parent >= 0) fronts[at(fronts[f].parent)].children.push_back(static_cast<int>(f));
  }
  return tree;
}

}  // namespace pellucida
