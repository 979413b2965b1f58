#pragma once
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

#include "pellucida/core/Ring.h"
#include "pellucida/core/SharedLatest.h"
#include "pellucida/teaching/CellSnapshot.h"
#include "pellucida/teaching/PokedCell.h"

namespace pellucida {

using CellSnapshotPtr = std::shared_ptr<const CellSnapshot>;

/// Gives a poked cell a thread of its own that steps it along with the clock, as far as the machine keeps up, and
/// publishes what it is like sixty times a second. Commands may come from any thread and act before the next step;
/// of several of a kind the last one acts.
class CellRunner {
 public:
  /// Starts at once. Throws UsageError for parameters that are not valid.
  explicit CellRunner(const TeachingParameters& parameters);
  ~CellRunner();
  CellRunner(const CellRunner&) = delete;
  CellRunner& operator=(const CellRunner&) = delete;

  /// See PokedCell. Throws UsageError for parameters that are not valid.
  void set_parameters(const TeachingParameters& parameters);
  void set_hand(double along_um, double across_um);
  void restart();
  /// While it is paused the cell's time stands still; orders act all the same.
  void set_paused(bool paused);
  /// The node whose forces the snapshots explain; nothing for none.
  void explain(std::optional<int> node);

  /// The newest snapshot; null before the first.
  CellSnapshotPtr newest() const { return snapshots_.peek().value_or(nullptr); }
  std::uint64_t sequence() const { return snapshots_.sequence(); }
  /// The points of the force curve since the last call, 2 ms of simulated time apart or a time step, whichever is
  /// longer; the first 20000 of them. One thread at a time.
  std::vector<CurvePoint> take_curve();
  /// Throws what the thread threw, if it did.
  void rethrow() const;

 private:
  struct Hand {
    double along_um = 0.0;
    double across_um = 0.0;
  };
  struct Orders {
    std::optional<TeachingParameters> parameters;
    std::optional<Hand> hand;
    bool restart = false;
    std::optional<bool> paused;
    std::optional<std::optional<int>> node;
    bool any() const { return parameters || hand || restart || paused || node; }
  };
  /// Work done since the rates were last worked out.
  struct Rates {
    double since_s = 0.0;
    double simulated_s = 0.0;
    std::uint64_t steps = 0;
    double steps_per_s = 0.0;
    double pace_ratio = 0.0;
  };

  template <class Change>
  void order(Change change);
  void obey(const Orders& orders);
  void run(std::stop_token stop);
  void work(double now_s);
  void record();
  void publish(double now_s);

  PokedCell cell_;
  SharedLatest<CellSnapshotPtr> snapshots_;
  Ring<CurvePoint> curve_;
  double curve_time_s_ = 0.0;  // of its newest point
  std::optional<int> node_;
  bool paused_ = false;
  std::uint64_t run_ = 0;
  double owed_s_ = 0.0;  // simulated time behind the clock
  double worked_until_s_ = 0.0;
  double stability_renewed_s_ = 0.0;
  Rates rates_;

  mutable std::mutex mutex_;
  std::condition_variable_any ordered_;
  Orders orders_;
  std::exception_ptr fault_;
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace pellucida
