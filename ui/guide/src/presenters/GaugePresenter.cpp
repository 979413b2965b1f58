#include "presenters/GaugePresenter.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

constexpr double kNormal95 = 1.96;
// Slower is at rest: the tip's own scatter from frame to frame.
constexpr double kAtRest_um_per_s = 1.0;
// How a speed from frames is smoothed.
constexpr double kSpeedMemory_s = 0.15;

std::string with_unit(double number, int decimals, const char* unit) {
  return readout::number(number, decimals) + " " + unit;
}

double share_of(double value, double limit) {
  return limit > 0.0 && std::isfinite(value) ? std::clamp(Gauge::kLimitShare * value / limit, 0.0, 1.0)
                                             : Gauge::kNothing;
}

bool is_lost(const GaugeInput& in) {
  return in.scene && in.scene->measurement.state == CellState::kLost;
}

// What makes every number of the picture old; empty for nothing.
std::string age_alarm(const GaugeInput& in) {
  if (!in.scene || in.is_still || !(in.frame_age_s > in.limits.blind_age_s)) return {};
  return say("OLD: ") + readout::number(in.frame_age_s, 1) + " s";
}

void raise(Gauge& gauge, GaugeLevel level, std::string alarm) {
  gauge.level = level;
  gauge.alarm = std::move(alarm);
}

// The number against its limit.
void judge(Gauge& gauge, double value, double limit, double slow_ratio, const std::string& over) {
  if (!(limit > 0.0) || !std::isfinite(value)) return;
  if (value >= limit) {
    raise(gauge, GaugeLevel::kOver, over);
  } else if (value >= slow_ratio * limit) {
    raise(gauge, GaugeLevel::kNear, readout::number(100.0 * value / limit, 0) + say(" % OF LIMIT"));
  }
}

// A picture that shows no present, or no cell, is louder than any number.
void judge_picture(Gauge& gauge, const GaugeInput& in) {
  if (is_lost(in)) {
    raise(gauge, GaugeLevel::kNone, say("CELL LOST"));
  } else if (std::string old = age_alarm(in); !old.empty()) {
    raise(gauge, GaugeLevel::kNone, std::move(old));
  }
}

Gauge force_gauge(const GaugeInput& in) {
  Gauge gauge{.key = "force", .name = say("FORCE")};
  const Measurement m = in.scene ? in.scene->measurement : Measurement{};
  const double limit_uN = in.has_hand ? in.limits.max_force_uN : in.strength.puncture_force_uN;
  gauge.value = readout::force(m);
  gauge.limit = (in.has_hand ? say("limit ") : say("puncture ")) + with_unit(limit_uN, 1, "µN");
  gauge.limit_share = Gauge::kLimitShare;
  if (in.has_hand) gauge.usual_share = share_of(in.strength.puncture_force_uN, limit_uN);
  gauge.share = share_of(m.contact_force_uN, limit_uN);
  gauge.from = share_of(m.contact_force_lower_uN, limit_uN);
  gauge.to = share_of(m.contact_force_upper_uN, limit_uN);
  gauge.inner_from = share_of(m.contact_force_picture_lower_uN, limit_uN);
  gauge.inner_to = share_of(m.contact_force_picture_upper_uN, limit_uN);
  if (in.true_force_uN) {
    gauge.truth = say("true ") + readout::number(*in.true_force_uN, 2);
    gauge.truth_share = share_of(*in.true_force_uN, limit_uN);
  }
  // The number beside it has the unit.
  if (std::isfinite(gauge.from) && std::isfinite(gauge.to)) {
    gauge.note = "95 %: " + readout::number(m.contact_force_lower_uN, 2) + " \u2013 " +
                 readout::number(m.contact_force_upper_uN, 2);
  }
  judge(gauge, m.contact_force_uN, limit_uN, in.limits.slow_ratio,
        in.has_hand ? say("AT THE LIMIT") : say("PUNCTURE LIKELY"));
  if (in.scene && gauge.level == GaugeLevel::kCalm && !in.scene->remarks.warning.empty()) {
    raise(gauge, GaugeLevel::kDoubt, say("IN DOUBT"));
  }
  if (in.scene && !in.scene->remarks.reason.empty()) {
    raise(gauge, GaugeLevel::kNone, say("NO FORCE"));
    gauge.note = say("no force, see below");
  }
  judge_picture(gauge, in);
  return gauge;
}

