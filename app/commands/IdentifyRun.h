#pragma once
#include <map>
#include <optional>
#include <string>

namespace pellucida {

/// What the user asked of `pellucida identify`.
struct IdentifyArguments {
  std::string output;
  std::string base;  ///< a profile to start from
  std::string name, description, source = "given on the command line";
  std::map<std::string, std::optional<double>> numbers;  ///< of the profile, by key (docs/profiles.md)
  std::optional<double> scale_uncertainty_percent, max_indentation_um, anchor_ramp_s;
  std::string measured_curve, relaxation;
  double edge_length_ratio = 1.0;
  int geometry_cells = 0;  // computed for the correction by geometry; 0: none
  int threads = 0;
  bool keep_constants = false;
  bool no_picture = false;
  bool replace = false;

  bool has(const std::string& key) const {
    const auto found = numbers.find(key);
    return found != numbers.end() && found->second;
  }
};

/// Identifies, writes the profile (and its picture) and prints what came out. Throws as `identify`; UsageError,
/// InputError and OutputError for the arguments and files.
void run_identify(const IdentifyArguments& arguments);

}  // namespace pellucida
