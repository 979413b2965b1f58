#include "OpenHapticsEntryPoints.h"

#include <dlfcn.h>

#include "pellucida/core/Error.h"

namespace pellucida::hdapi {

EntryPoints::EntryPoints(const std::string& library) {
  library_ = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library_) {
    throw DeviceError("haptic device: the library " + library + " can't be loaded (" + dlerror() +
                      "); install the maker's OpenHaptics and device driver for Linux");
  }
  const auto find = [&](auto& entry, const char* name) {
    entry = reinterpret_cast<std::remove_reference_t<decltype(entry)>>(dlsym(library_, name));
    if (entry) return;
    dlclose(library_);
    throw DeviceError("haptic device: the library " + library + " has no entry point " + name +
                      "; it is not OpenHaptics 3");
  };
  find(init_device, "hdInitDevice");
  find(disable_device, "hdDisableDevice");
  find(make_current, "hdMakeCurrentDevice");
  find(enable, "hdEnable");
  find(begin_frame, "hdBeginFrame");
  find(end_frame, "hdEndFrame");
  find(get_doubles, "hdGetDoublev");
  find(get_integers, "hdGetIntegerv");
  find(get_string, "hdGetString");
  find(set_doubles, "hdSetDoublev");
  find(get_error, "hdGetError");
  find(get_error_string, "hdGetErrorString");
  find(schedule_asynchronous, "hdScheduleAsynchronous");
  find(unschedule, "hdUnschedule");
  find(start_scheduler, "hdStartScheduler");
  find(stop_scheduler, "hdStopScheduler");
}

EntryPoints::~EntryPoints() {
  if (library_) dlclose(library_);
}

}  // namespace pellucida::hdapi
