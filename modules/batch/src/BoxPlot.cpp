#include "BoxPlot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "pellucida/core/Html.h"
#include "pellucida/core/RoundNumbers.h"
#include "pellucida/core/Statistics.h"
#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

constexpr double kLeft = 54.0, kRight = 12.0, kTop = 30.0, kPlot = 180.0, kBottom = 44.0, kStep = 84.0, kBox = 34.0;
// Distinguishable by people who see colours differently (Okabe and Ito).
constexpr std::array kBoxColors{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};
constexpr std::size_t kMostLetters = 13;

struct Axis {
  double low, high;
  double y(double value) const { return kTop + kPlot * (high - value) / (high - low); }
};

template <class... Values>
std::string drawn(const char* format, Values... values) {
  std::array<char, 512> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

std::string shortened(const std::string& name) {
  if (name.size() <= kMostLetters) return name;
  std::size_t end = kMostLetters - 1;
  // Never in the middle of a letter of several bytes.
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) --end;
  return name.substr(0, end) + "…";
}

std::string box(const std::vector<double>& sorted, const Axis& axis, double x, const char* color) {
  const double lower = quantile(sorted, 0.25), middle = quantile(sorted, 0.5), upper = quantile(sorted, 0.75);
  const double reach = 1.5 * (upper - lower);
  // Of few values the farthest one within reach may lie inside the box.
  const double least =
      std::min(lower, *std::find_if(sorted.begin(), sorted.end(), [&](double v) { return v >= lower - reach; }));
  const double most =
      std::max(upper, *std::find_if(sorted.rbegin(), sorted.rend(), [&](double v) { return v <= upper + reach; }));
  const double half = 0.5 * kBox;
  std::string svg;
  svg += drawn(R"(<path d="M%.1f %.1fV%.1fM%.1f %.1fV%.1f" stroke="%s"/>)", x, axis.y(least), axis.y(lower), x,
               axis.y(upper), axis.y(most), color);
  svg += drawn(R"(<rect x="%.1f" y="%.1f" width="%.1f" height="%.1f" stroke="%s" fill="%s" fill-opacity=".14"/>)",
               x - half, axis.y(upper), kBox, std::max(0.5, axis.y(lower) - axis.y(upper)), color, color);
  svg +=
      drawn(R"(<path d="M%.1f %.1fH%.1f" stroke="%s" stroke-width="2.5"/>)", x - half, axis.y(middle), x + half, color);
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    // Spread evenly, the same way every time: multiples of the golden ratio.
    const double aside = std::fmod(0.618034 * static_cast<double>(k + 1), 1.0) - 0.5;
    svg += drawn(R"(<circle cx="%.1f" cy="%.1f" r="2" fill="%s" fill-opacity=".55"/>)", x + 0.7 * kBox * aside,
                 axis.y(sorted[k]), color);
  }
  return svg;
}

}  // namespace

std::string box_plot_svg(const std::string& title, std::span<const BoxSample> samples) {
  std::vector<double> all;
  for (const BoxSample& sample : samples) all.insert(all.end(), sample.values.begin(), sample.values.end());
  if (all.empty() || std::all_of(all.begin(), all.end(), [&](double v) { return v == all.front(); })) return {};
  auto [low, high] = std::minmax_element(all.begin(), all.end());
  const auto ticks = round_ticks(*low, *high, TickEnds::kOutside);
  const Axis axis{ticks.front(), ticks.back()};

  const double width = std::max(240.0, kLeft + kStep * static_cast<double>(samples.size()) + kRight);
  const double height = kTop + kPlot + kBottom;
  const double step = (width - kLeft - kRight) / static_cast<double>(samples.size());
  std::string svg = drawn(R"(<svg viewBox="0 0 %.0f %.0f" width="%.0f" height="%.0f" role="img" aria-label="%s">)",
                          width, height, width, height, html_text(title).substr(0, 200).c_str());
  svg += drawn(R"(<text x="%.0f" y="16" class="name">%s</text>)", 4.0, html_text(title).substr(0, 200).c_str());
  for (const double tick : ticks) {
    svg += drawn(R"(<path d="M%.1f %.1fH%.1f" class="grid"/><text x="%.1f" y="%.1f" text-anchor="end">%s</text>)",
                 kLeft, axis.y(tick), width - kRight, kLeft - 6.0, axis.y(tick) + 4.0, csv_number(tick).c_str());
  }
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const double x = kLeft + step * (static_cast<double>(k) + 0.5);
    std::vector<double> sorted = samples[k].values;
    std::sort(sorted.begin(), sorted.end());
    if (!sorted.empty()) svg += "<g fill=\"none\">" + box(sorted, axis, x, kBoxColors[k % kBoxColors.size()]) + "</g>";
    svg += drawn(R"(<text x="%.1f" y="%.1f" text-anchor="middle">%s</text>)", x, kTop + kPlot + 18.0,
                 html_text(shortened(samples[k].name)).c_str());
    svg += drawn(R"(<text x="%.1f" y="%.1f" text-anchor="middle" class="dim">n = %zu</text>)", x, kTop + kPlot + 34.0,
                 sorted.size());
  }
  return svg + "</svg>\n";
}

}  // namespace pellucida
