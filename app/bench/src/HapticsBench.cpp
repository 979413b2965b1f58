#include "pellucida/bench/HapticsBench.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <sstream>
#include <thread>

#include "pellucida/bench/DisplayBench.h"
#include "pellucida/core/Error.h"
#include "pellucida/haptics/DeviceCatalog.h"
#include "pellucida/operation/TeleoperationRun.h"
#include "pellucida/operation/VirtualInjectionSetup.h"
#include "pellucida/teleoperation/TeleoperationMap.h"

namespace pellucida {
namespace {

constexpr int kRoundCount = 3;
constexpr int kFifoPriority = 80;  // cyclictest's, and the loop's
constexpr auto kDrawPeriod = std::chrono::milliseconds(33);

// A Touch in a hand that goes to and fro along the needle, into the cell and out.
class PacingHand final : public HapticDevice {
 public:
  PacingHand(const PlainVector3& push, double way_m)
      : specification_(find_device("Touch")), push_H_(hand_from_world(push)), way_m_(way_m) {}
  const DeviceSpecification& specification() const noexcept override { return specification_; }
  bool read(double now_s, HandSample& sample) noexcept override {
    constexpr double kPeriod_s = 4.0;
    const double way_m = 0.5 * way_m_ * (1.0 - std::cos(2.0 * std::numbers::pi * now_s / kPeriod_s));
    sample.time_s = now_s;
    sample.position_m = PlainVector3(way_m * push_H_.eigen());
    return true;
  }
  bool write(const PlainVector3&) noexcept override { return true; }

 private:
  DeviceSpecification specification_;
  PlainVector3 push_H_;
  double way_m_;
};

// Runs a command to its end; its output, or nothing when it isn't there or fails.
std::optional<std::string> output_of(const std::string& command) {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  if (!pipe) return std::nullopt;
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe.get())) {
    text.append(buffer.data(), count);
  }
  if (pclose(pipe.release()) != 0) return std::nullopt;
  return text;
}

// Both sum up histograms of several rounds: cyclictest's bins are 1 us wide.
struct CyclictestRounds {
  std::string output;
  std::string policy;

  void run(double seconds) {
    const std::string common = " -i 1000 -h 20000 -q -D " + std::to_string(std::lround(std::max(1.0, seconds)));
    const std::string fifo = "-m -p " + std::to_string(kFifoPriority);
    // Without the right to it, as the loop does: normal priority.
    for (const auto& [options, name] : {std::pair{fifo, "SCHED_FIFO " + std::to_string(kFifoPriority)},
                                        std::pair{std::string("--policy=other"), std::string("normal priority")}}) {
      if (const auto text = output_of("cyclictest " + options + common + " 2>/dev/null")) {
        output += *text;
        policy = name;
        return;
      }
    }
  }
};

// What the loop did in all its turns.
struct LoopRounds {
  LatencyHistogram lateness;
  LatencyHistogram compute;
  std::uint64_t missed_count = 0;

  void run(TeleoperationRun& rig, double seconds) {
    rig.start();
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    rig.stop();
    lateness.add(rig.loop().lateness());
    compute.add(rig.loop().compute());
    missed_count += rig.loop().missed_count();
  }
};

// The thread that turns loop and cyclictest on and off while the main thread draws.
void take_turns(TeleoperationRun& rig, LoopRounds& loop, CyclictestRounds& cyclictest, double seconds,
                const std::atomic<bool>& given_up) {
  const bool compare = output_of("command -v cyclictest").has_value();
  const double turn_s = seconds / (compare ? 2.0 * kRoundCount : kRoundCount);
  for (int round = 0; round < kRoundCount && !given_up; ++round) {
    loop.run(rig, turn_s);
    if (compare) cyclictest.run(turn_s);
  }
}

}  // namespace

