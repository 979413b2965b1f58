#include "pellucida/membrane/CellProfile.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "pellucida/core/Error.h"
#include "pellucida/core/Resources.h"

namespace pellucida {
namespace {

using Json = nlohmann::ordered_json;

/// Reads values by their dotted key; every fault names file and key.
class Reader {
 public:
  Reader(std::string file, Json root) : file_(std::move(file)), root_(std::move(root)) {}

  bool has(const std::string& key) const { return root_.contains(key); }

  const Json& at(const std::string& key) const {
    const Json* here = &root_;
    for (std::size_t from = 0; from <= key.size();) {
      const std::size_t to = std::min(key.find('.', from), key.size());
      const std::string part = key.substr(from, to - from);
      if (!here->is_object() || !here->contains(part)) fail(key, "is missing; add it");
      here = &(*here)[part];
      from = to + 1;
    }
    return *here;
  }

  std::string text(const std::string& key) const {
    const Json& value = at(key);
    if (!value.is_string() || value.get<std::string>().empty()) fail(key, "must be a text");
    return value.get<std::string>();
  }

  double number(const std::string& key, double low, double high) const {
    const Json& value = at(key);
    if (!value.is_number()) fail(key, "must be a number");
    const double number = value.get<double>();
    if (!(number >= low && number <= high)) {
      fail(key, "is " + short_text(number) + "; it must lie in " + short_text(low) + " .. " + short_text(high));
    }
    return number;
  }

  double positive(const std::string& key, double high) const {
    const double value = number(key, 0.0, high);
    if (value <= 0.0) fail(key, "must be above 0");
    return value;
  }

  [[noreturn]] void fail(const std::string& key, const std::string& what) const {
    throw InputError(file_ + ": \"" + key + "\" " + what);
  }

 private:
  static std::string short_text(double value) { return Json(value).dump(); }

  std::string file_;
  Json root_;
};

RegionConstants read_region(const Reader& in, const std::string& key) {
  RegionConstants region;
  region.k2_ratio = in.positive(key + ".k2_ratio", 1e3);
  region.k1_over_k2 = in.number(key + ".k1_over_k2", -1.0, 100.0);
  region.hinge_ratio = in.positive(key + ".hinge_ratio", 1e3);
  return region;
}

Json region_json(const RegionConstants& region) {
  return {{"k2_ratio", region.k2_ratio}, {"k1_over_k2", region.k1_over_k2}, {"hinge_ratio", region.hinge_ratio}};
}

/// The entries of a list, each with a reader that names its place.
std::vector<Reader> read_list(const Reader& in, const std::string& file, const std::string& key) {
  const Json& list = in.at(key);
  if (!list.is_array()) in.fail(key, "must be a list");
  std::vector<Reader> entries;
  for (std::size_t k = 0; k < list.size(); ++k) {
    entries.emplace_back(file + " " + key + "[" + std::to_string(k) + "]", list[k]);
  }
  return entries;
}

void read_relaxation(const Reader& in, const std::string& file, CellProfile& profile) {
  for (const Reader& one : read_list(in, file, "relaxation_arms")) {
    profile.relaxation_arms.push_back({one.positive("fraction", 1.0), one.positive("time_s", 1e9)});
  }
  try {
    Relaxation checked(profile.relaxation_arms);
  } catch (const UsageError& error) {
    in.fail("relaxation_arms", std::string("is wrong: ") + error.what());
  }
  profile.relaxation_elastic_ratio = in.number("relaxation_elastic_ratio", 1.0, 1e3);
  profile.relaxation_anchor_ramp_s = in.number("relaxation_anchor_ramp_s", 0.0, 1e9);
}

}  // namespace

CellProfile read_profile(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file.string() + ": the profile can't be read; check the path and its permissions");
  Json root;
  try {
    root = Json::parse(stream);
  } catch (const Json::parse_error& error) {
    throw InputError(file.string() + ": no JSON at byte " + std::to_string(error.byte) +
                     "; correct the file or use a shipped profile");
  }
  const Reader in(file.string(), root);
  if (in.text("schema") != "pellucida-cell-profile") in.fail("schema", "must be \"pellucida-cell-profile\"");
  if (in.number("schema_version", 1, 1e6) != 1.0) in.fail("schema_version", "is newer than this program; update it");

