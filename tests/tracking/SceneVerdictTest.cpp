// Which of lines and networks follows a cell that both see.
#include "SceneVerdict.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

LinesVerdict both_see_it() {
  LinesVerdict verdict;
  verdict.is_same_cell = verdict.is_same_outline = verdict.is_same_inner = true;
  verdict.is_fine = verdict.is_clear = verdict.is_sure = verdict.is_same_needle = true;
  return verdict;
}

// A soft edge goes along with the oolemma and has no dimple: in validation film 55046 a needle pushed a thick zona by
// 11 um, and no contact was reported.
TEST(LinesVerdict, LinesFollowACellThatTheyMeasureMoreFinelyUnlessItsZonaIsASoftEdge) {
  LinesVerdict verdict = both_see_it();
  EXPECT_TRUE(verdict.is_by_lines());
  verdict.is_soft = true;
  EXPECT_FALSE(verdict.is_by_lines());
  EXPECT_TRUE(verdict.is_confirmed()) << "where networks read it too poorly, lines follow it all the same";
}

TEST(LinesVerdict, WhatNetworksHaveElsewhereOrMoreFinelyIsNotForLines) {
  for (bool LinesVerdict::*part : {&LinesVerdict::is_same_cell, &LinesVerdict::is_same_outline,
                                   &LinesVerdict::is_same_inner, &LinesVerdict::is_fine, &LinesVerdict::is_clear}) {
    LinesVerdict verdict = both_see_it();
    verdict.*part = false;
    EXPECT_FALSE(verdict.is_by_lines());
  }
}

}  // namespace
}  // namespace pellucida
