#pragma once
#include <vector>

#include "pellucida/membrane/TriangleMesh.h"

namespace pellucida {

/// A numbering in which neighbours mostly differ by the same amount as their neighbours do: ring by ring round the most
/// irregular node (the pole of a revolved surface, a corner of a geodesic sphere), each ring by its angle. Returns the
/// new number of each node.
std::vector<int> ring_order(const TriangleMesh& mesh);

}  // namespace pellucida
