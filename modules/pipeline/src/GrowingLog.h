#pragma once
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace pellucida {

/// Everything that was appended, in its order, for readers that miss nothing (charts, the list of events). Any number
/// of threads.
template <class T>
class GrowingLog {
 public:
  void append(T item) {
    std::lock_guard lock(mutex_);
    items_.push_back(std::move(item));
  }

  /// Copies of the items from number `first` on (0 = all); none when there are not so many yet.
  std::vector<T> since(std::size_t first) const {
    std::lock_guard lock(mutex_);
    if (first >= items_.size()) return {};
    return {items_.begin() + static_cast<std::ptrdiff_t>(first), items_.end()};
  }

 private:
  mutable std::mutex mutex_;
  std::vector<T> items_;
};

}  // namespace pellucida
