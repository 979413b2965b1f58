#pragma once
#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace pellucida {

/// How much waits in an ArrivalQueue.
struct QueueLoad {
  std::size_t unsettled_bytes = 0;  ///< of frames that are not settled, or queued behind one that is not
  std::size_t ready_bytes = 0;      ///< of what could be taken now

  std::size_t byte_count() const noexcept { return unsettled_bytes + ready_bytes; }
};

/// Frames on their way to the thread that writes them: they settle in any order (measured, or overtaken by a newer
/// one), and are given out in the order in which they arrived. No call but `wait` ever waits: whatever comes is taken,
/// and `load` tells the caller when to leave out what is heavy. Any number of threads.
template <class T>
class ArrivalQueue {
 public:
  /// A frame arrived; `key` is its own. It is given out as it is when the queue closes before the frame is settled.
  /// False, and nothing taken, when the queue is closed.
  bool announce(long key, T item, std::size_t byte_count) {
    std::lock_guard lock(mutex_);
    if (closed_) return false;
    frames_.push_back({key, std::move(item), byte_count, false});
    load_.unsettled_bytes += byte_count;
    return true;
  }

  /// What became of an announced frame. False, and nothing taken, when the queue is closed, or the frame was not
  /// announced or is settled already.
  bool settle(long key, T item, std::size_t byte_count) {
    {
      std::lock_guard lock(mutex_);
      if (closed_) return false;
      const auto found = std::find_if(frames_.begin(), frames_.end(),
                                      [&](const Frame& frame) { return frame.key == key && !frame.settled; });
      if (found == frames_.end()) return false;
      load_.unsettled_bytes += byte_count - found->byte_count;
      // The item before leaves with `item`, after the lock.
      std::swap(found->item, item);
      found->byte_count = byte_count;
      found->settled = true;
      while (!frames_.empty() && frames_.front().settled) move_front();
    }
    changed_.notify_all();
    return true;
  }

  /// Something beside the frames, given out without waiting for any of them. False, and nothing taken, when the queue
  /// is closed.
  bool push(T item, std::size_t byte_count) {
    {
      std::lock_guard lock(mutex_);
      if (closed_) return false;
      ready_.push_back({std::move(item), byte_count});
      load_.ready_bytes += byte_count;
    }
    changed_.notify_all();
    return true;
  }

  /// The oldest item that is ready; blocks for it. Nothing when `stop` is requested, or the queue is closed and empty.
  std::optional<T> wait(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, stop, [&] { return !ready_.empty() || closed_; });
    if (stop.stop_requested() || ready_.empty()) return std::nullopt;
    std::optional<T> item(std::move(ready_.front().item));
    load_.ready_bytes -= ready_.front().byte_count;
    ready_.pop_front();
    return item;
  }

  /// Nothing more is taken; what is inside, unsettled frames too, can still be read.
  void close() {
    {
      std::lock_guard lock(mutex_);
      closed_ = true;
      while (!frames_.empty()) move_front();
    }
    changed_.notify_all();
  }

  QueueLoad load() const {
    std::lock_guard lock(mutex_);
    return load_;
  }

 private:
  struct Frame {
    long key = 0;
    T item;
    std::size_t byte_count = 0;
    bool settled = false;
  };
  struct Ready {
    T item;
    std::size_t byte_count = 0;
  };

  // The oldest frame becomes ready; with mutex_ held.
  void move_front() {
    Frame& frame = frames_.front();
    load_.unsettled_bytes -= frame.byte_count;
    load_.ready_bytes += frame.byte_count;
    ready_.push_back({std::move(frame.item), frame.byte_count});
    frames_.pop_front();
  }

  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Frame> frames_;  // in the order of their arrival
  std::deque<Ready> ready_;
  QueueLoad load_;
  bool closed_ = false;
};

}  // namespace pellucida
