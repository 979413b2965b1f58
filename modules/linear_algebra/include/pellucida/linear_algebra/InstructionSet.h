#pragma once

namespace pellucida {

/// The instruction sets the hot loops are compiled for, besides plain x86-64 (or the machine's own).
enum class InstructionSet { kPlain, kAvx2, kAvx512 };

/// The best this machine has, but no better than the limit.
InstructionSet instruction_set() noexcept;

/// Sets the limit for the whole program, for comparisons; results are the same to the last bit.
void limit_instruction_set(InstructionSet best) noexcept;

}  // namespace pellucida
