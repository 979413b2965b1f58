#include "commands/ReplayVariants.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

constexpr std::size_t kMostVariants = 100;
constexpr std::string_view kForceModulus = "material.effective_young_modulus_kPa";

/// A parameter and the values it takes.
struct Variation {
  std::string key;   ///< as in the profile, with its groups
  std::string word;  ///< as the user wrote it
  std::vector<double> values;
};

bool is_number(const FieldPlace& field) {
  return std::holds_alternative<double*>(field.value) || std::holds_alternative<int*>(field.value);
}

std::string find_key(const std::string& word, const std::string& text) {
  if (word == "young_modulus_kPa") return std::string(kForceModulus);
  CellProfile any;
  std::vector<std::string> found;
  std::string known;
  const FieldList fields = fields_of(any);
  for (const FieldPlace& field : fields) {
    if (!is_number(field)) continue;
    known += (known.empty() ? "" : ", ") + field.key;
    if (field.key == word || field.name() == word) found.push_back(field.key);
  }
  if (found.size() == 1) return found.front();
  if (found.empty()) throw UsageError("--vary " + text + ": no number of a cell profile; known: " + known);
  std::string several;
  for (const std::string& key : found) several += (several.empty() ? "" : ", ") + key;
  throw UsageError("--vary " + text + ": may mean several; give one of " + several);
}

Variation parse_variation(const std::string& text) {
  const auto sign = text.find('=');
  if (sign == std::string::npos || sign == 0 || sign + 1 == text.size()) {
    throw UsageError("--vary " + text + ": give KEY=VALUE,VALUE,...");
  }
  Variation variation;
  variation.word = text.substr(0, sign);
  variation.key = find_key(variation.word, text);
  for (const std::string& cell : split_csv(text.substr(sign + 1))) {
    double value = 0.0;
    const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (code != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
      throw UsageError("--vary " + text + ": \"" + cell + "\" is not a number");
    }
    variation.values.push_back(value);
  }
  return variation;
}

/// Sets a number of the profile, and what follows from it.
void set_number(CellProfile& profile, const std::string& key, double value) {
  const FieldList fields = fields_of(profile);
  const FieldPlace& field = *fields.find(key);
  if (auto* const* number = std::get_if<double*>(&field.value)) {
    **number = value;
  } else {
    if (value != static_cast<double>(static_cast<int>(value))) {
      throw UsageError("--vary " + key + ": " + csv_number(value) + " is not a whole number");
    }
    *std::get<int*>(field.value) = static_cast<int>(value);
  }
  if (key == "geometry.thickness_um" || key == "geometry.mid_radius_um") {
    profile.inner_radius_um = profile.mid_radius_um - 0.5 * profile.thickness_um;
  }
  profile.sources.push_back({key, "replay --vary"});
}

double number_of(CellProfile profile, const std::string& key) {
  const FieldList fields = fields_of(profile);
  const FieldPlace& field = *fields.find(key);
  if (auto* const* number = std::get_if<double*>(&field.value)) return **number;
  return *std::get<int*>(field.value);
}

using Choice = std::vector<std::pair<const Variation*, double>>;

ReplayVariant make_variant(const CellProfile& recorded, const CellProfile& base, const Choice& choice) {
  ReplayVariant variant{.name = base.name, .profile = base, .changes_json = {}, .folder = {}};
  nlohmann::ordered_json changes = nlohmann::ordered_json::object();
  if (to_json(base) != to_json(recorded)) changes["profile"] = {{"recorded", recorded.name}, {"replayed", base.name}};
  std::string name;
  for (const auto& [variation, value] : choice) {
    changes[variation->key] = {{"recorded", number_of(recorded, variation->key)}, {"replayed", value}};
    set_number(variant.profile, variation->key, value);
    name += (name.empty() ? "" : ",") + variation->word + '=' + csv_number(value);
  }
  if (!name.empty()) variant.name = name;
  variant.changes_json = changes.dump();
  try {
    // A profile that could not be read back is refused before the first frame.
    variant.profile = parse_profile(to_json(variant.profile), "--vary " + name);
  } catch (const InputError& error) {
    throw UsageError(error.what());
  }
  return variant;
}

}  // namespace

std::vector<ReplayVariant> make_variants(const CellProfile& recorded, const std::vector<CellProfile>& profiles,
                                         const std::vector<std::string>& changes, const std::filesystem::path& output) {
  std::vector<Variation> variations;
  for (const std::string& text : changes) variations.push_back(parse_variation(text));
  std::vector<Choice> choices{{}};
  for (const Variation& variation : variations) {
    std::vector<Choice> longer;
    for (const Choice& choice : choices) {
      for (const double value : variation.values) {
        longer.push_back(choice);
        longer.back().emplace_back(&variation, value);
      }
    }
    choices = std::move(longer);
    if (choices.size() > kMostVariants) throw UsageError("--vary: more than 100 variants; give fewer values");
  }

  std::vector<CellProfile> bases = profiles;
  if (bases.empty()) bases.push_back(recorded);
  std::vector<ReplayVariant> variants;
  for (const CellProfile& base : bases) {
    for (const Choice& choice : choices) {
      variants.push_back(make_variant(recorded, base, choice));
      if (bases.size() > 1 && !choice.empty()) variants.back().name = base.name + ',' + variants.back().name;
    }
  }
  if (variants.size() > kMostVariants) throw UsageError("--vary: more than 100 variants; give fewer values");
  for (ReplayVariant& variant : variants) {
    const auto same = [&](const ReplayVariant& other) { return other.name == variant.name; };
    if (std::count_if(variants.begin(), variants.end(), same) > 1) {
      throw UsageError("--vary " + variant.name + ": the same variant twice; give each value once");
    }
    variant.folder = variants.size() == 1 ? output : output / variant.name;
  }
  return variants;
}

}  // namespace pellucida
