#include "tracking/AllocationCounter.h"

#include <cerrno>
#include <cstdint>

// glibc's own functions under the names a program may replace.
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

thread_local std::size_t count_of_thread = 0, bytes_of_thread = 0;

void note(std::size_t size) {
  ++count_of_thread;
  bytes_of_thread += size;
}

}  // namespace

extern "C" {
void* malloc(std::size_t size) {
  note(size);
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) {
  note(number * size);
  return __libc_calloc(number, size);
}
void* realloc(void* old, std::size_t size) {
  note(size);
  return __libc_realloc(old, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  note(size);
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  note(size);
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** result, std::size_t alignment, std::size_t size) {
  note(size);
  *result = __libc_memalign(alignment, size);
  return *result ? 0 : ENOMEM;
}
}

namespace pellucida::test {

AllocationCounter::AllocationCounter() : count_before_(count_of_thread), bytes_before_(bytes_of_thread) {}
std::size_t AllocationCounter::count() const {
  return count_of_thread - count_before_;
}
std::size_t AllocationCounter::bytes() const {
  return bytes_of_thread - bytes_before_;
}

}  // namespace pellucida::test
