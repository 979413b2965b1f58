#include "DiskSync.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr std::chrono::milliseconds kPeriod{500};

OutputError sync_error(const std::filesystem::path& folder, int reason) {
  return OutputError(folder.string() + ": the disk did not take what was written (" +
                     std::generic_category().message(reason) + "); check the disk and its free space");
}

}  // namespace

DiskSync::DiskSync(const std::filesystem::path& folder, SessionSync when) : folder_(folder) {
  descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0) throw sync_error(folder_, errno);
  if (when == SessionSync::kAtEnd) return;
  thread_ = std::jthread([this](std::stop_token stop) {
    std::unique_lock lock(mutex_);
    // Wakes early only to stop.
    while (!wake_.wait_for(lock, stop, kPeriod, [&] { return stop.stop_requested(); })) {
      if (stop.stop_requested()) break;
      sync();
    }
  });
}

DiskSync::~DiskSync() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
  ::close(descriptor_);
}

void DiskSync::sync() noexcept {
  // One call for the whole file system is far cheaper than one for each of the many small files.
  if (!pending_.exchange(false, std::memory_order_acq_rel)) return;
  if (::syncfs(descriptor_) != 0) reason_.store(errno, std::memory_order_release);
}

void DiskSync::finish() {
  sync();
  rethrow();
}

void DiskSync::rethrow() const {
  if (const int reason = reason_.load(std::memory_order_acquire)) throw sync_error(folder_, reason);
}

}  // namespace pellucida
