#pragma once
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "pellucida/core/Clock.h"
#include "pellucida/core/LatestValue.h"
#include "pellucida/teleoperation/Manipulator.h"

namespace pellucida {

struct ManipulatorStageOptions {
  double rate_Hz = 100.0;          ///< turns per second; the manipulator's own rate if that is lower
  double command_timeout_s = 0.1;  ///< without a newer command for this long the pipette is commanded to stop
  double reopen_after_s = 1.0;     ///< interval at which a lost manipulator is tried again
  /// Gets every report, on the stage's thread; may be empty.
  std::function<void(const PipetteState&)> report;
};

/// The work of the stage so far.
struct ManipulatorStageCounts {
  std::uint64_t command_count = 0;  ///< commands passed to the manipulator
  std::uint64_t hold_count = 0;     ///< times it was stopped because the commands ceased
  std::uint64_t lost_count = 0;     ///< times it was lost
  std::uint64_t reopen_count = 0;   ///< times it returned
  std::string last_fault;           ///< reason of the newest loss
};

/// Gives a manipulator a thread of its own at its own rate: takes the newest command of the 1 kHz loop, passes it on,
/// publishes the pipette's state. Both directions are wait-free for the loop.
///
/// When the loop falls silent the pipette is held; when the device is lost the state shows it (`known` false) and
/// opening is tried again; the pipette then stays until a command newer than the return arrives.
class ManipulatorStage {
 public:
  /// The manipulator and the clock must outlive the stage. Throws UsageError for a rate or a time not above 0.
  ManipulatorStage(Manipulator& manipulator, const Clock& clock, const ManipulatorStageOptions& options = {});
  ~ManipulatorStage();
  ManipulatorStage(const ManipulatorStage&) = delete;
  ManipulatorStage& operator=(const ManipulatorStage&) = delete;

  /// Opens the manipulator (throws as its `open`) and starts the thread.
  void start();

  /// Ends the thread, stops the pipette, closes the manipulator.
  void stop();

  /// Writer: the 1 kHz loop alone.
  LatestValue<PipetteCommand>& commands() noexcept { return commands_; }

  /// Reader: the 1 kHz loop alone.
  LatestValue<PipetteState>& states() noexcept { return states_; }

  /// For all others: any thread, takes a lock.
  PipetteState newest_state() const;
  ManipulatorStageCounts counts() const;

  /// One turn of the thread, for tests without `start`; the manipulator must be open.
  void turn();

 private:
  void run(std::stop_token stop);
  void serve(double now_s);
  void reopen(double now_s);
  void lose(const std::string& reason, double now_s);
  void publish(const PipetteState& state);

  Manipulator& manipulator_;
  const Clock& clock_;
  ManipulatorStageOptions options_;
  LatestValue<PipetteCommand> commands_;
  LatestValue<PipetteState> states_;

  // The stage's thread alone.
  double command_seen_s_ = 0.0;  ///< when the newest command was taken
  double try_again_s_ = 0.0;     ///< when opening is tried next
  bool has_command_ = false;     ///< one has arrived since the manipulator was opened
  bool held_ = false;

  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  PipetteState newest_;
  ManipulatorStageCounts counts_;
  std::jthread thread_;
};

}  // namespace pellucida