// Of the tip beyond the entry; nothing without a plan or a tip.
std::optional<double> way_beyond_entry(const GaugeInput& in, const std::optional<Eigen::Vector3d>& tip_um) {
  if (!in.plan || !tip_um) return std::nullopt;
  return (*tip_um - in.plan->entry_um.eigen()).dot(in.plan->axis.eigen());
}

// A needle seen without a cell may be another tool: it is not measured against the plan.
const NeedlePose* needle_seen(const GaugeInput& in) {
  if (!in.scene || !in.scene->observation || !in.scene->observation->needle) return nullptr;
  const CellState state = in.scene->measurement.state.value_or(CellState::kNoCell);
  if (state == CellState::kNoCell || state == CellState::kLost) return nullptr;
  return &*in.scene->observation->needle;
}

// Where the tip is: as it is seen, else as the manipulator reports.
std::optional<Eigen::Vector3d> tip_of(const GaugeInput& in) {
  if (const NeedlePose* needle = needle_seen(in)) return Eigen::Vector3d(needle->tip_um.x(), needle->tip_um.y(), 0.0);
  return in.tip_um;
}

Gauge depth_gauge(const GaugeInput& in) {
  Gauge gauge{.key = "indentation", .name = say("DEPTH")};
  const Measurement m = in.scene ? in.scene->measurement : Measurement{};
  const bool is_inside = m.state == CellState::kPunctured;
  const auto inside_um = is_inside ? way_beyond_entry(in, tip_of(in)) : std::nullopt;
  const double depth_um = inside_um.value_or(m.indentation_um);
  const bool has_stop = in.has_hand && in.plan && in.depth_stop_um > 0.0;

  double limit_um = in.has_hand ? in.limits.max_depth_um : in.strength.puncture_depth_um;
  std::string what = in.has_hand ? say("limit ") : say("puncture ");
  if (has_stop && (is_inside || in.depth_stop_um < limit_um)) {
    limit_um = in.depth_stop_um;
    what = say("depth stop ");
  } else if (is_inside) {
    limit_um = 0.0;  // indentation is over
  }
  gauge.value = with_unit(depth_um, 1, "µm");
  if (!std::isfinite(depth_um)) gauge.value = readout::indentation(m);
  if (limit_um > 0.0) {
    gauge.limit = what + with_unit(limit_um, 0, "µm");
    gauge.limit_share = Gauge::kLimitShare;
    gauge.share = share_of(depth_um, limit_um);
    if (in.has_hand && !is_inside) gauge.usual_share = share_of(in.strength.puncture_depth_um, limit_um);
  }
  const double sigma_um = in.scene && in.scene->observation ? in.scene->observation->indentation_sigma_um : 0.0;
  if (inside_um) {
    gauge.note = say("tip beyond the entry");
  } else if (m.state == CellState::kContact && sigma_um > 0.0) {
    gauge.note = say("indentation ±") + with_unit(kNormal95 * sigma_um, 1, "µm");
    gauge.from = share_of(depth_um - kNormal95 * sigma_um, limit_um);
    gauge.to = share_of(depth_um + kNormal95 * sigma_um, limit_um);
  } else if (m.state == CellState::kFree) {
    gauge.note = say("not touched");
  }
  // The push slows this far before the limit.
  const double slow_ratio = limit_um > 0.0 ? std::max(0.0, 1.0 - in.limits.soft_depth_um / limit_um) : 1.0;
  judge(gauge, depth_um, limit_um, slow_ratio, say("AT THE LIMIT"));
  judge_picture(gauge, in);
  return gauge;
}

