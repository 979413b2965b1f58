#include "LiveClock.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

namespace pellucida {
namespace {

constexpr double kFitPeriod_s = 1.0;

}  // namespace

void LiveClock::add(double source_s, double run_s) {
  if (!live_) {
    lag_s_ = std::min(lag_s_.load(), run_s - source_s);
    return;
  }
  const std::lock_guard lock(mutex_);
  pairs_.add(source_s, run_s);
  if (source_s >= next_fit_s_) {
    next_fit_s_ = source_s + kFitPeriod_s;
    fit_ = pairs_.fit();
  }
  // Until the line is known, the least delay seen.
  lag_s_ = fit_ ? fit_->run_s(source_s) - source_s : std::min(lag_s_.load(), run_s - source_s);
}

void LiveClock::begin_anew() {
  lag_s_ = std::numeric_limits<double>::infinity();
  const std::lock_guard lock(mutex_);
  pairs_ = {};
  fit_.reset();
  next_fit_s_ = 0.0;
}

std::map<std::string, double> LiveClock::offsets(double run_now_s) const {
  const double lag_s = lag_s_;
  if (!std::isfinite(lag_s)) return {};
  const double unix_s = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  return {{"run", lag_s}, {"unix", unix_s - (run_now_s - lag_s)}};
}

std::string LiveClock::json() const {
  const std::lock_guard lock(mutex_);
  if (pairs_.pairs().empty()) return {};
  nlohmann::ordered_json json = {{"session", "source"}, {"hand", "run"}, {"injector", "run"}};
  if (const auto fit = pairs_.fit()) {
    json["source_to_run"] = {{"offset_s", fit->offset_s},
                             {"drift_ppm", fit->drift_ppm},
                             {"drift_sigma_ppm", fit->drift_sigma_ppm},
                             {"scatter_s", fit->scatter_s},
                             {"pair_count", fit->pair_count}};
  }
  auto& list = json["pairs_source_s_run_s"] = nlohmann::ordered_json::array();
  for (const auto& pair : pairs_.pairs()) list.push_back({pair.device_s, pair.run_s});
  return json.dump();
}

}  // namespace pellucida
