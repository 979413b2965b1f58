#include "SceneReading.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "ContourMath.h"
#include "FacingTools.h"
#include "Median.h"

namespace pellucida {
namespace {

// A holding pipette's end, of the radius of the cell that it holds from its centre, and the cosine of where it points.
constexpr double kNearestEnd_ratio = 0.6, kFarthestEnd_ratio = 1.4, kAimed = 0.7;
constexpr float kCertain = 0.5F;       // probability from which a map pixel belongs to a class
constexpr int kFiner = 4;              // outlines are drawn on a grid that many times as fine as the map
constexpr double kLeastCell = 14.0;    // map pixels: area of a cell
constexpr double kLeastTool = 6.0;     // map pixels: area of a tool
constexpr double kLeastLength = 4.0;   // map pixels: length of a tool
constexpr double kLeastCircle = 0.45;  // 4 pi area / perimeter^2 of a cell's outline
constexpr double kSlender = 1.5;       // length over width of a tool
// Cosine between its longest axis and its way in, of a stub that is wider than long. Set on validation film 55035.
constexpr double kStub = 0.5;
constexpr double kBent = 1.3;        // as wide as its area spreads, over what its area and length make, of a bent tool
constexpr double kBentWidths = 2.2;  // widths of such a tool that are taken for straight
constexpr int kTipReach = 3;         // map pixels round a tool's end in which the tip's mark counts

cv::Mat1f view(const SceneMap::Plane& plane) {
  return {static_cast<int>(plane.rows()), static_cast<int>(plane.cols()), const_cast<float*>(plane.data())};
}

// Areas of a mask, as lists of pixels.
std::vector<std::vector<cv::Point>> areas(const cv::Mat1b& mask) {
  cv::Mat1i labels;
  const int count = cv::connectedComponents(mask, labels, 8, CV_32S);
  std::vector<std::vector<cv::Point>> result(static_cast<std::size_t>(count - 1));
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (labels(y, x) > 0) result[static_cast<std::size_t>(labels(y, x) - 1)].push_back({x, y});
  return result;
}

double mean_share(const cv::Mat1f& share, const std::vector<cv::Point>& area) {
  double sum = 0.0;
  for (const cv::Point& p : area) sum += share(p);
  return area.empty() ? 0.0 : sum / static_cast<double>(area.size());
}

// The longest outline of probability 1/2 about the area whose pixels `area` marks, px of the image.
Eigen::Matrix2Xd outline(const SceneMap& map, const cv::Mat1f& share, const std::vector<cv::Point>& area) {
  cv::Mat1f own(share.size(), 0.0F);
  cv::Mat1b near(share.size(), uchar{0});
  for (const cv::Point& p : area) near(p) = 255;
  cv::dilate(near, near, {});
  share.copyTo(own, near);
  cv::Mat1f fine;
  cv::resize(own, fine, {}, kFiner, kFiner, cv::INTER_LINEAR);
  std::vector<std::vector<cv::Point>> found;
  cv::findContours(fine > kCertain, found, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  if (found.empty()) return {};
  const auto longest = std::max_element(
      found.begin(), found.end(), [](const auto& a, const auto& b) { return cv::contourArea(a) < cv::contourArea(b); });
  Eigen::Matrix2Xd points(2, static_cast<Eigen::Index>(longest->size()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const cv::Point& p = (*longest)[static_cast<std::size_t>(i)];
    // Pixel centres of the fine grid lie (k + 1/2) / kFiner - 1/2 on the map.
    points.col(i) =
        map.to_image((Eigen::Vector2d(p.x, p.y).array() + 0.5).matrix() / kFiner - Eigen::Vector2d::Constant(0.5));
  }
  return contour::positively_oriented(points);
}

void read_cells(const SceneMap& map, std::vector<SceneCell>& cells) {
  const cv::Mat1f zona = view(map.share(SceneClass::kZona)), inside = view(map.share(SceneClass::kInside));
  const cv::Mat1f cell = zona + inside;
  for (const std::vector<cv::Point>& area : areas(cell > kCertain)) {
    if (static_cast<double>(area.size()) < kLeastCell) continue;
    SceneCell found;
    found.outer = outline(map, cell, area);
    const double perimeter = contour::arc_length(found.outer), size = contour::signed_area(found.outer);
    if (found.outer.cols() < 8 || 4.0 * std::numbers::pi * size < kLeastCircle * perimeter * perimeter) continue;
    found.center = contour::centroid(found.outer);
    found.radius_px = std::sqrt(size / std::numbers::pi);
    found.share = mean_share(cell, area);
    std::vector<cv::Point> core;
    for (const cv::Point& p : area)
      if (inside(p) > kCertain) core.push_back(p);
    if (static_cast<double>(core.size()) > 0.2 * static_cast<double>(area.size()))
      found.inner = outline(map, inside, core);
    cells.push_back(std::move(found));
  }
  std::stable_sort(cells.begin(), cells.end(), [](const SceneCell& a, const SceneCell& b) {
    return a.share * a.radius_px > b.share * b.radius_px;
  });
}

// The longest axis of an area, each pixel by its probability; length and width of a rectangle that spreads as it does.
struct LongAxis {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero(), direction = Eigen::Vector2d::UnitX();
  double length = 0.0, width = 0.0;
};
LongAxis long_axis(const std::vector<cv::Point>& area, const cv::Mat1f& share) {
  LongAxis axis;
  double total = 0.0;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const cv::Point& p : area) {
    axis.mean += share(p) * Eigen::Vector2d(p.x, p.y);
    total += share(p);
  }
  axis.mean /= total;
  for (const cv::Point& p : area) {
    const Eigen::Vector2d d = Eigen::Vector2d(p.x, p.y) - axis.mean;
    spread += share(p) / total * d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  axis.direction = axes.eigenvectors().col(1);
  axis.length = std::sqrt(12.0 * std::max(0.0, axes.eigenvalues()[1]));
  axis.width = std::sqrt(12.0 * std::max(0.0, axes.eigenvalues()[0]));
  return axis;
}

// Half the width across a direction, map pixels: half the median, over its length, of the probability summed across.
double half_width_across(const std::vector<cv::Point>& area, const cv::Mat1f& share, const Eigen::Vector2d& direction) {
  cv::Mat1b near(share.size(), uchar{0});
  double from = std::numeric_limits<double>::infinity(), to = -from;
  for (const cv::Point& p : area) {
    near(p) = 255;
    const double along = Eigen::Vector2d(p.x, p.y).dot(direction);
    from = std::min(from, along);
    to = std::max(to, along);
  }
  cv::dilate(near, near, {}, {-1, -1}, 2);
  std::vector<double> widths(static_cast<std::size_t>(std::lround(to - from)) + 1);
  for (int y = 0; y < near.rows; ++y)
    for (int x = 0; x < near.cols; ++x) {
      const long at = std::lround(Eigen::Vector2d(x, y).dot(direction) - from);
      if (near(y, x) > 0 && at >= 0 && at < static_cast<long>(widths.size()))
        widths[static_cast<std::size_t>(at)] += double{share(y, x)};
    }
  return 0.5 * median_of(widths);
}

// Middle of the part of an area that lies at the map's border; nothing where none does.
std::optional<Eigen::Vector2d> middle_of_border(const std::vector<cv::Point>& area, const cv::Mat1f& share) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double total = 0.0;
  for (const cv::Point& p : area) {
    if (p.x > 0 && p.y > 0 && p.x < share.cols - 1 && p.y < share.rows - 1) continue;
    sum += share(p) * Eigen::Vector2d(p.x, p.y);
    total += share(p);
  }
  return total > 0.0 ? std::optional<Eigen::Vector2d>(sum / total) : std::nullopt;
}

// Of a bent tool's area the part at its end inside the image, about twice as long as wide; the area itself where it is
// straight or nowhere at the border.
std::vector<cv::Point> end_of_bent(const std::vector<cv::Point>& area, const cv::Mat1f& share) {
  const LongAxis axis = long_axis(area, share);
  const double width = static_cast<double>(area.size()) / std::max(axis.length, 1.0);
  const std::optional<Eigen::Vector2d> entry = middle_of_border(area, share);
  if (!entry || axis.width < kBent * width) return area;
  const auto way = [](const cv::Point& p, const Eigen::Vector2d& from) {
    return (Eigen::Vector2d(p.x, p.y) - from).norm();
  };
  const cv::Point& last = *std::max_element(
      area.begin(), area.end(), [&](const auto& a, const auto& b) { return way(a, *entry) < way(b, *entry); });
  const Eigen::Vector2d end(last.x, last.y);
  std::vector<cv::Point> part;
  std::copy_if(area.begin(), area.end(), std::back_inserter(part),
               [&](const cv::Point& p) { return way(p, end) < std::max(kBentWidths * width, kLeastLength); });
  return part;
}

// Whether an area comes in over the length of its longest axis: a pipette wider than what is in view of it is long.
bool is_stub(const LongAxis& axis, const Eigen::Vector2d& entry) {
  const Eigen::Vector2d in = axis.mean - entry;
  return std::abs(in.dot(axis.direction)) < kStub * in.norm();
}

// Whether a holding pipette that ends there may hold the cell.
bool ends_at(const Eigen::Vector2d& end, const Eigen::Vector2d& center, double radius_px) {
  const double away = (center - end).norm() / radius_px;
  return away > kNearestEnd_ratio && away < kFarthestEnd_ratio;
}

bool ends_at_one(const Eigen::Vector2d& end, const std::vector<SceneCell>& cells) {
  return std::any_of(cells.begin(), cells.end(), [&](const SceneCell& cell) {
    return cell.share > kLeastCellShare && ends_at(end, cell.center, cell.radius_px);
  });
}

void read_tools(const SceneMap& map, SceneClass which, const std::vector<SceneCell>& cells, int image_width,
                int image_height, std::vector<SceneTool>& tools) {
  const cv::Mat1f share = view(map.share(which)), tips = view(map.tip);
  const Eigen::Vector2d middle(0.5 * (image_width - 1), 0.5 * (image_height - 1));
  for (const std::vector<cv::Point>& whole : areas(share > kCertain)) {
    if (static_cast<double>(whole.size()) < kLeastTool) continue;
    const bool is_holder = which == SceneClass::kHolder;
    const std::vector<cv::Point> area = is_holder ? end_of_bent(whole, share) : whole;
    const LongAxis axis = long_axis(area, share);
    const Eigen::Vector2d mean = axis.mean;
    const double length = axis.length, width = axis.width;
    Eigen::Vector2d direction = axis.direction;
    if (length < kLeastLength) continue;
    const std::optional<Eigen::Vector2d> from_border = middle_of_border(area, share);
    const bool is_short = length < kSlender * width || (is_holder && from_border && is_stub(axis, *from_border));
    if (is_short) {
      if (!is_holder || !from_border || (mean - *from_border).norm() < 0.25 * kLeastLength) continue;
      direction = (mean - *from_border).normalized();
    }
    double from = 0.0, to = 0.0;
    for (const cv::Point& p : area) {
      const double along = (Eigen::Vector2d(p.x, p.y) - mean).dot(direction);
      from = std::min(from, along);
      to = std::max(to, along);
    }
    // The end that is nearer to the image's border is where it comes in, unless a cell is held there.
    const auto to_border = [&](double along) {
      const Eigen::Vector2d p = map.to_image(mean + along * direction);
      return std::min({p.x(), p.y(), image_width - 1 - p.x(), image_height - 1 - p.y()});
    };
    const double a = to_border(from), b = to_border(to);
    const std::optional<Eigen::Vector2d> entry = middle_of_border(whole, share);
    const bool is_end = area.size() < whole.size();  // of a bent one: away from where the whole comes in
    const auto holds_at = [&](double along) { return ends_at_one(map.to_image(mean + along * direction), cells); };
    // A part of one, as where the map has the rest for a needle.
    const bool is_part = is_holder && !entry && holds_at(from) != holds_at(to);
    const bool turned =
        is_end && entry ? (mean + to * direction - *entry).norm() < (mean + from * direction - *entry).norm()
        : is_part       ? holds_at(from)
        : std::abs(a - b) > 2.0 * map.pitch_px ? b < a
                                               : (map.to_image(mean + to * direction) - middle).norm() >
                                                     (map.to_image(mean + from * direction) - middle).norm();
    if (turned) {
      direction = -direction;
      std::swap(from, to);
      to = -to;
      from = -from;
    }
    SceneTool tool;
    tool.direction = direction;
    tool.is_short = is_short || is_end;
    tool.length_px = map.pitch_px * (to - from);
    tool.half_width_px = map.pitch_px * (is_holder ? half_width_across(area, share, direction)
                                                   : 0.5 * static_cast<double>(area.size()) / std::max(to - from, 1.0));
    tool.share = mean_share(share, area);
    tool.pitch_px = map.pitch_px;
    Eigen::Vector2d tip = mean + to * direction;
    // The tip's own mark near that end is more precise.
    double weight = 0.0;
    Eigen::Vector2d marked = Eigen::Vector2d::Zero();
    for (int dy = -kTipReach; dy <= kTipReach; ++dy)
      for (int dx = -kTipReach; dx <= kTipReach; ++dx) {
        const int x = static_cast<int>(std::lround(tip.x())) + dx, y = static_cast<int>(std::lround(tip.y())) + dy;
        if (x < 0 || y < 0 || x >= tips.cols || y >= tips.rows) continue;
        const float mark = tips(y, x);
        tool.tip_share = std::max(tool.tip_share, double{mark});
        marked += mark * mark * Eigen::Vector2d(x, y);
        weight += mark * mark;
      }
    if (tool.tip_share > kCertain) tip = marked / weight;
    tool.tip = map.to_image(tip);
    tools.push_back(tool);
  }
  // A part of a holding pipette may look like a needle, and is longer than one; but no tip is marked at its end.
  std::stable_sort(tools.begin(), tools.end(), [&](const SceneTool& a, const SceneTool& b) {
    const auto is_marked = [](const SceneTool& tool) { return tool.tip_share >= kLeastNeedleTipShare; };
    if (which == SceneClass::kNeedle && is_marked(a) != is_marked(b)) return is_marked(a);
    return a.share * a.length_px * (0.5 + a.tip_share) > b.share * b.length_px * (0.5 + b.tip_share);
  });
}

// Where the map has no needle and two holding pipettes that face each other, the one at whose end it marks a needle's
// tip is the needle: as wide a one as tuning film 303025's looks like a holding pipette.
void take_marked_for_needle(SceneReading& reading) {
  std::vector<SceneTool>& holders = reading.holders;
  const auto faces = [](const SceneTool& a, const SceneTool& b) {
    return a.direction.dot(b.direction) < -kAlongHolder;
  };
  const auto is_needle = [&](const SceneTool& tool) {
    return tool.tip_share >= kLeastNeedleTipShare &&
           std::any_of(holders.begin(), holders.end(), [&](const SceneTool& other) {
             return faces(tool, other) && other.tip_share < kLeastNeedleTipShare &&
                    other.half_width_px > tool.half_width_px;
           });
  };
  const auto needle = std::find_if(holders.begin(), holders.end(), is_needle);
  if (!reading.needles.empty() || needle == holders.end()) return;
  reading.needles.push_back(*needle);
  holders.erase(needle);
}

}  // namespace

bool points_into(const SceneTool& needle, const Eigen::Vector2d& center, double radius_px) {
  const Eigen::Vector2d way = center - needle.tip;
  return way.dot(needle.direction) > 0.0 &&
         std::abs(way.x() * needle.direction.y() - way.y() * needle.direction.x()) < radius_px;
}

bool is_worked_on(const SceneReading& seen, const Eigen::Vector2d& center, double radius_px) {
  const auto holds = [&](const SceneTool& holder) {
    const Eigen::Vector2d way = center - holder.tip;
    return ends_at(holder.tip, center, radius_px) && holder.direction.dot(way) > kAimed * way.norm();
  };
  const auto aims_at = [&](const SceneTool& needle) { return points_into(needle, center, radius_px); };
  return std::any_of(seen.needles.begin(), seen.needles.end(), aims_at) ||
         std::any_of(seen.holders.begin(), seen.holders.end(), holds);
}

SceneReading read_scene(const SceneMap& map, int image_width, int image_height) {
  SceneReading reading;
  read_cells(map, reading.cells);
  read_tools(map, SceneClass::kNeedle, reading.cells, image_width, image_height, reading.needles);
  read_tools(map, SceneClass::kHolder, reading.cells, image_width, image_height, reading.holders);
  take_marked_for_needle(reading);
  return reading;
}

}  // namespace pellucida
