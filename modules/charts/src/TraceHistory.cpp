#include "pellucida/charts/TraceHistory.h"

#include <cmath>

#include "pellucida/core/GivingWay.h"

namespace pellucida {

void TraceHistory::Trace::append(TracePoint point, long frame) {
  point.after_gap = !points.empty() && frame > last_frame + 1 && point.time_s - points.back().time_s > kBridged_s;
  last_frame = frame;

  // The newest point always shows; it is replaced by the next one unless its turn keeps it.
  if (!points.empty() && offered % every != 0) {
    point.after_gap |= points.back().after_gap;
    points.pop_back();
  }
  points.push_back(point);
  offered = offered % every + 1;
  if (points.size() <= kMostPoints) return;
  std::vector<TracePoint> thinner;
  thinner.reserve(points.size() / 2 + 1);
  for (std::size_t i = 0; i < points.size(); i += 2) {
    thinner.push_back(points[i]);
    if (i > 0) thinner.back().after_gap |= points[i - 1].after_gap;
  }
  points.swap(thinner);
  every *= 2;
  offered = every;
}

void TraceHistory::append(const Measurement& m, double true_force_uN) {
  if (!all_.points.empty() && m.time_s < all_.points.back().time_s) clear();

  // A frame that was not measured says nothing, also not that a touch is over.
  if (!m.state) return;

  // A new touch begins a new curve; the one before stays for comparison.
  if (m.state == CellState::kContact && state_ != CellState::kContact && state_ != CellState::kLost &&
      current_.points.size() > 1) {
    previous_ = std::move(current_.points);
    current_ = Trace{};
  }
  const bool worth_a_mark =
      m.state == CellState::kContact || m.state == CellState::kPunctured || m.state == CellState::kLost;
  if (m.state != state_ && worth_a_mark) {
    if (marks_.size() == kMostMarks) marks_.erase(marks_.begin());
    marks_.push_back({m.time_s, *m.state});
  }
  if (m.state == CellState::kPunctured && state_ == CellState::kContact) {
    std::vector<TracePoint>& points = current_.points;
    points.resize(count_before_giving_way(
        points.size(), m.time_s, [&](std::size_t k) { return points[k].time_s; },
        [&](std::size_t k) { return points[k].indentation_um; }));
  }
  state_ = *m.state;
  if (!std::isfinite(m.contact_force_uN)) return;

  const auto or_force = [&](double value) { return std::isfinite(value) ? value : m.contact_force_uN; };
  const TracePoint point{.time_s = m.time_s,
                         .indentation_um = m.indentation_um,
                         .force_uN = m.contact_force_uN,
                         .lower_uN = or_force(m.contact_force_lower_uN),
                         .upper_uN = or_force(m.contact_force_upper_uN),
                         .picture_lower_uN = or_force(m.contact_force_picture_lower_uN),
                         .picture_upper_uN = or_force(m.contact_force_picture_upper_uN),
                         .true_uN = true_force_uN};
  all_.append(point, m.frame);
  if (m.state == CellState::kContact && std::isfinite(m.indentation_um)) current_.append(point, m.frame);
}

void TraceHistory::clear() {
  *this = TraceHistory{};
}

}  // namespace pellucida
