#include "ColorMap.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

constexpr std::array<Color, 6> kForceStops = {Color::from_hex(0x5B4FD0), Color::from_hex(0x9A4FD6),
                                              Color::from_hex(0xDB4D9F), Color::from_hex(0xFB7260),
                                              Color::from_hex(0xFFAE4A), Color::from_hex(0xFFEE9C)};
constexpr std::array<Color, 6> kSurfaceStops = {Color::from_hex(0x2F4B9B), Color::from_hex(0x2C74B3),
                                                Color::from_hex(0x279CA8), Color::from_hex(0x3FC08A),
                                                Color::from_hex(0x95DB6B), Color::from_hex(0xF0F3A0)};

constexpr std::array<Color, 6> kPullStops = {Color::from_hex(0x2F6BFF), Color::from_hex(0x5C93E6),
                                             Color::from_hex(0x8A97A6), Color::from_hex(0xA8978A),
                                             Color::from_hex(0xF08A4B), Color::from_hex(0xF0483E)};

// On a light ground: dark where it counts.
constexpr std::array<Color, 6> kForceStopsOnLight = {Color::from_hex(0xE0A12E), Color::from_hex(0xE8743B),
                                                     Color::from_hex(0xD2456B), Color::from_hex(0xA0338C),
                                                     Color::from_hex(0x66299A), Color::from_hex(0x2A1A66)};
constexpr std::array<Color, 6> kSurfaceStopsOnLight = {Color::from_hex(0xE3EE9E), Color::from_hex(0x95DB6B),
                                                       Color::from_hex(0x3FC08A), Color::from_hex(0x279CA8),
                                                       Color::from_hex(0x2C74B3), Color::from_hex(0x23357A)};

const std::array<Color, 6>& stops_of(ColorMapKind kind, bool is_light) noexcept {
  switch (kind) {
    case ColorMapKind::kForce:
      return is_light ? kForceStopsOnLight : kForceStops;
    case ColorMapKind::kSurface:
      return is_light ? kSurfaceStopsOnLight : kSurfaceStops;
    case ColorMapKind::kPull:
      break;
  }
  return kPullStops;
}

constexpr double kBarWidth = 12.0;
constexpr int kBands = 64;

}  // namespace

Color color_at(ColorMapKind kind, double t, const ThemeColors& theme) noexcept {
  const auto& stops = stops_of(kind, theme.is_light);
  const double place = std::clamp(t, 0.0, 1.0) * (stops.size() - 1);
  const auto lower = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const double part = place - static_cast<double>(lower);
  const Color& a = stops[lower];
  const Color& b = stops[lower + 1];
  return {a.red + part * (b.red - a.red), a.green + part * (b.green - a.green), a.blue + part * (b.blue - a.blue)};
}

void fill_lookup_table(vtkLookupTable* table, ColorMapKind kind) {
  constexpr int kCount = 256;
  table->SetNumberOfTableValues(kCount);
  for (int i = 0; i < kCount; ++i) {
    const Color c = color_at(kind, static_cast<double>(i) / (kCount - 1));
    table->SetTableValue(i, c.red, c.green, c.blue, 1.0);
  }
}

vtkSmartPointer<vtkLookupTable> make_lookup_table(ColorMapKind kind) {
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  fill_lookup_table(table, kind);
  table->SetTableRange(0.0, 1.0);
  return table;
}

void draw_color_bar(HudCanvas& hud, ColorMapKind kind, double x, double y, double height_px, double upper,
                    const std::string& title, HudAlign side, bool open_end, const ThemeColors& theme) {
  // The bar is at the view's edge, its labels towards the middle.
  const bool right = side == HudAlign::kRight;
  const double bar_x = right ? x - kBarWidth : x;
  for (int i = 0; i < kBands; ++i) {
    hud.rectangle(bar_x, y + i * height_px / kBands, kBarWidth, height_px / kBands + 0.5,
                  color_at(kind, (i + 0.5) / kBands, theme));
  }
  constexpr int kLabels = 5;
  const double lower = kind == ColorMapKind::kPull ? -upper : 0.0;
  const HudText style{.color = theme.text, .align = right ? HudAlign::kRight : HudAlign::kLeft};
  for (int i = 0; i < kLabels; ++i) {
    const double part = static_cast<double>(i) / (kLabels - 1);
    const double tick_x = right ? bar_x - 5.0 : bar_x + kBarWidth + 1.0;
    hud.rectangle(tick_x, y + part * height_px - 0.5, 4.0, 1.0, theme.text_dim);
    hud.text(right ? tick_x - 4.0 : tick_x + 8.0, y + part * height_px,
             (open_end && i == kLabels - 1 ? "\u2265 " : "") + readout::plain(lower + part * (upper - lower)), style);
  }
  hud.text(x, y + height_px + 20.0, title, {.color = theme.text, .align = style.align});
}

}  // namespace pellucida
