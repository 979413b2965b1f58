#include "pellucida/visualization/Palette.h"

namespace pellucida {
namespace {

const ThemeColors* the_theme = &dark_theme();

}  // namespace

const ThemeColors& current_theme() noexcept {
  return *the_theme;
}

void set_current_theme(const ThemeColors& theme) noexcept {
  the_theme = &theme;
}

const ThemeColors& dark_theme() noexcept {
  static constexpr ThemeColors kDark{.window = palette::kWindow,
                                     .panel = palette::kPanel,
                                     .raised = palette::kRaised,
                                     .border = palette::kBorder,
                                     .view_bottom = palette::kViewBottom,
                                     .view_top = palette::kViewTop,
                                     .text = palette::kText,
                                     .text_dim = palette::kTextDim,
                                     .faint = Color::from_hex(0x84919E),
                                     .accent = palette::kAccent,
                                     .record = palette::kRecord,
                                     .warning = palette::kWarning,
                                     .good = palette::kHolder,
                                     .plan = palette::kPlan,
                                     .grid = palette::kGrid,
                                     .curve = palette::kCurve,
                                     .curve_before = Color::from_hex(0x8494A5),
                                     .curve_other = palette::kCurveOther,
                                     .cell = Color::from_hex(0x3A5568),
                                     .glass = palette::kGlass,
                                     .outer_solid = palette::kOuterSolid,
                                     .inner_solid = palette::kInnerSolid,
                                     .contact_force = palette::kContactForce,
                                     .node_mark = palette::kModel,
                                     .model = palette::kModel,
                                     .needle = palette::kNeedle,
                                     .droplet = Color::from_hex(0x2FC4B2),
                                     .unsure = Color::from_hex(0x7C8794)};
  return kDark;
}

const ThemeColors& light_theme() noexcept {
  static constexpr ThemeColors kLight{.window = Color::from_hex(0xE9EDF1),
                                      .panel = Color::from_hex(0xF7F9FB),
                                      .raised = Color::from_hex(0xFFFFFF),
                                      .border = Color::from_hex(0xB9C3CD),
                                      .view_bottom = Color::from_hex(0xFFFFFF),
                                      .view_top = Color::from_hex(0xE6EDF4),
                                      .text = Color::from_hex(0x10161D),
                                      .text_dim = Color::from_hex(0x46525E),
                                      .faint = Color::from_hex(0x5C6874),
                                      .accent = Color::from_hex(0x0B5FA8),
                                      .record = Color::from_hex(0xB3261E),
                                      .warning = Color::from_hex(0x7A4A00),
                                      .good = Color::from_hex(0x1E6B2E),
                                      .plan = Color::from_hex(0x3D4FB8),
                                      .grid = Color::from_hex(0xDCE3EA),
                                      .curve = Color::from_hex(0x0B5FA8),
                                      .curve_before = Color::from_hex(0x6F7C89),
                                      .curve_other = Color::from_hex(0xB85C00),
                                      .cell = Color::from_hex(0xD3DFE8),
                                      .glass = Color::from_hex(0x7F93A8),
                                      .outer_solid = Color::from_hex(0x5FA3C4),
                                      .inner_solid = Color::from_hex(0xD9A27E),
                                      .contact_force = Color::from_hex(0x10161D),
                                      .node_mark = Color::from_hex(0xC2185B),
                                      .model = Color::from_hex(0x6B5200),
                                      .needle = Color::from_hex(0xB3204F),
                                      .droplet = Color::from_hex(0x00796B),
                                      .unsure = Color::from_hex(0x8A949F),
                                      .is_light = true};
  return kLight;
}

}  // namespace pellucida
