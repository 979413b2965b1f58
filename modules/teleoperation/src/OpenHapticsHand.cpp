#include "pellucida/teleoperation/OpenHapticsHand.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "OpenHapticsEntryPoints.h"
#include "SteadyTime.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr double kLongestDriverSilence_s = 0.1;  // of the driver: a hundred of its ticks
constexpr double kForceValidFor_s = 0.02;        // a force that is not renewed is released
constexpr double kMPerMm = 0.001;

struct Reading {
  PlainVector3 position_m, velocity_m_per_s;
  std::uint32_t buttons = 0;
};

struct Force {
  PlainVector3 force_N;
  double until_s = -std::numeric_limits<double>::infinity();
};

}  // namespace

/// The driver's side: what its scheduler calls, and the exchanges with the 1 kHz thread.
struct OpenHapticsHand::Driver {
  explicit Driver(const OpenHapticsOptions& options) : entries(options.library) {
    device = entries.init_device(options.device.empty() ? nullptr : options.device.c_str());
    const hdapi::ErrorInfo error = entries.get_error();
    if (error.code != hdapi::kSuccess || device == hdapi::kInvalidHandle) {
      const std::string which = options.device.empty() ? "the default device" : "\"" + options.device + "\"";
      throw DeviceError("haptic device: the driver does not open " + which + " (" + text_of(error) +
                        "); check cable and power, and set it up with the driver's own tool");
    }
  }

  ~Driver() {
    if (running) {
      stopping.store(true, std::memory_order_release);
      entries.stop_scheduler();
      entries.unschedule(callback);
    }
    if (device != hdapi::kInvalidHandle) entries.disable_device(device);
  }

  void run() {
    entries.make_current(device);
    entries.enable(hdapi::kForceOutput);
    callback = entries.schedule_asynchronous(&Driver::tick, this, hdapi::kHighestPriority);
    entries.start_scheduler();
    running = true;
    if (const hdapi::ErrorInfo error = entries.get_error(); error.code != hdapi::kSuccess) {
      throw DeviceError("haptic device: the driver does not start (" + text_of(error) + ")");
    }
  }

  double number(unsigned int name) {
    double value = 0.0;
    entries.get_doubles(name, &value);
    return std::isfinite(value) && value > 0.0 ? value : 0.0;
  }

  std::string text_of(const hdapi::ErrorInfo& error) const {
    const char* text = entries.get_error_string(error.code);
    char code[32];
    std::snprintf(code, sizeof code, "0x%04x", error.code);
    return std::string(text && *text ? text : "no words") + ", " + code;
  }

  /// One tick of the driver's scheduler, on its thread.
  static unsigned int tick(void* self) {
    return static_cast<Driver*>(self)->tick() ? hdapi::kCallbackContinue : hdapi::kCallbackDone;
  }

  bool tick() noexcept {
    if (stopping.load(std::memory_order_acquire)) return false;
    double position_mm[3] = {}, velocity_mm_per_s[3] = {};
    int buttons = 0;
    entries.begin_frame(device);
    entries.get_doubles(hdapi::kCurrentPosition, position_mm);
    entries.get_doubles(hdapi::kCurrentVelocity, velocity_mm_per_s);
    entries.get_integers(hdapi::kCurrentButtons, &buttons);
    forces.refresh();
    const Force& newest = forces.value();
    // A device that was lost is not pushed any more.
    const bool valid = !lost.load(std::memory_order_relaxed) && steady_now_s() <= newest.until_s;
    const double force_N[3] = {valid ? newest.force_N.x : 0.0, valid ? newest.force_N.y : 0.0,
                               valid ? newest.force_N.z : 0.0};
    entries.set_doubles(hdapi::kCurrentForce, force_N);
    entries.end_frame(device);

    const hdapi::ErrorInfo error = entries.get_error();
    Reading reading;
    reading.position_m = {position_mm[0] * kMPerMm, position_mm[1] * kMPerMm, position_mm[2] * kMPerMm};
    reading.velocity_m_per_s = {velocity_mm_per_s[0] * kMPerMm, velocity_mm_per_s[1] * kMPerMm,
                                velocity_mm_per_s[2] * kMPerMm};
    if (buttons & 1) reading.buttons |= kClutch;
    if (buttons & 2) reading.buttons |= kInject;
    const bool sane = reading.position_m.eigen().allFinite() && reading.velocity_m_per_s.eigen().allFinite();
    if (error.code == hdapi::kSuccess && sane) {
      readings.publish(reading);
    } else if (!lost.load(std::memory_order_relaxed)) {
      // What is wrong is put into words later, by a thread that may take its time.
      first_fault.store(error.code != hdapi::kSuccess ? error.code : kNoNumbers, std::memory_order_release);
      lost.store(true, std::memory_order_release);
    }
    return true;
  }

