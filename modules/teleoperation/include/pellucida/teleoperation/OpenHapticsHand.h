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

/// A Touch, Touch X or Phantom through the maker's HDAPI (OpenHaptics), which is loaded when the program runs: nothing
/// of it is needed to build, and nothing of it is in here.
///
/// The driver's own 1 kHz scheduler calls back; each call reads position, velocity and buttons and sets the newest
/// force. `read` and `write` meet it through wait-free exchanges, so a force is felt one tick later. A force older than
/// 20 ms is let go: a loop that died does not push. First button: clutch; second: inject.
class OpenHapticsHand final : public HapticDevice {
 public:
  /// Throws DeviceError: library not there (and how to get it), entry point missing, no device (with the driver's
  /// words).
  explicit OpenHapticsHand(const OpenHapticsOptions& options = {});
  ~OpenHapticsHand() override;
  OpenHapticsHand(const OpenHapticsHand&) = delete;
  OpenHapticsHand& operator=(const OpenHapticsHand&) = delete;

  /// From the driver: forces, stiffness, damping, workspace. Its physical damping is not known.
  const DeviceSpecification& specification() const noexcept override { return specification_; }

  /// False once the driver reported a fault, gave numbers that are none, or fell silent for 0.1 s. A device that was
  /// lost stays lost: make a new one.
  bool read(double now_s, HandSample& sample) noexcept override;
  bool write(const PlainVector3& force_N) noexcept override;

  /// What the driver said when the device was lost; empty before. Any thread but the 1 kHz thread.
  std::string fault() const;

 private:
  struct Driver;
  std::unique_ptr<Driver> driver_;
  DeviceSpecification specification_;

  // The 1 kHz thread.
  double heard_s_ = 0.0;
  bool read_once_ = false;
};

/// Why no HDAPI device can be reached, as far as it can be told without opening one; empty when the library is there.
std::string open_haptics_trouble(const std::string& library = "libHD.so");

}  // namespace pellucida
