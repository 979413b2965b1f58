#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "pellucida/pipeline/Counterfactual.h"

namespace pellucida {

/// The variants of a replay: each of `profiles` (empty: `recorded` alone) with each combination of the values in
/// `changes`, texts such as `young_modulus_kPa=100,140,180`. A key is a number of the cell profile: its whole key
/// (`contact.tip_radius_um`) or the last part of it; `young_modulus_kPa` is the modulus that forces are computed with
/// (`material.effective_young_modulus_kPa`). Where radius or thickness change, the inner radius follows. One variant
/// goes to `output` itself, several to folders in it. Throws UsageError for an unknown key, a value that is no number
/// or out of its range, more than 100 variants.
std::vector<ReplayVariant> make_variants(const CellProfile& recorded, const std::vector<CellProfile>& profiles,
                                         const std::vector<std::string>& changes, const std::filesystem::path& output);

}  // namespace pellucida
