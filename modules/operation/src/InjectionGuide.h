#pragma once
#include <optional>
#include <string>

#include "pellucida/haptics/HapticSettings.h"
#include "pellucida/planning/InjectionPlan.h"

namespace pellucida {

/// The plan the hand is guided by, made from sure frames of an untouched cell, with the target, the depth stop and the
/// guide as they were chosen.
class InjectionGuide {
 public:
  const std::optional<InjectionPlan>& plan() const noexcept { return plan_; }

  /// The next frame. True when the cell has been seen untouched, and surely, long enough for a plan.
  bool see(const ContactModel& contact) noexcept;
  /// A plan through the target chosen, or the cell's centre. What is wrong where there is none; the plan before stays.
  std::optional<std::string> make(const ContactModel& contact);
  /// There is another cell.
  void drop() noexcept;

  /// The place to deposit, kept relative to the cell's centre, for the next plan. Why not, where no plan leads there.
  std::optional<std::string> set_target(double x_um, double y_um);

  void guide(bool on) noexcept { guided_ = on; }
  bool guided() const noexcept { return guided_; }
  /// Behind the entry, um, above 0. Throws UsageError.
  void depth_stop_um(double depth_um);
  /// 0: no plan yet, and none was set.
  double depth_stop_um() const noexcept;

  /// The settings with the plan's fixtures, as far as they are on.
  HapticSettings apply(const HapticSettings& settings) const noexcept;

 private:
  std::optional<InjectionPlan> plan_;
  std::optional<PlainVector3> target_offset_um_;  // from the cell's centre
  std::optional<double> depth_stop_um_;
  bool guided_ = true;
  int free_count_ = 0;  // frames in a row that show an untouched cell
};

}  // namespace pellucida
