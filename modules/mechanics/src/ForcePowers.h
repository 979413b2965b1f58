#pragma once

namespace pellucida {

/// Powers with which the force at a depth goes with radius (falling), thickness, tip and holder, and with the depth
/// itself, near a cell's puncture (docs/method.md, 3.5 and 3.6).
inline constexpr double kRadiusPower = 1.9, kThicknessPower = 1.2, kTipPower = 0.4, kHolderPower = 0.5,
                        kDepthPower = 1.8;

}  // namespace pellucida
