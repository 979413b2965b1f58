#include "pellucida/core/PersonHint.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

using Kind = PersonHint::Kind;

TEST(PersonHint, AnEventHoldsItWhole) {
  for (const Kind kind : {Kind::kCell, Kind::kNeedleTip, Kind::kNoCell}) {
    const PersonHint hint{.kind = kind, .x_um = 101.25, .y_um = -88.003, .since_s = 4.5};
    EXPECT_EQ(hint_of({4.5, event_kind::kHint, describe(hint) + ": followed"}), hint) << describe(hint);
  }
  const PersonHint taken{.kind = Kind::kTakeBack, .since_s = 1.0};
  EXPECT_EQ(hint_of({1.0, event_kind::kHint, describe(taken)}), taken);
}

TEST(PersonHint, PlacesAreKeptToAThousandthOfAMicrometre) {
  const PersonHint hint = as_stored({.kind = Kind::kCell, .x_um = 10.00049, .y_um = 1.0 / 3.0, .since_s = 2.0});
  EXPECT_EQ(hint_of({2.0, event_kind::kHint, describe(hint)}), hint);
  EXPECT_NEAR(hint.x_um, 10.0, 1e-9);
  EXPECT_NEAR(hint.y_um, 0.333, 1e-9);
}

TEST(PersonHint, TheCommandLineGivesOneInUm) {
  const HintOption& cell = hint_options()[0];
  EXPECT_EQ(parse_hint(cell, "120.5,88"), (PersonHint{.kind = Kind::kCell, .x_um = 120.5, .y_um = 88.0}));
  EXPECT_EQ(parse_hint(cell, "120.5,88@3.2").since_s, 3.2);
  for (const char* text : {"", "1", "1;2", "1,2,3", "1,nan", "1,2@", "1,2@x", "1,2@3x"}) {
    EXPECT_THROW(parse_hint(cell, text), UsageError) << text;
  }
  std::vector<PersonHint> hints;
  const std::vector<std::string> texts{"1,1@5", "2,2", "3,3@5", "4,4@1"};
  add_hints(hints, cell, texts);
  ASSERT_EQ(hints.size(), 4U);
  EXPECT_EQ(hints[0].x_um, 2.0);
  EXPECT_EQ(hints[1].x_um, 4.0);
  EXPECT_EQ(hints[2].x_um, 1.0);
  EXPECT_EQ(hints[3].x_um, 3.0);
}

TEST(PersonHint, OtherEventsAndBrokenWordsAreNone) {
  EXPECT_FALSE(hint_of({0.0, event_kind::kNote, "cell at 1 2 um"}));
  for (const char* words : {"", "cell", "cell at", "cell at 1 um", "cell at nan 2 um", "needle at 1 2 um"}) {
    EXPECT_FALSE(hint_of({0.0, event_kind::kHint, words})) << words;
  }
}

}  // namespace
}  // namespace pellucida
