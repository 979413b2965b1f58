#pragma once
#include <atomic>
#include <memory>
#include <string>

#include "pellucida/core/LatestValue.h"
#include "pellucida/haptics/HapticDevice.h"

namespace pellucida {

struct OpenHapticsOptions {
  std::string library = "libHD.so";  ///< as dlopen takes it: a name searched for, or a path
  std::string device;                ///< its name in the driver's setup; empty: the default device
};

/// A Touch, Touch X or Phantom through the maker's HDAPI (OpenHaptics), which is loaded at run time: nothing of it is
/// needed to build, and nothing of it is contained here.
///
/// The driver's own 1 kHz scheduler calls back; each call reads position, velocity and buttons and sets the newest
/// force. `read` and `write` communicate with it through wait-free exchanges, so a force is felt one tick later. A
/// force older than 20 ms is released: a loop that has failed does not push. First button: clutch; second: inject.
class OpenHapticsHand final : public HapticDevice {
 public:
  /// Throws DeviceError: library missing (and how to get it), entry point missing, no device (with the driver's
  /// message).
  explicit OpenHapticsHand(const OpenHapticsOptions& options = {});
  ~OpenHapticsHand() override;
  OpenHapticsHand(const OpenHapticsHand&) = delete;
  OpenHapticsHand& operator=(const OpenHapticsHand&) = delete;

  /// From the driver: forces, stiffness, damping, workspace. Its physical damping is unknown.
  const DeviceSpecification& specification() const noexcept override { return specification_; }

  /// False once the driver has reported a fault, returned numbers that are not finite, or been silent for 0.1 s. A lost
  /// device stays lost: a new object is needed.
  bool read(double now_s, HandSample& sample) noexcept override;
  bool write(const PlainVector3& force_N) noexcept override;

  /// The driver's message when the device was lost; empty before. Any thread but the 1 kHz thread.
  std::string fault() const;

 private:
  struct Driver;
  std::unique_ptr<Driver> driver_;
  DeviceSpecification specification_;

  // The 1 kHz thread.
  double heard_s_ = 0.0;
  bool read_once_ = false;
};

/// Why no HDAPI device can be reached, as far as can be determined without opening one; empty when the library is
/// present.
std::string open_haptics_trouble(const std::string& library = "libHD.so");

}  // namespace pellucida
