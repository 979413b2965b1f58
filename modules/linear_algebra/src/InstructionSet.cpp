#include "pellucida/linear_algebra/InstructionSet.h"

#include <algorithm>
#include <atomic>

namespace pellucida {
namespace {

InstructionSet best_of_machine() noexcept {
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f")) return InstructionSet::kAvx512;
  if (__builtin_cpu_supports("avx2")) return InstructionSet::kAvx2;
#endif
  return InstructionSet::kPlain;
}

std::atomic<InstructionSet> limit = InstructionSet::kAvx512;

}  // namespace

InstructionSet instruction_set() noexcept {
  static const InstructionSet best = best_of_machine();
  return std::min(best, limit.load(std::memory_order_relaxed));
}

void limit_instruction_set(InstructionSet best) noexcept {
  limit.store(best, std::memory_order_relaxed);
}

}  // namespace pellucida