Gauge speed_gauge(const GaugeInput& in) {
  Gauge gauge{.key = "speed", .name = say("SPEED")};
  const double speed = in.speed_um_per_s.value_or(Gauge::kNothing);
  gauge.value = with_unit(std::abs(speed), 0, "µm/s");
  const bool is_touching = in.scene && in.scene->measurement.state == CellState::kContact;
  if (in.has_hand) {
    const double limit = is_touching ? in.limits.max_contact_speed_um_per_s : in.limits.max_speed_um_per_s;
    gauge.limit = say("limit ") + with_unit(limit, 0, "µm/s");
    gauge.limit_share = Gauge::kLimitShare;
    gauge.share = share_of(std::abs(speed), limit);
  } else {
    gauge.limit = say("no hand, no limit");
  }
  if (!std::isfinite(speed)) {
    gauge.value = "\u2013";
    gauge.note = in.scene ? say("no needle in sight") : "";
  } else if (std::abs(speed) < kAtRest_um_per_s) {
    gauge.value = "0 µm/s";
    gauge.note = say("at rest");
  } else {
    gauge.note = speed > 0.0 ? say("forwards") : say("backwards");
    // No alarm: the guards keep it there, and planned ways run at it.
    if (gauge.share >= Gauge::kLimitShare) gauge.note += say(", at its limit");
  }
  return gauge;
}

Gauge distance_gauge(const GaugeInput& in) {
  Gauge gauge{.key = "distance", .name = say("TO TARGET"), .value = "\u2013"};
  if (!in.plan) {
    gauge.note = in.has_hand ? say("no plan yet") : say("no plan without a hand");
    return gauge;
  }
  const InjectionPlan& plan = *in.plan;
  const double whole_um = plan.options.approach_distance_um + plan.depth_um;
  // The bar fills as the tip comes nearer: its mark is the target, and its end as far beyond as it is long.
  const auto share_at = [&](double left_um) { return share_of(whole_um - left_um, whole_um); };
  gauge.limit = say("target");
  gauge.limit_share = Gauge::kLimitShare;
  if (in.depth_stop_um > plan.depth_um) gauge.usual_share = share_at(plan.depth_um - in.depth_stop_um);
  const auto beyond_um = way_beyond_entry(in, tip_of(in));
  if (!beyond_um) {
    raise(gauge, GaugeLevel::kNone, say("NEEDLE NOT SEEN"));
    return gauge;
  }
  const double left_um = plan.depth_um - *beyond_um;
  gauge.value = with_unit(std::abs(left_um), 1, "µm");
  gauge.note = left_um < 0.0 ? say("beyond the target") : "";
  gauge.share = share_at(left_um);
  const NeedlePose* needle = needle_seen(in);
  const double sigma_um = needle ? needle->tip_sigma_um : 0.0;
  if (sigma_um > 0.0) {
    gauge.from = share_at(left_um + kNormal95 * sigma_um);
    gauge.to = share_at(left_um - kNormal95 * sigma_um);
    gauge.note += (gauge.note.empty() ? "±" : ", ±") + with_unit(kNormal95 * sigma_um, 1, "µm");
  } else if (!needle) {
    gauge.note = say("by the manipulator");
  }
  if (in.depth_stop_um > 0.0 && *beyond_um > in.depth_stop_um) {
    raise(gauge, GaugeLevel::kOver, say("PAST THE DEPTH STOP"));
  }
  judge_picture(gauge, in);
  return gauge;
}

}  // namespace

