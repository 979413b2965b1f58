#pragma once
#include "PunctureVerdict.h"
#include "pellucida/core/NeedleContact.h"

namespace pellucida {

/// What a frame in contact gives the verdict on a puncture.
PunctureVerdict::Sight sight_of(const Observation& observation, const NeedleContact& contact);

}  // namespace pellucida
