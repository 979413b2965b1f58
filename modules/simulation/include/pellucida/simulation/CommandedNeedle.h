#pragma once
#include <atomic>
#include <type_traits>

#include "pellucida/core/LatestValue.h"
#include "pellucida/simulation/NeedleDrive.h"

namespace pellucida {

/// A needle moved from outside: a 1 kHz thread sets the tip's position and gets the cell's response at once; the
/// microscope draws the newest state. One thread may call `move`, one other (the microscope's) `at`; `renew` may come
/// from any thread. `move` and `at` neither wait, allocate nor throw.
///
///     auto needle = std::make_shared<CommandedNeedle>(scenario);
///     VirtualMicroscope microscope(scenario, needle, Pace::kWallClock);   // into a LiveRun
///     ...                                                                 // meanwhile, in the 1 kHz thread:
///     const SpecimenMoment& moment = needle->move(time_s, tip_um, velocity_um_per_s, expelled_pL);
class CommandedNeedle : public NeedleDrive {
 public:
  /// The needle waits where the scenario's motion starts: `motion.gap_um` before the membrane, on the configuration's
  /// own line. Throws as VirtualSpecimen does.
  explicit CommandedNeedle(const Scenario& scenario);

  /// The tip is at `tip_um` (frame W, before the stage moved), and `expelled_pL` is the total it has expelled so far.
  /// `time_s` is the caller's monotonic clock, by which a broken membrane returns. The result is valid until the next
  /// call. A position or time that is not finite is ignored, and the last result is returned.
  const SpecimenMoment& move(double time_s, const PlainVector3& tip_um, const PlainVector3& velocity_um_per_s = {},
                             double expelled_pL = 0.0) noexcept;
  /// A new cell at the next `move`: intact and empty.
  void renew() noexcept { renew_wanted_.store(true, std::memory_order_release); }

  /// The response of the intact membrane at any position: any thread, real-time safe.
  const SpecimenForce& force() const noexcept { return force_; }
  /// Where the needle waits.
  const PlainVector3& start_um() const noexcept { return start_um_; }
  /// The axial force at which this cell punctures, uN; 0 when the scenario has no punctures.
  double puncture_force_uN() const noexcept { return puncture_force_uN_; }

  NeedleCommand at(double time_s) override;
  void restart() override { renew(); }
  std::optional<double> duration_s() const noexcept override { return std::nullopt; }

 private:
  struct Moved {
    PlainVector3 velocity_um_per_s;
    double expelled_pL = 0.0;
    SpecimenMoment moment;
  };
  static_assert(std::is_trivially_copyable_v<Moved>);

  SpecimenForce force_;
  PlainVector3 start_um_;
  double puncture_force_uN_ = 0.0;
  SpecimenContact contact_;  // the moving thread's
  SpecimenMoment waiting_;   // shown before the first move
  LatestValue<Moved> newest_;
  bool moved_ = false;  // the microscope's: a move has arrived
  std::atomic<bool> renew_wanted_{false};
};

}  // namespace pellucida
