#pragma once
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace pellucida {

/// Ordered, bounded, counted exchange for a consumer that must receive everything (the recorder). When it is full the
/// newest item is refused and counted, and the caller reports that as an event. Any number of threads.
template <class T>
class Ring {
 public:
  /// `capacity_count` >= 1 items are kept.
  explicit Ring(std::size_t capacity_count) : capacity_count_(capacity_count < 1 ? 1 : capacity_count) {}

  /// False (and counted) when the ring is full or closed.
  bool push(T value) {
    {
      std::lock_guard lock(mutex_);
      if (closed_ || items_.size() >= capacity_count_) {
        ++dropped_count_;
        return false;
      }
      items_.push_back(std::move(value));
    }
    changed_.notify_all();
    return true;
  }

  /// Waits for room instead of refusing: for a batch, where nothing may be lost. False when `stop` is requested or the
  /// ring is closed; the item is then not taken, and not counted.
  bool push_wait(T value, std::stop_token stop = {}) {
    {
      std::unique_lock lock(mutex_);
      const bool ready = changed_.wait(lock, stop, [&] { return items_.size() < capacity_count_ || closed_; });
      if (!ready || closed_) return false;
      items_.push_back(std::move(value));
    }
    changed_.notify_all();
    return true;
  }

  /// The oldest item; blocks for it. Nothing when `stop` is requested, or the ring is closed and empty.
  std::optional<T> wait(std::stop_token stop) {
    std::optional<T> item;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, stop, [&] { return !items_.empty() || closed_; });
      if (stop.stop_requested() || items_.empty()) return std::nullopt;
      item = std::move(items_.front());
      items_.pop_front();
    }
    changed_.notify_all();
    return item;
  }

  /// No more items are accepted; those inside can still be read.
  void close() {
    {
      std::lock_guard lock(mutex_);
      closed_ = true;
    }
    changed_.notify_all();
  }

  std::size_t size() const {
    std::lock_guard lock(mutex_);
    return items_.size();
  }
  std::uint64_t dropped_count() const {
    std::lock_guard lock(mutex_);
    return dropped_count_;
  }

 private:
  const std::size_t capacity_count_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<T> items_;
  bool closed_ = false;
  std::uint64_t dropped_count_ = 0;
};

}  // namespace pellucida
