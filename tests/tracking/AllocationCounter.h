#pragma once
#include <cstddef>

namespace pellucida::test {

/// Memory asked for from the heap by this thread, by anything: operator new, Eigen, OpenCV, C. Counts from construction
/// on. The program that links AllocationCounter.cpp replaces malloc and its kin by ones that count (glibc only, and not
/// beside a sanitizer, which replaces them too).
class AllocationCounter {
 public:
  AllocationCounter();
  std::size_t count() const;
  std::size_t bytes() const;

 private:
  std::size_t count_before_, bytes_before_;
};

}  // namespace pellucida::test
