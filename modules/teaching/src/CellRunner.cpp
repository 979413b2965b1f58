#include "pellucida/teaching/CellRunner.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "pellucida/core/Clock.h"

namespace pellucida {
namespace {

constexpr double kPublishPeriod_s = 1.0 / 60.0;
// Computing in one go between two looks at the orders.
constexpr double kLongestWork_s = 0.012;
// A computer that is too slow falls behind the clock, and doesn't catch up.
constexpr double kMostOwed_s = 0.05;
constexpr double kCurvePeriod_s = 2e-3;
constexpr std::size_t kMostCurvePoints = 20000;
constexpr double kRatesPeriod_s = 0.5;
constexpr double kStabilityPeriod_s = 0.25;

const SteadyClock& runner_clock() {
  static const SteadyClock clock;
  return clock;
}

}  // namespace

CellRunner::CellRunner(const TeachingParameters& parameters) : cell_(parameters), curve_(kMostCurvePoints) {
  thread_ = std::jthread([this](std::stop_token stop) { run(stop); });
}

CellRunner::~CellRunner() = default;

template <class Change>
void CellRunner::order(Change change) {
  {
    const std::lock_guard lock(mutex_);
    change(orders_);
  }
  ordered_.notify_all();
}

void CellRunner::set_parameters(const TeachingParameters& parameters) {
  require_valid(parameters);
  order([&](Orders& orders) { orders.parameters = parameters; });
}
void CellRunner::set_hand(double along_um, double across_um) {
  order([&](Orders& orders) { orders.hand = Hand{along_um, across_um}; });
}
void CellRunner::restart() {
  order([](Orders& orders) { orders.restart = true; });
}
void CellRunner::set_paused(bool paused) {
  order([&](Orders& orders) { orders.paused = paused; });
}
void CellRunner::explain(std::optional<int> node) {
  order([&](Orders& orders) { orders.node = node; });
}

void CellRunner::rethrow() const {
  const std::lock_guard lock(mutex_);
  if (fault_) std::rethrow_exception(fault_);
}

void CellRunner::obey(const Orders& orders) {
  if (orders.parameters) {
    const auto* shape = cell_.mesh().get();
    const double before_s = cell_.time_s();
    cell_.set_parameters(*orders.parameters);
    if (cell_.mesh().get() != shape && cell_.time_s() < before_s) ++run_;
  }
  if (orders.hand) cell_.set_hand(orders.hand->along_um, orders.hand->across_um);
  if (orders.node) node_ = *orders.node;
  if (orders.paused) paused_ = *orders.paused;
  if (orders.restart) {
    cell_.restart();
    ++run_;
  }
}

void CellRunner::run(std::stop_token stop) {
  try {
    worked_until_s_ = rates_.since_s = runner_clock().now_s();
    while (!stop.stop_requested()) {
      const double begin_s = runner_clock().now_s();
      Orders orders;
      {
        const std::lock_guard lock(mutex_);
        orders = std::exchange(orders_, Orders{});
      }
      obey(orders);
      if (!paused_) work(begin_s);
      publish(runner_clock().now_s());

      // An ended or paused motion waits for orders; a running one for its next period.
      std::unique_lock lock(mutex_);
      const auto has_orders = [&] { return orders_.any(); };
      if (cell_.blow_up() || paused_) {
        ordered_.wait(lock, stop, has_orders);
        worked_until_s_ = runner_clock().now_s();
      } else {
        const double rest_s = kPublishPeriod_s - (runner_clock().now_s() - begin_s);
        ordered_.wait_for(lock, stop, std::chrono::duration<double>(std::max(0.0, rest_s)), [] { return false; });
      }
    }
  } catch (...) {
    const std::lock_guard lock(mutex_);
    fault_ = std::current_exception();
  }
}

void CellRunner::work(double now_s) {
  const TeachingParameters& parameters = cell_.parameters();
  const double dt_s = 1e-6 * parameters.time_step_us;
  const double most_s = std::max(kMostOwed_s * parameters.pace_ratio, dt_s);
  owed_s_ = std::min(owed_s_ + parameters.pace_ratio * (now_s - worked_until_s_), most_s);
  worked_until_s_ = now_s;
  while (owed_s_ >= dt_s && runner_clock().now_s() - now_s < kLongestWork_s && cell_.step()) {
    owed_s_ -= dt_s;
    rates_.simulated_s += dt_s;
    ++rates_.steps;
    record();
  }
  if (now_s - stability_renewed_s_ < kStabilityPeriod_s) return;
  stability_renewed_s_ = now_s;
  cell_.renew_stability();
}

void CellRunner::record() {
  const double since_s = cell_.time_s() - curve_time_s_;
  if (since_s >= 0.0 && since_s < kCurvePeriod_s) return;
  curve_time_s_ = cell_.time_s();
  curve_.push({run_, curve_time_s_, cell_.depth_um(), cell_.push_force_uN()});
}

std::vector<CurvePoint> CellRunner::take_curve() {
  std::vector<CurvePoint> points;
  for (std::size_t left = curve_.size(); left > 0; --left) points.push_back(curve_.wait({}).value());
  return points;
}

void CellRunner::publish(double now_s) {
  if (const double passed_s = now_s - rates_.since_s; passed_s >= kRatesPeriod_s) {
    rates_ = {.since_s = now_s,
              .steps_per_s = static_cast<double>(rates_.steps) / passed_s,
              .pace_ratio = rates_.simulated_s / passed_s};
  }
  CellSnapshot snapshot = snapshot_of(cell_, node_);
  snapshot.run = run_;
  snapshot.steps_per_s = rates_.steps_per_s;
  snapshot.pace_ratio = rates_.pace_ratio;
  snapshots_.publish(std::make_shared<const CellSnapshot>(std::move(snapshot)));
}

}  // namespace pellucida
