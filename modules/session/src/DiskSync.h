#pragma once
#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>

#include "pellucida/session/SessionInfo.h"

namespace pellucida {

/// Asks the system onto the disk what was written below a folder, each half second, on a thread of its own: so that a
/// power cut loses at most the last second without any write ever waiting for the disk. Or at the end alone.
class DiskSync {
 public:
  /// Throws OutputError when the folder can't be opened.
  DiskSync(const std::filesystem::path& folder, SessionSync when);
  ~DiskSync();
  DiskSync(const DiskSync&) = delete;
  DiskSync& operator=(const DiskSync&) = delete;

  /// Notes that something was written.
  void mark() noexcept { pending_.store(true, std::memory_order_release); }

  /// Waits until all is on the disk. Throws OutputError when the disk reported a failure, now or on the thread before.
  void finish();

  /// Throws OutputError when the disk reported a failure on the thread.
  void rethrow() const;

 private:
  void sync() noexcept;

  std::filesystem::path folder_;
  int descriptor_ = -1;
  std::atomic<bool> pending_{false};
  std::atomic<int> reason_{0};
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;
};

}  // namespace pellucida