std::array<Gauge, 4> make_gauges(const GaugeInput& input) {
  std::array gauges{force_gauge(input), depth_gauge(input), speed_gauge(input), distance_gauge(input)};
  gauges[0].tip =
      input.has_hand
          ? say("Force of the needle on the cell against the largest that the hand is let exert. Light band: the whole "
                "95 "
                "% "
                "interval; dark band: what the picture leaves open. Fine mark: where a cell of this kind and these "
                "sizes is expected to give way.")
          : say("Force of the needle on the cell against that at which a cell of this kind and these sizes is expected "
                "to give way. Light band: the "
                "whole "
                "95 % interval; dark band: what the picture leaves open.");
  gauges[1].tip =
      say("Indentation of the cell with its 95 % interval; once the membrane gave way, how far the tip is beyond the "
          "entry. "
          "The mark is the nearer of the hand's limit and the plan's depth stop.");
  gauges[2].tip = say(
      "Speed of the tip, as its manipulator reports it, else as it is seen. The mark is the largest speed of the hand: "
      "in "
      "contact, that of the push.");
  gauges[3].tip = say(
      "From the tip to the plan's target, along the planned way, with the 95 % interval of the tip. The mark is the "
      "target, the fine one beyond it the depth stop.");
  return gauges;
}

Eigen::Vector3d way_inwards(const InjectionPlan* plan, const Scene* scene) {
  if (plan) return plan->axis.eigen();
  if (!scene || !scene->observation || !scene->observation->needle) return Eigen::Vector3d::Zero();
  const Eigen::Vector2d& direction = scene->observation->needle->direction;
  return {direction.x(), direction.y(), 0.0};
}

std::optional<Eigen::Vector3d> TipSpeed::update(double time_s, const Eigen::Vector3d& tip_um) {
  const double elapsed_s = time_s - time_s_;
  if (tip_um_ && elapsed_s > 0.0) {
    const Eigen::Vector3d now = (tip_um - *tip_um_) / elapsed_s;
    const double part = elapsed_s / (elapsed_s + kSpeedMemory_s);
    velocity_um_per_s_ = velocity_um_per_s_ ? *velocity_um_per_s_ + part * (now - *velocity_um_per_s_) : now;
  }
  if (!tip_um_ || elapsed_s != 0.0) {
    tip_um_ = tip_um;
    time_s_ = time_s;
  }
  return velocity_um_per_s_;
}

std::optional<double> TipSpeed::update(double time_s, const Eigen::Vector3d& tip_um, const Eigen::Vector3d& way) {
  const auto velocity_um_per_s = update(time_s, tip_um);
  if (!velocity_um_per_s) return std::nullopt;
  return velocity_um_per_s->dot(way) < 0.0 ? -velocity_um_per_s->norm() : velocity_um_per_s->norm();
}

std::optional<double> TipSpeed::update(const Scene& scene) {
  if (!scene.observation || !scene.observation->needle) {
    forget();
    return std::nullopt;
  }
  const NeedlePose& needle = *scene.observation->needle;
  const auto velocity_um_per_s = update(scene.measurement.time_s, {needle.tip_um.x(), needle.tip_um.y(), 0.0});
  if (!velocity_um_per_s) return std::nullopt;
  return velocity_um_per_s->head<2>().dot(needle.direction);
}

void TipSpeed::forget() {
  tip_um_.reset();
  velocity_um_per_s_.reset();
}

bool Gauge::operator==(const Gauge& other) const {
  const auto texts = [](const Gauge& g) {
    return std::tie(g.key, g.name, g.value, g.note, g.limit, g.alarm, g.truth, g.tip, g.level);
  };
  const auto shares = [](const Gauge& g) {
    return std::array{g.share, g.from, g.to, g.inner_from, g.inner_to, g.limit_share, g.truth_share, g.usual_share};
  };
  const auto mine = shares(*this), others = shares(other);
  return texts(*this) == texts(other) && std::equal(mine.begin(), mine.end(), others.begin(), [](double a, double b) {
           return a == b || (std::isnan(a) && std::isnan(b));
         });
}

}  // namespace pellucida