LatencySummary summarize_cyclictest(const std::string& output) {
  std::array<std::uint64_t, 20001> counts{};
  std::istringstream lines(output);
  std::uint64_t total = 0;
  std::size_t largest = 0;
  const auto add = [&](std::size_t us, std::uint64_t count) {
    us = std::min(us, counts.size() - 1);
    counts[us] += count;
    total += count;
    if (count > 0) largest = std::max(largest, us);
  };
  double max_us = 0.0;
  for (std::string line; std::getline(lines, line);) {
    unsigned long us = 0;
    unsigned long long count = 0;
    if (std::sscanf(line.c_str(), "# Max Latencies: %lu", &us) == 1) max_us = std::max(max_us, static_cast<double>(us));
    if (std::sscanf(line.c_str(), "# Histogram Overflows: %llu", &count) == 1) add(counts.size() - 1, count);
    if (!line.empty() && line[0] != '#' && std::sscanf(line.c_str(), "%lu %llu", &us, &count) == 2) add(us, count);
  }
  LatencySummary summary;
  summary.count = total;
  if (total == 0) return summary;
  const auto quantile_us = [&](double ratio) {
    const auto wanted = static_cast<std::uint64_t>(std::ceil(ratio * static_cast<double>(total)));
    std::uint64_t seen = 0;
    for (std::size_t us = 0; us < counts.size(); ++us) {
      seen += counts[us];
      if (seen >= wanted) return static_cast<double>(us);
    }
    return static_cast<double>(largest);
  };
  summary.p50_us = quantile_us(0.5);
  summary.p99_us = quantile_us(0.99);
  summary.p99_9_us = quantile_us(0.999);
  summary.p99_99_us = quantile_us(0.9999);
  summary.max_us = std::max(max_us, static_cast<double>(largest));
  return summary;
}

HapticsFigures measure_haptics(double seconds) {
  if (!(seconds >= 4.0)) throw UsageError("bench haptics: --seconds must be 4 or more, a second for each turn");
  VirtualInjectionSetup setup("injection");
  LiveRun run(setup.make_microscope(Pace::kWallClock), {});
  ContactTap contacts(run);

  TeleoperationMap map;
  const PlainVector3 push(-setup.needle().force().frame().axis.eigen());
  constexpr double kDepth_um = 25.0;
  PacingHand hand(push, (setup.scenario().motion.gap_um + kDepth_um) / map.scale_um_per_m());
  TeleoperationRun::Options options;
  options.haptics = default_settings(hand.specification(), map.scale_um_per_m());
  options.loop.priority = kFifoPriority;
  TeleoperationRun rig(run, contacts, hand, map, setup.injector(), options);

  LoopRounds loop;
  CyclictestRounds cyclictest;
  std::atomic<bool> done{false};
  std::atomic<bool> given_up{false};
  std::exception_ptr fault;
  run.start();
  std::jthread turns([&] {
    try {
      take_turns(rig, loop, cyclictest, seconds, given_up);
    } catch (...) {
      fault = std::current_exception();
    }
    done = true;
  });

  HapticsFigures figures;
  try {
    // As the window does: the newest scene, some thirty times a second.
    auto next_s = std::chrono::steady_clock::now();
    figures.display_frames_per_s = draw_scenes([&]() -> std::optional<Scene> {
      next_s = std::max(next_s + kDrawPeriod, std::chrono::steady_clock::now());
      std::this_thread::sleep_until(next_s);
      while (!done && !run.scenes()->peek()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
      if (done) return std::nullopt;
      return *run.scenes()->peek();
    });
  } catch (...) {
    given_up = true;
    throw;
  }
  turns.join();
  if (fault) std::rethrow_exception(fault);
  const double elapsed_s = run.clock().now_s();
  figures.pipeline_frames_per_s = static_cast<double>(run.status().measured_count) / elapsed_s;
  run.stop();

  figures.lateness_us = summarize(loop.lateness);
  figures.compute_us = summarize(loop.compute);
  figures.missed_count = loop.missed_count;
  figures.policy = rig.loop().real_time().text();
  if (!cyclictest.output.empty()) {
    figures.cyclictest = {summarize_cyclictest(cyclictest.output), cyclictest.policy};
  }
  return figures;
}

}  // namespace pellucida
