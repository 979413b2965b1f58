#include "pellucida/reconstruction/ClosedMesh.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

// A box of 2 x 3 x 4 um far from the origin, made of quads.
ClosedMesh box() {
  ClosedMesh mesh;
  mesh.nodes_um.resize(3, 8);
  for (int i = 0; i < 8; ++i) {
    mesh.nodes_um.col(i) << 1e4 + ((i & 1) ? 2.0 : 0.0), ((i & 2) ? 3.0 : 0.0), ((i & 4) ? 4.0 : 0.0);
  }
  mesh.cells = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return mesh;
}

TEST(ClosedMesh, VolumeAndAreaOfABox) {
  EXPECT_NEAR(volume_um3(box()), 24.0, 1e-9);
  EXPECT_NEAR(area_um2(box()), 52.0, 1e-9);
  EXPECT_TRUE(is_closed_and_oriented(box()));
}

TEST(ClosedMesh, AHoleOrAFlippedFaceIsSeen) {
  ClosedMesh open = box();
  open.cells.pop_back();
  EXPECT_FALSE(is_closed_and_oriented(open));
  ClosedMesh flipped = box();
  std::swap(flipped.cells[0][1], flipped.cells[0][3]);
  EXPECT_FALSE(is_closed_and_oriented(flipped));
  EXPECT_FALSE(is_closed_and_oriented(ClosedMesh{}));
}

}  // namespace
}  // namespace pellucida
