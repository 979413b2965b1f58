#pragma once
#include <string>

namespace pellucida::hdapi {

/// What the driver says of its last call.
struct ErrorInfo {
  unsigned int code;
  int internal_code;
  unsigned int device;
};

// The driver's constants, as public programs that call it give them (docs/devices.md).
inline constexpr unsigned int kSuccess = 0x0000;
inline constexpr unsigned int kInvalidHandle = 0xffffffffu;
inline constexpr unsigned int kCallbackDone = 0;
inline constexpr unsigned int kCallbackContinue = 1;
inline constexpr unsigned short kHighestPriority = 65535;
inline constexpr unsigned int kCurrentButtons = 0x2000;
inline constexpr unsigned int kCurrentPosition = 0x2050;  ///< 3 numbers, mm
inline constexpr unsigned int kCurrentVelocity = 0x2051;  ///< 3 numbers, mm/s
inline constexpr unsigned int kModelType = 0x2501;
inline constexpr unsigned int kUsableWorkspace = 0x2551;     ///< 6 numbers, mm: least x y z, largest x y z
inline constexpr unsigned int kMaxStiffness = 0x2602;        ///< N/mm
inline constexpr unsigned int kMaxForce = 0x2603;            ///< N
inline constexpr unsigned int kMaxContinuousForce = 0x2604;  ///< N
inline constexpr unsigned int kMaxDamping = 0x2609;          ///< N/(mm/s)
inline constexpr unsigned int kCurrentForce = 0x2700;        ///< 3 numbers, N
inline constexpr unsigned int kForceOutput = 0x4000;

/// The entry points of the driver's library we call, found when the program runs. Our own declarations: the maker's
/// headers are neither needed nor used.
class EntryPoints {
 public:
  using Callback = unsigned int (*)(void*);

  /// Throws DeviceError: the library is not there, or lacks an entry point.
  explicit EntryPoints(const std::string& library);
  ~EntryPoints();
  EntryPoints(const EntryPoints&) = delete;
  EntryPoints& operator=(const EntryPoints&) = delete;

  unsigned int (*init_device)(const char* name) = nullptr;
  void (*disable_device)(unsigned int device) = nullptr;
  void (*make_current)(unsigned int device) = nullptr;
  void (*enable)(unsigned int what) = nullptr;
  void (*begin_frame)(unsigned int device) = nullptr;
  void (*end_frame)(unsigned int device) = nullptr;
  void (*get_doubles)(unsigned int name, double* into) = nullptr;
  void (*get_integers)(unsigned int name, int* into) = nullptr;
  const char* (*get_string)(unsigned int name) = nullptr;
  void (*set_doubles)(unsigned int name, const double* values) = nullptr;
  ErrorInfo (*get_error)() = nullptr;
  const char* (*get_error_string)(unsigned int code) = nullptr;
  unsigned long (*schedule_asynchronous)(Callback callback, void* data, unsigned short priority) = nullptr;
  void (*unschedule)(unsigned long callback) = nullptr;
  void (*start_scheduler)() = nullptr;
  void (*stop_scheduler)() = nullptr;

 private:
  void* library_ = nullptr;
};

}  // namespace pellucida::hdapi
