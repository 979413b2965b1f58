#include "pellucida/teleoperation/SpaceMouseHand.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <thread>
#include <vector>

#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"
#include "teleoperation/Eventually.h"

namespace pellucida {
namespace {

/// The daemon's side of the socket, as far as its first protocol goes: eight whole numbers an event.
class StandInDaemon {
 public:
  explicit StandInDaemon(const std::string& path) : path_(path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    listener_ = socket(AF_UNIX, SOCK_STREAM, 0);
    if (bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) std::abort();
    listen(listener_, 8);
    thread_ = std::jthread([this](std::stop_token stop) {
      while (!stop.stop_requested()) {
        pollfd waiting{listener_, POLLIN, 0};
        if (poll(&waiting, 1, 5) <= 0) continue;
        const int client = accept(listener_, nullptr, nullptr);
        std::lock_guard lock(mutex_);
        clients_.push_back(client);
      }
    });
  }
  ~StandInDaemon() {
    thread_.request_stop();
    thread_.join();
    for (const int client : clients_) close(client);
    close(listener_);
    unlink(path_.c_str());
  }
  void send(const std::array<std::int32_t, 8>& event) {
    std::lock_guard lock(mutex_);
    for (const int client : clients_) ::send(client, event.data(), sizeof event, MSG_NOSIGNAL);
  }
  /// A part of an event only.
  void send_bytes(const char* bytes, std::size_t count) {
    std::lock_guard lock(mutex_);
    for (const int client : clients_) ::send(client, bytes, count, MSG_NOSIGNAL);
  }

 private:
  std::string path_;
  int listener_ = -1;
  std::mutex mutex_;
  std::vector<int> clients_;
  std::jthread thread_;
};

class SpaceMouseHandTest : public testing::Test {
 protected:
  SpaceMouseHandTest() : path_((folder_.path() / "spnav.sock").string()) { setenv("SPNAV_SOCKET", path_.c_str(), 1); }
  ~SpaceMouseHandTest() override { unsetenv("SPNAV_SOCKET"); }

  bool read(SpaceMouseHand& hand) { return hand.read(time_s_ += 0.001, sample_); }

  TemporaryFolder folder_;
  std::string path_;
  HandSample sample_;
  double time_s_ = 0.0;
};

TEST_F(SpaceMouseHandTest, SaysWhyThereIsNone) {
  try {
    SpaceMouseHand hand;
    FAIL() << "opened a SpaceMouse without a daemon";
  } catch (const DeviceError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("spacenavd"), std::string::npos) << text;
    EXPECT_NE(text.find(path_), std::string::npos) << text;
  }
  // A socket without a listener.
  { StandInDaemon daemon(path_); }
  EXPECT_FALSE(space_mouse_trouble().empty());
  EXPECT_TRUE(space_mouse_name().empty());
}

TEST_F(SpaceMouseHandTest, PushingTheCapMovesTheHandInItsFrame) {
  StandInDaemon daemon(path_);
  EXPECT_TRUE(space_mouse_trouble().empty()) << space_mouse_trouble();
  SpaceMouseHand hand;
  eventually([&] { return read(hand) && hand.reading_count() > 0; });
  eventually([&] {
    daemon.send({0, 350, 175, -70, 9, 9, 9, 16});
    return read(hand) && sample_.position_m.x > 0.0199999999;
  });
  EXPECT_NEAR(sample_.position_m.x, 0.02, 1e-9);
  EXPECT_NEAR(sample_.position_m.y, 0.01, 1e-8);
  EXPECT_NEAR(sample_.position_m.z, 0.004, 1e-8);
  // Beyond the end of the way is the end of the way.
  eventually([&] {
    daemon.send({0, -30000, 0, 0, 0, 0, 0, 16});
    return read(hand) && sample_.position_m.x < -0.0199999999;
  });
  EXPECT_NEAR(sample_.position_m.x, -0.02, 1e-9);
}

TEST_F(SpaceMouseHandTest, ButtonsMeanWhatTheyShould) {
  StandInDaemon daemon(path_);
  SpaceMouseHand hand;
  constexpr std::uint32_t kMeanings[] = {kClutch, kInject, kEmergency};
  for (int button = 0; button < 3; ++button) {
    eventually([&] {
      daemon.send({1, button, 0, 0, 0, 0, 0, 0});
      return read(hand) && sample_.buttons == kMeanings[button];
    });
    eventually([&] {
      daemon.send({2, button, 0, 0, 0, 0, 0, 0});
      return read(hand) && sample_.buttons == 0;
    });
  }
  // A button it has no meaning for, then one it has: the first did no harm.
  eventually([&] {
    daemon.send({1, 77, 0, 0, 0, 0, 0, 0});
    daemon.send({1, 0, 0, 0, 0, 0, 0, 0});
    return read(hand) && sample_.buttons == kClutch;
  });
}

TEST_F(SpaceMouseHandTest, IsLostWithTheDaemonAndComesBackWithIt) {
  auto daemon = std::make_unique<StandInDaemon>(path_);
  SpaceMouseHand hand;
  eventually([&] {
    daemon->send({1, 1, 0, 0, 0, 0, 0, 0});
    return read(hand) && sample_.buttons == kInject;
  });
  daemon.reset();
  eventually([&] { return !read(hand); });
  EXPECT_EQ(sample_.buttons, 0u);
  EXPECT_FALSE(hand.write({}));
  daemon = std::make_unique<StandInDaemon>(path_);
  eventually([&] { return read(hand); });
  EXPECT_EQ(sample_.buttons, 0u);
}

TEST_F(SpaceMouseHandTest, OneAtATime) {
  StandInDaemon daemon(path_);
  SpaceMouseHand hand;
  EXPECT_THROW(SpaceMouseHand second, DeviceError);
}

}  // namespace
}  // namespace pellucida
