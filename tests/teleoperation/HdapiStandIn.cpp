// A stand-in for the maker's library: the entry points Pellucida calls, a scheduler that runs when told to, and a few
// functions through which a test plays the hardware. Behaves as the driver documents, and misbehaves on request.
#include <atomic>
#include <mutex>
#include <thread>

namespace {

struct ErrorInfo {
  unsigned int code;
  int internal_code;
  unsigned int device;
};
using Callback = unsigned int (*)(void*);

std::mutex mutex;
double position_mm[3], velocity_mm_per_s[3], force_N[3];
int buttons = 0;
bool plugged = true, in_frame = false, enabled = false;
unsigned int pending_error = 0;
Callback callback = nullptr;
void* callback_data = nullptr;
std::atomic<bool> ticking{true};
std::atomic<unsigned long> tick_count{0};
std::jthread scheduler;

}  // namespace

extern "C" {

unsigned int hdInitDevice(const char* name) {
  std::lock_guard lock(mutex);
  pending_error = 0;
  if (plugged && (!name || name[0] == 'D')) return 1;
  pending_error = 0x0301;
  return 0xffffffffu;
}
void hdDisableDevice(unsigned int) {}
void hdMakeCurrentDevice(unsigned int) {}
void hdEnable(unsigned int what) {
  std::lock_guard lock(mutex);
  enabled = what == 0x4000;
}
void hdBeginFrame(unsigned int) {
  std::lock_guard lock(mutex);
  in_frame = true;
  if (!plugged) pending_error = 0x0302;
}
void hdEndFrame(unsigned int) {
  std::lock_guard lock(mutex);
  in_frame = false;
}
void hdGetDoublev(unsigned int name, double* into) {
  std::lock_guard lock(mutex);
  const double workspace_mm[6] = {-80.0, -60.0, -35.0, 80.0, 60.0, 40.0};
  for (int i = 0; i < 3; ++i) {
    if (name == 0x2050 && in_frame) into[i] = position_mm[i];
    if (name == 0x2051 && in_frame) into[i] = velocity_mm_per_s[i];
  }
  for (int i = 0; i < 6 && name == 0x2551; ++i) into[i] = workspace_mm[i];
  if (name == 0x2602) *into = 0.5;
  if (name == 0x2603) *into = 3.3;
  if (name == 0x2604) *into = 0.88;
  if (name == 0x2609) *into = 0.002;
}
void hdGetIntegerv(unsigned int name, int* into) {
  std::lock_guard lock(mutex);
  if (name == 0x2000 && in_frame) *into = buttons;
}
const char* hdGetString(unsigned int name) {
  return name == 0x2501 ? "Stand-in Touch" : "";
}
void hdSetDoublev(unsigned int name, const double* values) {
  std::lock_guard lock(mutex);
  for (int i = 0; i < 3 && name == 0x2700 && in_frame && enabled; ++i) force_N[i] = values[i];
}
ErrorInfo hdGetError() {
  std::lock_guard lock(mutex);
  const ErrorInfo info{pending_error, 0, 1};
  pending_error = 0;
  return info;
}
const char* hdGetErrorString(unsigned int code) {
  return code == 0x0302 ? "Communication error" : "Device fault";
}
unsigned long hdScheduleAsynchronous(Callback function, void* data, unsigned short) {
  callback = function;
  callback_data = data;
  return 7;
}
void hdUnschedule(unsigned long) {
  callback = nullptr;
}
void hdStartScheduler() {
  scheduler = std::jthread([](std::stop_token stop) {
    while (!stop.stop_requested()) {
      if (ticking && callback && callback(callback_data) == 0) return;
      ++tick_count;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
}
void hdStopScheduler() {
  scheduler.request_stop();
  if (scheduler.joinable()) scheduler.join();
}

// The hardware, for the test.
void stand_in_place(double x_mm, double y_mm, double z_mm, int held_buttons) {
  std::lock_guard lock(mutex);
  position_mm[0] = x_mm;
  position_mm[1] = y_mm;
  position_mm[2] = z_mm;
  velocity_mm_per_s[0] = 10.0;
  buttons = held_buttons;
}
void stand_in_force(double* into_N) {
  std::lock_guard lock(mutex);
  for (int i = 0; i < 3; ++i) into_N[i] = force_N[i];
}
void stand_in_plug(bool in) {
  std::lock_guard lock(mutex);
  plugged = in;
}
void stand_in_tick(bool on) {
  ticking = on;
}

}  // extern "C"
