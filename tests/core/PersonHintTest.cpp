#include "pellucida/core/PersonHint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

using Kind = PersonHint::Kind;

TEST(PersonHint, AnEventHoldsItWhole) {
  for (const Kind kind : {Kind::kCell, Kind::kNeedleTip, Kind::kNoCell, Kind::kHolder}) {
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

TEST(PersonHint, OfAnOutlineAsManyCornersAreKeptAsItNeeds) {
  std::vector<PersonHint::Place_um> drawn;
  for (int k = 0; k < 80; ++k) drawn.push_back({40.0 * std::cos(0.0785 * k), 40.0 * std::sin(0.0785 * k)});
  auto hint = outline_hint(drawn);
  ASSERT_TRUE(hint);
  ASSERT_EQ(hint->outline_um.size(), kMostOutlinePlaces);
  // All round: none of its sides is longer than a thirty-second and a bit.
  for (std::size_t k = 0; k < kMostOutlinePlaces; ++k) {
    const auto &from = hint->outline_um[k], &to = hint->outline_um[(k + 1) % kMostOutlinePlaces];
    EXPECT_LT(std::hypot(to[0] - from[0], to[1] - from[1]), 10.0) << k;
  }
  hint->since_s = 4.5;
  const std::string detail = describe(*hint) + ": found";
  EXPECT_EQ(hint_of({4.5, event_kind::kHint, detail}), hint) << detail;
  EXPECT_EQ(without_corners(detail), "cell outlined by 32 places: found");
  EXPECT_EQ(without_corners("cell at 1.000 2.000 um: found"), "cell at 1.000 2.000 um: found");
  drawn.resize(5);
  EXPECT_EQ(outline_hint(drawn)->outline_um.size(), 5U);
}

TEST(PersonHint, AClickIsNoOutline) {
  EXPECT_FALSE(outline_hint(std::vector<PersonHint::Place_um>{{0.0, 0.0}, {10.0, 0.0}}));
  EXPECT_FALSE(outline_hint(std::vector<PersonHint::Place_um>{{0.0, 0.0}, {10.0, NAN}, {5.0, 5.0}}));
}

TEST(PersonHint, TheCommandLineGivesAnOutlineByItsCorners) {
  const HintOption& outline = hint_options().back();
  ASSERT_EQ(outline.kind, Kind::kCellOutline);
  const PersonHint hint = parse_hint(outline, "80,60/140,60/110,120@2.5");
  EXPECT_EQ(hint.outline_um, (std::vector<PersonHint::Place_um>{{80.0, 60.0}, {140.0, 60.0}, {110.0, 120.0}}));
  EXPECT_EQ(hint.since_s, 2.5);
  EXPECT_NEAR(hint.x_um, 110.0, 1e-9);
  for (const char* text : {"", "80,60", "80,60/140,60", "80,60/140,60/110", "80,60/140,60/nan,1",
                           "80,60/140,60/110,120@", "80,60;140,60;110,120"}) {
    EXPECT_THROW(parse_hint(outline, text), UsageError) << text;
  }
}

TEST(PersonHint, OtherEventsAndBrokenWordsAreNone) {
  EXPECT_FALSE(hint_of({0.0, event_kind::kNote, "cell at 1 2 um"}));
  for (const char* words : {"", "cell", "cell at", "cell at 1 um", "cell at nan 2 um", "needle at 1 2 um",
                            "cell outlined by 3 places: 1 2 3 4 5 um", "cell outlined by 2 places: 1 2 3 4 um",
                            "cell outlined by 3 places: 1 2 3 4 5 nan um", "cell outlined by 99 places: 1 2 um"}) {
    EXPECT_FALSE(hint_of({0.0, event_kind::kHint, words})) << words;
  }
}

}  // namespace
}  // namespace pellucida
