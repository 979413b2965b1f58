#pragma once
#include <cstdint>

#include "pellucida/core/LatestValue.h"
#include "pellucida/haptics/HapticDevice.h"
#include "pellucida/teleoperation/HandSmoother.h"
#include "pellucida/teleoperation/TouchCue.h"

namespace pellucida {

struct MouseHandOptions {
  double m_per_px = 0.0001;         ///< hand motion per pixel of the pointer
  double m_per_notch = 0.0005;      ///< of the wheel
  double steer_m_per_s = 0.01;      ///< hand speed while a key is held
  double workspace_radius_m = 0.2;  ///< the hand stays within
  /// Contact stiffness at the hand that halves the motion seen for a motion made. Pseudo-haptics after Lecuyer et al.
  /// (IEEE VR 2000): a control/display ratio that follows the stiffness is perceived as resistance.
  double half_ratio_N_per_m = 100.0;
};

/// Mouse and keyboard as a device for the hand. The window's thread feeds it, wait-free; the 1 kHz thread reads. The
/// pointer moves the hand in the image plane, the wheel along the depth, keys in any direction. It gives no force: in
/// contact the hand moves less along the force, the stiffer the cell is, so the resistance is visible. The steps of its
/// events are smoothed (HandSmoother), which costs 10 ms.
class MouseHand final : public HapticDevice, public TouchCueDevice {
 public:
  /// Throws UsageError for a number not above 0.
  explicit MouseHand(const MouseHandOptions& options = {});

  // The window's thread, all of these.

  /// The pointer moved on the screen: right, down.
  void move_px(double dx, double dy) noexcept;

  /// The wheel turned; away from the user is above 0 and moves into the scene.
  void turn_wheel(double notches) noexcept;

  /// The keys held now, as a direction of frame H, each part within -1..1; zero when none is held.
  void steer(const PlainVector3& direction) noexcept;

  void press(HandButton button) noexcept;
  void release(HandButton button) noexcept;

  /// The window lost the focus: no key or button is held any more.
  void release_all() noexcept;

  /// The window closes (or returns): `read` then reports the device as lost (or present).
  void set_connected(bool connected) noexcept;

  // The 1 kHz thread.

  const DeviceSpecification& specification() const noexcept override { return specification_; }
  bool read(double now_s, HandSample& sample) noexcept override;

  /// A mouse gives no force; false when it is lost.
  bool write(const PlainVector3& force_N) noexcept override;
  void show(const TouchCue& cue) noexcept override;

  /// Motion seen for a motion made along the force, 0..1; 1 when free.
  double motion_ratio() const noexcept { return ratio_; }

 private:
  /// Everything so far, as totals, so that a late reader misses no motion.
  struct Input {
    double x_px = 0.0, y_px = 0.0, wheel = 0.0;
    PlainVector3 steer;
    std::uint32_t buttons = 0;
    bool connected = true;
  };
  void publish() noexcept { inputs_.publish(input_); }

  MouseHandOptions options_;
  DeviceSpecification specification_;
  Input input_;  ///< the window's thread
  LatestValue<Input> inputs_;
  LatestValue<TouchCue> cues_;

  // The 1 kHz thread.
  Input seen_;
  PlainVector3 goal_m_;  ///< the sum of the events
  HandSmoother smoother_;
  double last_read_s_ = -1.0;
  double ratio_ = 1.0;
};

}  // namespace pellucida
