#pragma once
#include <vector>

#include "NodeOrdering.h"

namespace pellucida {

/// A run of nodes, consecutive in the order of elimination, that are eliminated together.
struct Front {
  int first = 0;                 ///< place of its first node in the order
  int count = 0;                 ///< nodes eliminated here
  std::vector<int> rows;         ///< places of the later nodes its columns reach, ascending
  std::vector<int> parent_rows;  ///< of each of `rows`: its row in the parent's front (eliminated nodes first)
  int parent = -1;               ///< -1: none
  int depth = 0;                 ///< steps up to its root
  std::vector<int> children;
};

/// What a factorisation does, node by node: worked out from the pattern alone.
struct FrontTree {
  std::vector<int> order;     ///< node at each place
  std::vector<int> place;     ///< place of each node
  std::vector<Front> fronts;  ///< children before parents, each subtree together
  double operation_count = 0.0;
};

/// The fronts of eliminating `graph` in about the order given (put into postorder, which changes no fill). Small fronts
/// are merged with their parents where that costs few zeros.
FrontTree make_front_tree(const NodeGraph& graph, const std::vector<int>& order);

}  // namespace pellucida
