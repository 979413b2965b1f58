#include "pellucida/teleoperation/SpaceMouseHand.h"

#include <poll.h>
#include <spnav.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr int kWaitForEvent_ms = 20;
constexpr double kTryAgain_s = 0.5;
constexpr const char* kUsualSocket = "/var/run/spnav.sock";

std::atomic<bool> connection_in_use{false};

/// Where the daemon listens, as libspnav finds it.
std::string socket_path() {
  const char* named = std::getenv("SPNAV_SOCKET");
  return named && *named ? named : kUsualSocket;
}

DeviceSpecification specification_for(const SpaceMouseOptions& options) {
  if (!(options.reach_m > 0.0) || !(options.full_deflection > 0.0)) {
    throw UsageError("SpaceMouse: reach and full deflection must be above 0");
  }
  DeviceSpecification specification;
  specification.name = "SpaceMouse";
  specification.workspace_radius_m = options.reach_m;
  specification.resolution_m = options.reach_m / options.full_deflection;
  specification.source = "chosen; spacenavd reports about 350 at the end of the cap's way";
  return specification;
}

/// True when the daemon at the other end has gone: the socket reads its end.
bool daemon_gone() {
  char byte;
  return recv(spnav_fd(), &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
}

}  // namespace

std::string space_mouse_trouble() {
  const std::string path = socket_path();
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) return "SPNAV_SOCKET names a path that is too long for a socket";
  std::memcpy(address.sun_path, path.c_str(), path.size());
  const int file = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (file < 0) return std::string("no socket to be had (") + std::strerror(errno) + ")";
  const bool reached = connect(file, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  const int fault = errno;
  close(file);
  if (reached) return {};
  if (fault == EACCES) return "no permission to use " + path + "; let the daemon's configuration allow it";
  if (fault == ENOENT) {
    const bool installed = access("/usr/bin/spacenavd", X_OK) == 0 || access("/usr/sbin/spacenavd", X_OK) == 0;
    return installed ? "the daemon spacenavd is not running (no " + path + "); start it: sudo systemctl start spacenavd"
                     : "the daemon spacenavd is not installed (no " + path + "); sudo apt-get install spacenavd";
  }
  return "the daemon spacenavd does not answer at " + path + " (" + std::strerror(fault) +
         "); start it: sudo systemctl restart spacenavd";
}

std::string space_mouse_name() {
  if (!space_mouse_trouble().empty() || connection_in_use.exchange(true)) return {};
  std::string name;
  if (spnav_open() == 0) {
    char text[256] = {};
    if (spnav_protocol() > 0 && spnav_dev_name(text, sizeof text) > 0) name = text;
    spnav_close();
  }
  connection_in_use = false;
  return name;
}

std::string space_mouse_library_version() {
  // The library does not tell; the build knew.
  return PELLUCIDA_SPNAV_VERSION;
}

SpaceMouseHand::SpaceMouseHand(const SpaceMouseOptions& options)
    : PolledHand(specification_for(options)), options_(options) {
  if (const std::string trouble = space_mouse_trouble(); !trouble.empty()) throw DeviceError("SpaceMouse: " + trouble);
  if (connection_in_use.exchange(true)) throw DeviceError("SpaceMouse: already in use by this program");
  if (spnav_open() != 0) {
    connection_in_use = false;
    throw DeviceError("SpaceMouse: the daemon at " + socket_path() + " does not take a connection");
  }
  reading_.connected = true;
  start();
}

SpaceMouseHand::~SpaceMouseHand() {
  stop();
  spnav_close();
  connection_in_use = false;
}

PolledHand::Reading SpaceMouseHand::poll(const TouchCue&, std::stop_token stop) {
  if (!reading_.connected) {
    wait_for(stop, kTryAgain_s);
    if (space_mouse_trouble().empty() && spnav_open() == 0) reading_.connected = true;
    return reading_;
  }
  pollfd waiting{spnav_fd(), POLLIN, 0};
  if (::poll(&waiting, 1, kWaitForEvent_ms) > 0) {
    if (daemon_gone()) {
      spnav_close();
      reading_ = {};
    } else {
      take_events();
    }
  }
  return reading_;
}

void SpaceMouseHand::take_events() {
  spnav_event event;
  while (!daemon_gone() && spnav_poll_event(&event)) {
    if (event.type == SPNAV_EVENT_MOTION) {
      const auto share = [this](int value) { return std::clamp(value / options_.full_deflection, -1.0, 1.0); };
      // The daemon counts away from the person as above 0.
      reading_.position_m = {options_.reach_m * share(event.motion.x), options_.reach_m * share(event.motion.y),
                             -options_.reach_m * share(event.motion.z)};
    } else if (event.type == SPNAV_EVENT_BUTTON) {
      constexpr HandButton kMeanings[] = {kClutch, kInject, kEmergency};
      const int number = event.button.bnum;
      if (number < 0 || number >= 3) continue;
      if (event.button.press) {
        reading_.buttons |= kMeanings[number];
      } else {
        reading_.buttons &= ~static_cast<std::uint32_t>(kMeanings[number]);
      }
    }
  }
}

}  // namespace pellucida
