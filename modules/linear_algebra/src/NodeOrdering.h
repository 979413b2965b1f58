#pragma once
#include <vector>

namespace pellucida {

/// Neighbours of each node: symmetric, without the node itself, sorted.
using NodeGraph = std::vector<std::vector<int>>;

/// An order of elimination that keeps a factorisation's fill small: nested dissection by breadth-first levels, small
/// parts by approximate minimum degree. On a closed surface a middle level is a ring, nearly the smallest separator
/// there is.
std::vector<int> dissection_order(const NodeGraph& graph);

/// Approximate minimum degree on the whole graph.
std::vector<int> minimum_degree_order(const NodeGraph& graph);

}  // namespace pellucida
