#include "tracking/FuzzSequence.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "pellucida/core/Error.h"
#include "pellucida/tracking/MembraneTracker.h"
#include "tracking/ObservationChecks.h"

namespace pellucida::test {
namespace {

// A cell with two dark membranes, a holder and a needle, as rough as a few bytes allow. 0..1 at a pixel.
class RoughCell {
 public:
  RoughCell(int width_px, int height_px, ByteReader& choices) {
    const double side = std::min(width_px, height_px);
    radius_ = side * (0.1 + 0.4 * share(choices));
    x_ = width_px * (0.2 + 0.6 * share(choices));
    y_ = height_px * (0.2 + 0.6 * share(choices));
    zona_ = 2.0 + 0.15 * radius_ * share(choices);
    line_ = 0.8 + 2.0 * share(choices);
    dark_ = 0.1 + 0.5 * share(choices);
    noise_ = 0.05 * share(choices);
    dent_ = 0.6 * radius_ * share(choices);
    const double angle = 2.0 * M_PI * share(choices);
    along_x_ = std::cos(angle);
    along_y_ = std::sin(angle);
    tools_ = choices.byte();
    random_.seed(choices.byte());
  }

  double at(int column, int row) {
    const double dx = column - x_, dy = row - y_;
    const double along = dx * along_x_ + dy * along_y_, across = -dx * along_y_ + dy * along_x_;
    // The dent draws the outline in on the needle's side.
    const double dent = along > 0.0 ? dent_ * std::exp(-across * across / (0.08 * radius_ * radius_ + 1.0)) : 0.0;
    const double off = std::hypot(dx, dy) - (radius_ - dent);
    double light = 0.6 - dark_ * (dip(off) + dip(off + zona_)) - (off < -zona_ ? 0.3 * dark_ : 0.0);
    if ((tools_ & 1) && along > radius_ - dent_)
      light -= dark_ * dip(std::abs(across) - 2.0 - 0.03 * (along - radius_));
    if ((tools_ & 2) && along < -radius_) light -= dark_ * dip(std::abs(across) - 0.4 * radius_);
    return std::clamp(light + noise_ * (static_cast<double>(random_() >> 40) / 16777216.0 - 0.5), 0.0, 1.0);
  }

 private:
  static double share(ByteReader& choices) { return choices.byte() / 255.0; }
  double dip(double off) const { return std::exp(-off * off / (2.0 * line_ * line_)); }

  double radius_, x_, y_, zona_, line_, dark_, noise_, dent_, along_x_, along_y_;
  int tools_;
  std::mt19937_64 random_;
};

void put(FuzzImage& image, int x, int y, double value) {
  std::uint8_t* row = image.bytes.data() + y * image.view.row_bytes;
  if (image.view.format == PixelFormat::kGray8) {
    row[x] = static_cast<std::uint8_t>(std::lround(255.0 * value));
  } else {
    const auto wide = static_cast<std::uint16_t>(std::lround(65535.0 * value));
    std::memcpy(row + 2 * static_cast<std::ptrdiff_t>(x), &wide, 2);
  }
}

// Sides of some 100 px mostly, now and then a tiny or a long one; never more than 160,000 pixels.
int side_of(ByteReader& choices, int other) {
  const int kind = choices.byte() % 8;
  const int side = kind == 0 ? 1 + choices.byte() % 16 : kind == 7 ? 256 + 7 * choices.byte() : 30 + choices.byte() / 2;
  return std::max(1, std::min(side, 160000 / std::max(1, other)));
}

double hint_number(ByteReader& choices) {
  switch (choices.byte() % 8) {
    case 0:
      return std::numeric_limits<double>::quiet_NaN();
    case 1:
      return std::numeric_limits<double>::infinity();
    case 2:
      return 1e300;
    case 3:
      return -1e9;
    default:
      return (choices.byte() - 100) * 2.0;
  }
}

}  // namespace

FuzzImage draw_fuzz_image(int width_px, int height_px, PixelFormat format, int row_padding_bytes, FuzzContent content,
                          ByteReader& choices) {
  FuzzImage image;
  const std::ptrdiff_t row_bytes = width_px * (format == PixelFormat::kGray16 ? 2 : 1);
  image.view.format = format;
  image.view.width_px = width_px;
  image.view.height_px = height_px;
  image.view.row_bytes = row_bytes + row_padding_bytes;
  image.view.pixel_size_um = 0.05 * (1 + choices.byte());
  image.bytes.assign(static_cast<std::size_t>(image.view.row_bytes * (height_px - 1) + row_bytes), 0);
  image.view.data = image.bytes.data();

  if (content == FuzzContent::kRawBytes) {
    for (std::uint8_t& b : image.bytes) {
      if (choices.empty()) break;
      b = choices.byte();
    }
    return image;
  }
  RoughCell cell(width_px, height_px, choices);
  const double low = choices.byte() / 255.0, high = choices.byte() / 255.0;
  const int period = 1 + choices.byte() % 40;
  std::mt19937_64 random(choices.byte());
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      const double part = static_cast<double>(random() >> 40) / 16777216.0;
      double value = 0.0;
      switch (content) {
        case FuzzContent::kConstant:
          value = low;
          break;
        case FuzzContent::kNoise:
          value = low + (high - low) * part;
          break;
        case FuzzContent::kGradient:
          value = low + (high - low) * (x + y) / (width_px + height_px);
          break;
        case FuzzContent::kCheckers:
          value = (x / period + y / period) % 2 ? high : low;
          break;
        case FuzzContent::kStripes:
          value = (x / period) % 2 ? high : low;
          break;
        case FuzzContent::kExtremes:
          value = part < low ? 0.0 : 1.0;
          break;
        case FuzzContent::kRawBytes:
          break;
        case FuzzContent::kCell:
          value = cell.at(x, y);
          break;
      }
      put(image, x, y, value);
    }
  image.shows_a_cell = content == FuzzContent::kCell;
  return image;
}

