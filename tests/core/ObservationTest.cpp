#include "pellucida/core/Observation.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

TEST(NeedleEvidence, IsNamedInOrder) {
  EXPECT_EQ(to_string(kNoNeedleEvidence), "none");
  EXPECT_EQ(to_string(kTipEnd | kShaftEdges), "shaft+tip");
  EXPECT_EQ(to_string(kShaftEdges | kKnownCone | kCommandedMotion | kDimple), "shaft+cone+commanded+dimple");
}

}  // namespace
}  // namespace pellucida