  CellProfile p;
  p.name = in.text("name");
  p.description = in.text("description");
  const Json& sources = in.at("sources");
  if (!sources.is_object()) in.fail("sources", "must be an object of texts");
  for (const auto& [what, where] : sources.items()) {
    if (!where.is_string()) in.fail("sources." + what, "must be a text");
    p.sources.push_back({what, where.get<std::string>()});
  }

  p.mid_radius_um = in.positive("geometry.mid_radius_um", 1e4);
  p.thickness_um = in.positive("geometry.thickness_um", p.mid_radius_um);
  p.inner_radius_um = in.positive("geometry.inner_radius_um", p.mid_radius_um);
  if (std::abs(p.inner_radius_um + 0.5 * p.thickness_um - p.mid_radius_um) > 0.01 * p.thickness_um) {
    in.fail("geometry.inner_radius_um", "must be mid_radius_um less half of thickness_um");
  }

  p.young_modulus_kPa = in.positive("material.young_modulus_kPa", 1e7);
  p.effective_young_modulus_kPa = in.positive("material.effective_young_modulus_kPa", 1e7);
  p.force_scale_relative_sigma = in.number("material.force_scale_relative_sigma", 0.0, 1.0);
  p.poisson_ratio = in.number("material.poisson_ratio", 0.0, 0.5);
  p.puncture_force_uN = in.positive("material.puncture_force_uN", 1e6);
  p.puncture_indentation_um = in.positive("material.puncture_indentation_um", 2.0 * p.mid_radius_um);

  p.tip_radius_um = in.positive("contact.tip_radius_um", p.mid_radius_um);
  p.tip_bond_per_um = in.positive("contact.tip_bond_per_um", 1e6);
  p.holder_ring_um = in.positive("contact.holder_ring_um", p.mid_radius_um);
  p.holder_half_width_um = in.positive("contact.holder_half_width_um", p.holder_ring_um);
  p.holder_bond_per_um = in.positive("contact.holder_bond_per_um", 1e6);

  p.tip = read_region(in, "msd.tip");
  p.body = read_region(in, "msd.body");
  p.holder = read_region(in, "msd.holder");
  p.tip_angle_rad = in.positive("msd.tip_angle_rad", 1.6);
  p.holder_angle_rad = in.positive("msd.holder_angle_rad", 1.6);
  p.volume_stiffness_ratio = in.positive("msd.volume_stiffness_ratio", 1e9);
  p.damping_uN_s_per_um = in.number("msd.damping_uN_s_per_um", 0.0, 1e6);
  p.node_mass_kg = in.positive("msd.node_mass_kg", 1.0);

  p.mesh_frequency = static_cast<int>(in.number("mesh.frequency", 2, 40));
  p.mesh_grading = in.number("mesh.grading", 0.2, 5.0);

  for (const Reader& one : read_list(in, file.string(), "errors")) {
    p.errors.push_back({static_cast<int>(one.number("configuration", 1, 4)), one.text("reference"),
                        one.number("largest_ratio", 0, 10), one.number("largest_of_peak_ratio", 0, 10),
                        one.number("from_um", 0, 1e4), one.number("to_um", 0, 1e4)});
  }

  // What older profiles don't have.
  if (in.has("references")) {
    for (const Reader& one : read_list(in, file.string(), "references")) {
      p.references.push_back({static_cast<int>(one.number("configuration", 1, 4)),
                              one.number("holder_angle_deg", 0, 90), one.number("offset_um", -1e4, 1e4),
                              static_cast<int>(one.number("node_count", 0, 1e9)), one.number("to_um", 0, 1e4)});
    }
  }
  if (in.has("relaxation_arms")) read_relaxation(in, file.string(), p);
  return p;
}