std::string run_fuzz_sequence(const std::uint8_t* data, std::size_t size) {
  ByteReader choices(data, size);
  TrackerOptions options;
  const int setting = choices.byte();
  if (setting % 5 == 1) options.contour_point_count = 64;
  if (setting % 7 == 1) options.min_detection_score = 0.05;
  if (setting % 11 == 1) options.quality = TrackerOptions::Quality::kHigh;
  MembraneTracker tracker(options);

  const int frames = 1 + choices.byte() % 6;
  int width_px = 0, height_px = 0;
  bool may_be_sure = false;
  for (int k = 0; k < frames; ++k) {
    // The size stays most of the time, as a camera's does, and then suddenly changes.
    const int change = choices.byte();
    if (k == 0 || change % 8 == 7) {
      width_px = side_of(choices, 1);
      height_px = side_of(choices, width_px);
    }
    const PixelFormat format = (change & 16) ? PixelFormat::kGray16 : PixelFormat::kGray8;
    const int padding = (change & 32) ? choices.byte() : 0;
    // A cell more often than the rest: only with one is there anything to follow.
    const int what = choices.byte() % (kFuzzContents + 6);
    const FuzzContent content = what < kFuzzContents ? static_cast<FuzzContent>(what) : FuzzContent::kCell;
    const FuzzImage image = draw_fuzz_image(width_px, height_px, format, padding, content, choices);
    may_be_sure = may_be_sure || image.shows_a_cell || content == FuzzContent::kRawBytes;

    FrameHints hints;
    const int wish = choices.byte();
    if (wish % 16 == 3) tracker.reset();
    try {
      if (wish % 4 == 1) hints.needle_motion_um = Eigen::Vector2d(hint_number(choices), hint_number(choices));
      if (wish % 8 == 2) {
        CellHint hint;
        if (wish & 16) hint.inside_um = Eigen::Vector2d(hint_number(choices), hint_number(choices));
        if (wish & 32) {
          Contour_um outline(2, choices.byte() % 12);
          for (Eigen::Index i = 0; i < outline.size(); ++i) outline(i) = hint_number(choices);
          hint.outline_um = outline;
        }
        tracker.expect_cell(hint);
      }
      if (wish % 8 == 5) tracker.expect_holder({hint_number(choices), hint_number(choices)});
      const Observation seen = tracker.process(image.view, k / 30.0, k, hints);
      const std::string wrong = violation_of(seen, image.view);
      const std::string where =
          "frame " + std::to_string(k) + ", " + std::to_string(width_px) + " x " + std::to_string(height_px) + " px: ";
      if (!wrong.empty()) return where + wrong;
      if (!may_be_sure && seen.confidence > 0.8) return where + "sure of a cell where none was drawn";
    } catch (const UsageError&) {
      // A hint or a motion that is no number may be refused, by an error that says so.
    }
  }
  return "";
}

}  // namespace pellucida::test
