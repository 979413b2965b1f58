#include "presenters/HintDraft.h"

#include <gtest/gtest.h>

#include "pellucida/core/TemporaryFolder.h"

namespace pellucida {
namespace {

using Kind = PersonHint::Kind;

TEST(HintDraft, ListsHintsInTheOrderOfTimeAndTakesBackTheLastGiven) {
  HintDraft draft;
  EXPECT_FALSE(draft.take_back());
  draft.add({.kind = Kind::kCell, .x_um = 10.0, .y_um = 20.0, .since_s = 5.0});
  draft.add({.kind = Kind::kNeedleTip, .x_um = 30.0, .y_um = 20.0, .since_s = 3.2});
  EXPECT_EQ(draft.text(), "2 hints: tip at 3.20 s, cell at 5.00 s");
  ASSERT_EQ(draft.hints().size(), 2U);
  EXPECT_EQ(draft.hints()[0].kind, Kind::kNeedleTip);
  ASSERT_EQ(draft.marks_at(3.2).size(), 1U);
  EXPECT_EQ(draft.marks_at(3.2)[0].text, "tip");
  EXPECT_TRUE(draft.marks_at(4.0).empty());
  EXPECT_TRUE(draft.take_back());
  EXPECT_EQ(draft.text(), "1 hint: cell at 5.00 s");
}

TEST(HintDraft, OfTwoAboutOneThingInOneFrameTheLaterCounts) {
  HintDraft draft;
  draft.add({.kind = Kind::kCell, .x_um = 10.0, .y_um = 20.0, .since_s = 5.0});
  draft.add({.kind = Kind::kCell, .x_um = 12.0, .y_um = 20.0, .since_s = 5.0});
  ASSERT_EQ(draft.hints().size(), 1U);
  EXPECT_EQ(draft.hints()[0].x_um, 12.0);
}

TEST(HintDraft, NoSessionIsWrittenOver) {
  const TemporaryFolder folder;
  const auto session = folder / "S";
  EXPECT_EQ(corrected_folder(session).filename(), "S-corrected");
  std::filesystem::create_directory(folder / "S-corrected");
  EXPECT_EQ(corrected_folder(session).filename(), "S-corrected-2");
  EXPECT_EQ(corrected_folder(session / "").filename(), "S-corrected-2");
}

}  // namespace
}  // namespace pellucida
