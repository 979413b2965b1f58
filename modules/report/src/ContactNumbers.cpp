#include "ContactNumbers.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "ForceCurve.h"

namespace pellucida {
namespace {

constexpr double kNone = ContactPassport::kNone;
/// The force at a puncture is the largest of this time before it: a puncture may be noticed a frame or two late.
constexpr double kBeforePuncture_s = 0.25;
/// Events carry their frame's time, rounded as the tables write it.
constexpr double kSameFrame_s = 1e-5;
/// How long before the touch the needle's approach is looked at.
constexpr double kApproach_s = 0.5;
/// A removal curve that ends deeper than this, in shares of the largest depth, is cut off.
constexpr double kOpenEnd_ratio = 0.25;
constexpr double kOpenEnd_um = 4.0;

void keep_largest(double& largest, double value) noexcept {
  if (!(value <= largest) && !std::isnan(value)) largest = value;
}

double median(std::vector<double> values) {
  if (values.empty()) return kNone;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

class ContactReader {
 public:
  ContactReader(const PassportInput& input, const CellSpan& cell, const ContactSpan& span)
      : input_(input), cell_(cell), span_(span) {}

  ContactPassport read() {
    find_puncture();
    p_.rows = span_.rows;
    p_.outcome = outcome();
    read_times();
    read_rows();
    curve_ = ForceCurve(input_.rows, p_.rows, puncture_row_);
    read_peak();
    read_puncture();
    read_works();
    read_stiffness();
    read_stiffening();
    read_speeds();
    read_deposits();
    return std::move(p_);
  }

 private:
  const Measurement& row(std::size_t i) const { return input_.rows[i]; }

  // The first that was not revoked: rows in that state before a revocation belong to the contact.
  void find_puncture() {
    std::optional<std::size_t> latest;
    for (std::size_t i = span_.rows.begin; i < span_.rows.end; ++i) {
      if (row(i).state == CellState::kPunctured) {
        if (!latest) latest = i;
        if (!puncture_row_) puncture_row_ = latest;
      } else if (row(i).state) {
        if (puncture_row_ == latest && is_revoked_at(row(i).time_s)) puncture_row_.reset();
        latest.reset();
      }
    }
  }

  bool is_revoked_at(double time_s) const {
    return std::any_of(input_.events.begin(), input_.events.end(), [&](const Event& event) {
      return event.kind == event_kind::kRevoked && std::abs(event.time_s - time_s) < kSameFrame_s;
    });
  }

  const char* outcome() const {
    if (puncture_row_) return "punctured";
    if (span_.end == ContactEnd::kReleased) return "retracted";
    return span_.end == ContactEnd::kLost ? "lost" : "unfinished";
  }

  void read_times() {
    const double last_s = row(span_.rows.end - 1).time_s;
    const double end_s = std::isnan(span_.release_s) ? last_s : span_.release_s;
    p_.touch_s = row(span_.rows.begin).time_s;
    p_.release_s = span_.release_s;
    p_.dwell_s = end_s - p_.touch_s;
    if (!puncture_row_) return;
    p_.puncture_s = row(*puncture_row_).time_s;
    p_.inside_s = end_s - p_.puncture_s;
  }

  void read_rows() {
    std::vector<double> confidences;
    p_.frames = static_cast<int>(p_.rows.end - p_.rows.begin);
    for (std::size_t i = p_.rows.begin; i < p_.rows.end; ++i) {
      if (!row(i).state) ++p_.unmeasured_frames;
      if (!is_touching(row(i))) continue;
      if (!std::isnan(row(i).confidence)) confidences.push_back(row(i).confidence);
      if (row(i).state == CellState::kContact) keep_largest(p_.largest_pressure_Pa, row(i).pressure_Pa);
      if (input_.membrane.empty()) continue;
      const MembraneState& membrane = input_.membrane[i];
      keep_largest(p_.largest_area_strain_percent, membrane.area_strain_percent);
      keep_largest(p_.largest_mean_tension_uN_per_um, membrane.mean_tension_uN_per_um);
      keep_largest(p_.largest_tension_uN_per_um, membrane.largest_tension_uN_per_um);
    }
    p_.confidence = median(std::move(confidences));
  }

  void read_peak() {
    if (curve_.empty()) return;
    const ForcePoint& peak = curve_.points()[curve_.strongest(0)];
    p_.peak_force_uN = peak.force_uN;
    p_.peak_force_lower_uN = peak.lower_uN;
    p_.peak_force_upper_uN = peak.upper_uN;
    p_.peak_force_depth_um = peak.depth_um;
    p_.peak_force_s = peak.time_s;
    const ForceSpread spread = force_spread(row(peak.row));
    p_.picture_sigma_percent = 100.0 * spread.picture_ratio;
    p_.scale_sigma_percent = 100.0 * spread.scale_ratio;
    const std::size_t deepest = curve_.deepest();
    p_.largest_depth_um = curve_.points()[deepest].depth_um;
    p_.insertion = {p_.rows.begin, curve_.points()[deepest].row + 1};
  }

  void read_puncture() {
    if (!puncture_row_ || curve_.empty() || curve_.before_puncture() == 0) return;
    // Rows of long ago say nothing about the force at which it gave way.
    const std::size_t last = curve_.before_puncture() - 1;
    if (p_.puncture_s - curve_.points()[last].time_s > 2.0 * kBeforePuncture_s) return;
    std::size_t first = last;
    while (first > 0 && curve_.points()[first - 1].time_s >= p_.puncture_s - kBeforePuncture_s) --first;
    const ForcePoint& before = curve_.points()[curve_.strongest(first)];
    p_.puncture_force_uN = before.force_uN;
    p_.puncture_force_lower_uN = before.lower_uN;
    p_.puncture_force_upper_uN = before.upper_uN;
    p_.puncture_depth_um = before.depth_um;
    p_.insertion = {p_.rows.begin, *puncture_row_};
    const Measurement& after = row(*puncture_row_);
    p_.drop_uN = before.force_uN - after.contact_force_uN;
    p_.drop_lower_uN = before.lower_uN - or_force(after.contact_force_upper_uN, after);
    p_.drop_upper_uN = before.upper_uN - or_force(after.contact_force_lower_uN, after);
    p_.spring_back_um = before.depth_um - after.indentation_um;
  }

  static double or_force(double end_uN, const Measurement& row) {
    return std::isnan(end_uN) ? row.contact_force_uN : end_uN;
  }

  void read_works() {
    if (curve_.empty()) return;
    const std::size_t deepest = curve_.deepest();
    const WorkInterval work = curve_.work_to(deepest);
    p_.work_pJ = work.value;
    p_.work_lower_pJ = work.lower;
    p_.work_upper_pJ = work.upper;
    if (!std::isnan(p_.puncture_force_uN)) {
      const WorkInterval at_puncture = curve_.work_to(curve_.before_puncture() - 1);
      p_.puncture_work_pJ = at_puncture.value;
      p_.puncture_work_lower_pJ = at_puncture.lower;
      p_.puncture_work_upper_pJ = at_puncture.upper;
    }
    const double end_um = curve_.points().back().depth_um;
    const bool comes_back = end_um <= std::max(kOpenEnd_um, kOpenEnd_ratio * p_.largest_depth_um);
    if (span_.end != ContactEnd::kReleased || puncture_row_ || !comes_back) return;
    const WorkInterval loop = curve_.loop();
    p_.hysteresis_pJ = loop.value;
    p_.hysteresis_lower_pJ = loop.lower;
    p_.hysteresis_upper_pJ = loop.upper;
  }

  void read_stiffness() {
    using P = ContactPassport;
    constexpr std::array kPlaces{
        std::array{&P::stiffness_5um_uN_per_um, &P::stiffness_5um_lower_uN_per_um, &P::stiffness_5um_upper_uN_per_um},
        std::array{&P::stiffness_10um_uN_per_um, &P::stiffness_10um_lower_uN_per_um,
                   &P::stiffness_10um_upper_uN_per_um},
        std::array{&P::stiffness_20um_uN_per_um, &P::stiffness_20um_lower_uN_per_um,
                   &P::stiffness_20um_upper_uN_per_um},
        std::array{&P::stiffness_30um_uN_per_um, &P::stiffness_30um_lower_uN_per_um,
                   &P::stiffness_30um_upper_uN_per_um},
        std::array{&P::stiffness_40um_uN_per_um, &P::stiffness_40um_lower_uN_per_um,
                   &P::stiffness_40um_upper_uN_per_um}};
    static_assert(kPlaces.size() == kStiffnessDepths_um.size());
    for (std::size_t k = 0; k < kPlaces.size(); ++k) {
      const auto slope = curve_.stiffness_at(kStiffnessDepths_um[k]);
      if (!slope) continue;
      p_.*kPlaces[k][0] = slope->value;
      p_.*kPlaces[k][1] = slope->lower;
      p_.*kPlaces[k][2] = slope->upper;
    }
  }

  // Contours are added to those before: the last say most.
  void read_stiffening() {
    for (std::size_t i = span_.rows.begin; i < span_.rows.end; ++i) {
      const Measurement& m = row(i);
      if (m.state != CellState::kContact || std::isnan(m.strain_stiffening)) continue;
      p_.strain_stiffening = m.strain_stiffening;
      p_.strain_stiffening_lower = m.strain_stiffening_lower;
      p_.strain_stiffening_upper = m.strain_stiffening_upper;
    }
  }

  // How far the tip lies from the cell's centre, towards where the needle came from.
  std::optional<double> tip_um(std::size_t i) const {
    const double angle_rad = row(span_.rows.begin).axis_deg * std::numbers::pi / 180.0;
    const double along_um = (row(i).tip_x_um - row(i).cell_x_um) * std::cos(angle_rad) +
                            (row(i).tip_y_um - row(i).cell_y_um) * std::sin(angle_rad);
    return std::isnan(along_um) ? std::nullopt : std::optional(along_um);
  }

  // Mean speed of the tip towards the cell between the first and the last row that show it.
  double speed(std::size_t begin, std::size_t end) const {
    std::optional<std::size_t> first, last;
    for (std::size_t i = begin; i < end; ++i) {
      if (!tip_um(i)) continue;
      if (!first) first = i;
      last = i;
    }
    if (!first || *first == *last) return kNone;
    return (*tip_um(*first) - *tip_um(*last)) / (row(*last).time_s - row(*first).time_s);
  }

  void read_speeds() {
    const std::size_t touch = span_.rows.begin;
    std::size_t from = touch;
    while (from > cell_.rows.begin && row(touch).time_s - row(from - 1).time_s <= kApproach_s &&
           !is_touching(row(from - 1)))
      --from;
    if (from < touch) p_.approach_speed_um_per_s = speed(from, touch + 1);
    if (!p_.insertion.empty()) p_.insertion_speed_um_per_s = speed(touch, p_.insertion.end);

    // Out again: from where the tip was deepest.
    std::size_t deepest = touch;
    double least_um = std::numeric_limits<double>::infinity();
    for (std::size_t i = touch; i < span_.rows.end; ++i) {
      const auto along_um = tip_um(i);
      if (!along_um || *along_um > least_um) continue;
      least_um = *along_um;
      deepest = i;
    }
    if (span_.end == ContactEnd::kReleased) p_.removal_speed_um_per_s = -speed(deepest, span_.rows.end);
  }

  void read_deposits() {
    if (!input_.is_hand_recorded) return;
    const double end_s = std::isnan(p_.release_s) ? row(span_.rows.end - 1).time_s : p_.release_s;
    p_.deposit_s = 0.0;
    for (const Deposit& deposit : input_.deposits) {
      const double length_s = std::min(deposit.end_s, end_s) - std::max(deposit.begin_s, p_.touch_s);
      if (length_s <= 0.0) continue;
      p_.deposit_s += length_s;
      if (std::isnan(p_.first_deposit_s)) p_.first_deposit_s = std::max(deposit.begin_s, p_.touch_s);
    }
  }

  const PassportInput& input_;
  const CellSpan& cell_;
  const ContactSpan& span_;
  std::optional<std::size_t> puncture_row_;
  ForceCurve curve_;
  ContactPassport p_;
};

}  // namespace

ContactPassport contact_numbers(const PassportInput& input, const CellSpan& cell, const ContactSpan& span) {
  return ContactReader(input, cell, span).read();
}

}  // namespace pellucida