CellProfile load_profile(std::string_view name_or_file) {
  std::error_code code;
  const std::filesystem::path shipped = resource_folder() / "profiles" / (std::string(name_or_file) + ".json");
  if (!std::filesystem::is_regular_file(shipped, code) &&
      !std::filesystem::exists(std::filesystem::path(name_or_file), code)) {
    std::string known;
    for (const auto& one : list_resources("profiles", ".json")) known += (known.empty() ? "" : ", ") + one;
    throw UsageError("profile " + std::string(name_or_file) + ": unknown; give one of " + known +
                     ", or a profile's file");
  }
  return read_profile(find_resource("profiles", name_or_file, ".json"));
}

std::string to_json(const CellProfile& p) {
  Json sources = Json::object();
  for (const auto& [what, where] : p.sources) sources[what] = where;
  Json errors = Json::array();
  for (const auto& e : p.errors) {
    errors.push_back({{"configuration", e.configuration},
                      {"reference", e.reference},
                      {"largest_ratio", e.largest_ratio},
                      {"largest_of_peak_ratio", e.largest_of_peak_ratio},
                      {"from_um", e.from_um},
                      {"to_um", e.to_um}});
  }
  Json references = Json::array();
  for (const auto& r : p.references) {
    references.push_back({{"configuration", r.configuration},
                          {"holder_angle_deg", r.holder_angle_deg},
                          {"offset_um", r.offset_um},
                          {"node_count", r.node_count},
                          {"to_um", r.to_um}});
  }
  Json arms = Json::array();
  for (const auto& arm : p.relaxation_arms) arms.push_back({{"fraction", arm.fraction}, {"time_s", arm.time_s}});
  Json root = {
      {"schema", "pellucida-cell-profile"},
      {"schema_version", 1},
      {"name", p.name},
      {"description", p.description},
      {"sources", sources},
      {"geometry",
       {{"mid_radius_um", p.mid_radius_um}, {"thickness_um", p.thickness_um}, {"inner_radius_um", p.inner_radius_um}}},
      {"material",
       {{"young_modulus_kPa", p.young_modulus_kPa},
        {"effective_young_modulus_kPa", p.effective_young_modulus_kPa},
        {"force_scale_relative_sigma", p.force_scale_relative_sigma},
        {"poisson_ratio", p.poisson_ratio},
        {"puncture_force_uN", p.puncture_force_uN},
        {"puncture_indentation_um", p.puncture_indentation_um}}},
      {"contact",
       {{"tip_radius_um", p.tip_radius_um},
        {"tip_bond_per_um", p.tip_bond_per_um},
        {"holder_ring_um", p.holder_ring_um},
        {"holder_half_width_um", p.holder_half_width_um},
        {"holder_bond_per_um", p.holder_bond_per_um}}},
      {"msd",
       {{"tip", region_json(p.tip)},
        {"body", region_json(p.body)},
        {"holder", region_json(p.holder)},
        {"tip_angle_rad", p.tip_angle_rad},
        {"holder_angle_rad", p.holder_angle_rad},
        {"volume_stiffness_ratio", p.volume_stiffness_ratio},
        {"damping_uN_s_per_um", p.damping_uN_s_per_um},
        {"node_mass_kg", p.node_mass_kg}}},
      {"mesh", {{"frequency", p.mesh_frequency}, {"grading", p.mesh_grading}}},
      {"references", references},
      {"errors", errors}};
  if (!p.relaxation_arms.empty()) {
    root["relaxation_arms"] = arms;
    root["relaxation_elastic_ratio"] = p.relaxation_elastic_ratio;
    root["relaxation_anchor_ramp_s"] = p.relaxation_anchor_ramp_s;
  }
  return root.dump(2);
}

}  // namespace pellucida
