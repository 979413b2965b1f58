#include "pellucida/visualization/Palette.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

TEST(Palette, ContrastOfBlackAndWhiteIs21) {
  EXPECT_NEAR(contrast_ratio(Color::from_hex(0x000000), Color::from_hex(0xFFFFFF)), 21.0, 1e-9);
  EXPECT_NEAR(contrast_ratio(palette::kText, palette::kText), 1.0, 1e-9);
}

TEST(Palette, WritingReadsOnEverySurface) {
  for (const Color& ground : {palette::kWindow, palette::kPanel, palette::kRaised}) {
    EXPECT_GE(contrast_ratio(palette::kText, ground), 7.0);
    EXPECT_GE(contrast_ratio(palette::kTextDim, ground), 4.5);
    EXPECT_GE(contrast_ratio(palette::kAccent, ground), 4.5);
    EXPECT_GE(contrast_ratio(palette::kRecord, ground), 4.5);
    EXPECT_GE(contrast_ratio(palette::kWarning, ground), 4.5);
  }
}

TEST(Palette, EachThemeReadsOnItsSurfaces) {
  for (const ThemeColors* theme : {&dark_theme(), &light_theme()}) {
    for (const Color& ground : {theme->window, theme->panel, theme->raised}) {
      EXPECT_GE(contrast_ratio(theme->text, ground), 7.0);
      for (const Color& writing :
           {theme->text_dim, theme->faint, theme->accent, theme->record, theme->warning, theme->good, theme->plan}) {
        EXPECT_GE(contrast_ratio(writing, ground), 4.5) << writing.css() << " on " << ground.css();
      }
    }
    EXPECT_GE(contrast_ratio(theme->curve, theme->panel), 3.0);
    EXPECT_GE(contrast_ratio(theme->curve_before, theme->panel), 3.0);
  }
}

TEST(Palette, PillsCarryTheirWriting) {
  for (const CellState state :
       {CellState::kNoCell, CellState::kFree, CellState::kContact, CellState::kPunctured, CellState::kLost}) {
    for (const ThemeColors* theme : {&dark_theme(), &light_theme()}) {
      EXPECT_GE(contrast_ratio(state_color(state, *theme), theme->window), 4.5) << to_string(state);
      // Named in charts too.
      EXPECT_GE(contrast_ratio(state_color(state, *theme), theme->panel), 4.5) << to_string(state);
    }
  }
}

TEST(Palette, LinesReadOnTheirUnderlay) {
  for (const Color& line : {palette::kOuter, palette::kInner, palette::kOolemma, palette::kNeedle, palette::kHolder,
                            palette::kModel, palette::kPlan, palette::kCurve}) {
    EXPECT_GE(contrast_ratio(line, palette::kPanel), 3.0) << line.css();
  }
}

TEST(Palette, CssIsSixDigits) {
  EXPECT_EQ(Color::from_hex(0x0F1318).css(), "#0f1318");
}

}  // namespace
}  // namespace pellucida