  static constexpr unsigned int kNoNumbers = 0xffffffffu;  ///< our own: the position was not a number

  hdapi::EntryPoints entries;
  unsigned int device = hdapi::kInvalidHandle;
  unsigned long callback = 0;
  bool running = false;
  std::atomic<bool> stopping{false};
  std::atomic<bool> lost{false};
  std::atomic<unsigned int> first_fault{hdapi::kSuccess};
  LatestValue<Reading> readings;
  LatestValue<Force> forces;
};

OpenHapticsHand::OpenHapticsHand(const OpenHapticsOptions& options) : driver_(std::make_unique<Driver>(options)) {
  driver_->entries.make_current(driver_->device);
  const char* model = driver_->entries.get_string(hdapi::kModelType);
  specification_.name = model && *model ? model : "haptic device";
  specification_.max_force_N = driver_->number(hdapi::kMaxForce);
  specification_.max_continuous_force_N =
      std::min(driver_->number(hdapi::kMaxContinuousForce), specification_.max_force_N);
  // The driver speaks of N/mm.
  specification_.max_stiffness_N_per_m = driver_->number(hdapi::kMaxStiffness) / kMPerMm;
  specification_.max_damping_N_s_per_m = driver_->number(hdapi::kMaxDamping) / kMPerMm;
  double box_mm[6] = {};
  driver_->entries.get_doubles(hdapi::kUsableWorkspace, box_mm);
  double radius_mm = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) radius_mm = std::min({radius_mm, -box_mm[axis], box_mm[axis + 3]});
  specification_.workspace_radius_m = std::isfinite(radius_mm) ? std::max(radius_mm, 0.0) * kMPerMm : 0.0;
  specification_.source = "its driver (HDAPI)";
  driver_->run();
}

OpenHapticsHand::~OpenHapticsHand() = default;

bool OpenHapticsHand::read(double now_s, HandSample& sample) noexcept {
  if (driver_->readings.refresh() || !read_once_) heard_s_ = now_s;
  read_once_ = true;
  if (now_s - heard_s_ > kLongestDriverSilence_s) driver_->lost.store(true, std::memory_order_release);
  const bool lost = driver_->lost.load(std::memory_order_acquire);
  const Reading& reading = driver_->readings.value();
  sample.time_s = now_s;
  sample.position_m = reading.position_m;
  sample.velocity_m_per_s = reading.velocity_m_per_s;
  sample.velocity_known = true;
  sample.buttons = lost ? 0 : reading.buttons;
  return !lost;
}

bool OpenHapticsHand::write(const PlainVector3& force_N) noexcept {
  if (driver_->lost.load(std::memory_order_acquire)) return false;
  if (force_N.eigen().allFinite()) driver_->forces.publish({force_N, steady_now_s() + kForceValidFor_s});
  return true;
}

std::string OpenHapticsHand::fault() const {
  if (!driver_->lost.load(std::memory_order_acquire)) return {};
  const unsigned int code = driver_->first_fault.load(std::memory_order_acquire);
  if (code == hdapi::kSuccess) return "the driver fell silent; check cable and power";
  if (code == Driver::kNoNumbers) return "the driver gave a position that is not a number";
  return driver_->text_of({code, 0, driver_->device});
}

std::string open_haptics_trouble(const std::string& library) {
  try {
    hdapi::EntryPoints entries(library);
  } catch (const DeviceError& error) {
    return error.what();
  }
  return {};
}

}  // namespace pellucida
