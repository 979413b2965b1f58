#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/operation/TeleoperationRun.h"
#include "pellucida/planning/InjectionPlan.h"
#include "pellucida/simulation/CommandedNeedle.h"
#include "pellucida/simulation/OperatorOptions.h"

namespace pellucida {

class Demonstration;
class HandCatalog;
class HandEngagement;
class HomingHand;
class InjectionGuide;

/// The hand on a live run, as a window needs it: what moves the pipette, the plan and the guide, the emergency stop.
/// Makes the plan by itself once an untouched cell is seen. The limits of force and depth come from the run's profile
/// and, once it was measured, from the cell's own scale. One thread (the window's) for all calls but the emergency
/// stop.
class OperatorConsole {
 public:
  struct Options {
    HapticLoopOptions loop;
    double rest_s = 4.0;     ///< between a demonstration's end and the next cell
    std::uint64_t seed = 1;  ///< of the simulated operator
  };

  /// `needle`: the virtual needle that the manipulator carries; without one the cell is real, and there is no
  /// demonstration and no new cell. All must outlive the console; the run is not started yet. Nothing moves the pipette
  /// until `choose`.
  OperatorConsole(LiveRun& run, Manipulator& manipulator, CommandedNeedle* needle, const Options& options);
  OperatorConsole(LiveRun& run, Manipulator& manipulator, CommandedNeedle* needle = nullptr);
  ~OperatorConsole();
  OperatorConsole(const OperatorConsole&) = delete;
  OperatorConsole& operator=(const OperatorConsole&) = delete;

  /// The hands available, UTF-8: the demonstration (a simulated operator), mouse and keyboard, devices found.
  const std::vector<std::string>& hands() const noexcept;
  /// Index of the first hand whose name starts with `start`; nothing when there is none.
  std::optional<int> find_hand(std::string_view start) const noexcept;
  int chosen() const noexcept { return chosen_; }  ///< -1: none yet
  bool is_demonstration() const noexcept;
  bool is_mouse() const noexcept;

  /// Another hand takes the pipette; the previous one is released first. If a device can't be opened, the pipette stays
  /// where it is, and the status gives the reason. Throws UsageError for an index out of range.
  void choose(int index);

  /// Motion of the tip per motion of the hand: coarse, fine, finest. Throws UsageError for an index out of range.
  static const std::vector<std::string>& scales();
  void scale(int index);
  int scale() const noexcept { return scale_; }

  /// Keeps the tip on the planned line, or not. The depth stop and the holding pipette act in any case.
  void guide(bool on);
  bool guided() const noexcept;
  /// The cell's force on the hand, or none; what protects cell and needle acts in any case. On at the start.
  void haptics(bool on);
  bool haptics() const noexcept { return haptics_; }
  /// Beyond the entry, um, above 0; from the plan until one is set. Throws UsageError.
  void depth_stop_um(double depth_um);
  double depth_stop_um() const noexcept;

  /// Where to deposit, in the image's plane, um. Takes effect at once while the cell is untouched, else with the next
  /// cell. Returns the reason if not, or that it has to wait; nothing when the plan leads there.
  std::optional<std::string> set_target(double x_um, double y_um);
  const std::optional<InjectionPlan>& plan() const noexcept;
  /// Whether another target takes effect at once: the cell is untouched, and no demonstration has begun on it.
  bool may_replan() const;

  // Held by the user; released by `release_all`, when the window loses the focus.
  void inject(bool held) noexcept;
  void retract(bool held) noexcept;
  void release_all() noexcept;

  // Mouse and keyboard; nothing for other hands.
  void grip(bool held) noexcept;  ///< the needle follows the mouse while held
  void move_px(double dx, double dy) noexcept;
  void turn_wheel(double notches) noexcept;

  /// Takes the needle out along its axis, then replaces the cell by an intact one. A needle that is out of view then
  /// comes back to where it was at the start. No effect on a real cell.
  void new_cell();
  bool can_renew() const noexcept { return needle_ != nullptr; }

  /// Any thread, at any time: from the next tick on the pipette is held and the hand released. Latched, also over a
  /// change of hands.
  void emergency_stop() noexcept;
  /// To be called on an explicit wish only.
  void release_emergency_stop() noexcept;

  /// To be called from the window's tick, ten times a second or more: evaluates the newest frame.
  void update();

  /// What the cell in view bears, by the profile, its sizes and its own scale.
  CellStrength strength() const noexcept;
  /// What the hand at work is held to, by plan and strength; before there is one, the limits of the strength.
  CellLimits limits() const;

  HandStatus status();
  /// The current activity in a few words; empty when there is none.
  std::string doing() const;

 private:
  void open();
  void engage();
  HapticSettings settings() const;
  void apply_settings();
  void look();
  void follow_strength(const Measurement& seen);
  void make_plan(const ContactModel& contact);
  void show_operator();
  void renew();
  bool is_out_of_view(const PlainVector3& tip_um) const noexcept;
  bool lead_home();
  bool follow_home();
  Modality modality() const noexcept;
  void repeat_demonstration();
  bool tip_is_out();
  void set_buttons() noexcept;

  LiveRun& run_;
  CommandedNeedle* needle_;
  std::unique_ptr<HandCatalog> catalog_;
  std::unique_ptr<InjectionGuide> guide_;
  std::unique_ptr<Demonstration> demonstration_;
  std::unique_ptr<HandEngagement> hand_;

  int chosen_ = -1, scale_ = 0;
  std::string trouble_;  // one line; empty when there is none
  bool inject_ = false, retract_ = false, grip_ = false, renewing_ = false, haptics_ = true;
  HomingHand* homing_ = nullptr;  // the hand's device, while it leads the needle back
  double homing_since_s_ = 0.0;
  long frame_index_ = -1;
  std::optional<CellStrength> strength_;  // of the cell seen last; none yet: its kind's
  bool broken_ = false;                   // the newest frame shows the membrane closed around the shaft
};

}  // namespace pellucida
