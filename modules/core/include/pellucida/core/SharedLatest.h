#pragma once
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace pellucida {

/// Newest-wins exchange: one value, replaced by each `publish`; readers take a copy of the newest (T is a cheap handle,
/// such as a Frozen<...>). For displays and model building, where only the newest matters. Any number of threads.
/// A value that was replaced unread by `wait` counts as overwritten.
template <class T>
class SharedLatest {
 public:
  /// Puts `value` in place. Returns the value it replaced if that one had not been taken by `wait`.
  std::optional<T> publish(T value) {
    std::optional<T> old;
    bool unread = false;
    {
      std::lock_guard lock(mutex_);
      old = std::exchange(value_, std::optional<T>(std::move(value)));
      unread = old && !taken_;
      if (unread) ++overwritten_count_;
      taken_ = false;
      ++sequence_;
    }
    changed_.notify_all();
    if (!unread) old.reset();
    return old;
  }

  /// The newest value, or nothing before the first `publish`. Does not mark it as taken.
  std::optional<T> peek() const {
    std::lock_guard lock(mutex_);
    return value_;
  }

  /// Number of values published so far: a cheap check for something new.
  std::uint64_t sequence() const {
    std::lock_guard lock(mutex_);
    return sequence_;
  }

  /// Blocks until there is a value not yet taken, and takes it. Nothing when `stop` is requested, or the exchange was
  /// closed and its last value taken.
  std::optional<T> wait(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, stop, [&] { return (value_ && !taken_) || closed_; });
    if (stop.stop_requested() || !value_ || taken_) return std::nullopt;
    taken_ = true;
    return value_;
  }

  /// No more values will come: waiting readers get what is left, then nothing.
  void close() {
    {
      std::lock_guard lock(mutex_);
      closed_ = true;
    }
    changed_.notify_all();
  }

  /// Values replaced before they were taken.
  std::uint64_t overwritten_count() const {
    std::lock_guard lock(mutex_);
    return overwritten_count_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<T> value_;
  bool taken_ = false;
  bool closed_ = false;
  std::uint64_t sequence_ = 0;
  std::uint64_t overwritten_count_ = 0;
};

}  // namespace pellucida
