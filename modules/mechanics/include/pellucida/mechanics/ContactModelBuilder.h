#pragma once
#include "pellucida/core/ContactModel.h"
#include "pellucida/core/Observation.h"
#include "pellucida/mechanics/ForceObserver.h"

namespace pellucida {

/// What the 1 kHz thread learns from one measured frame that arrived at `arrival_s` on the run's clock. Valid where the
/// needle was seen and the estimate holds a force: that of equilibrium in contact, 0 while free or punctured.
ContactModel contact_model(const Observation& observation, const ForceEstimate& estimate, double arrival_s) noexcept;

}  // namespace pellucida
