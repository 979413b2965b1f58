#pragma once
#include <concepts>
#include <string>

#include "pellucida/core/Expected.h"

namespace pellucida {

/// Why a step has no output for one item. Not an exception: the next item may succeed.
struct StepFailure {
  std::string reason;
};

/// A step turns one frozen item into the next. It may have memory; it knows nothing of threads, and is called by one
/// thread at a time. It throws only for faults that end the run.
template <class S>
concept Step = requires(S step, const typename S::Input& input) {
  { step.process(input) } -> std::same_as<expected<typename S::Output, StepFailure>>;
};

}  // namespace pellucida
