#include "ReferenceTables.h"

#include <cstdio>
#include <fstream>

#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::filesystem::path in_folder(const std::filesystem::path& folder, const std::string& name) {
  std::error_code ignored;  // a folder that can't be made shows when the file is opened
  std::filesystem::create_directories(folder, ignored);
  return folder / name;
}

void finish(std::ofstream& file, const std::filesystem::path& name) {
  file.close();
  if (!file) throw OutputError(name.string() + ": can't be written; check the folder and its permissions");
}

}  // namespace

void write_reference_tables(const ShellReference& reference, const ShellCurve& curve,
                            const std::filesystem::path& folder, const std::string& stem) {
  const auto force_name = in_folder(folder, stem + "-force.csv");
  std::ofstream force(force_name);
  force << "indentation_um,force_uN,lateral_force_uN,pressure_kPa\n";
  for (const ShellStep& step : curve.steps) {
    force << csv_number(step.indentation_um) << ',' << fixed(step.axial_force_uN, 6) << ','
          << fixed(step.lateral_force_uN, 6) << ',' << fixed(step.pressure_kPa, 8) << '\n';
  }
  finish(force, force_name);

  const auto profile_name = in_folder(folder, stem + "-profile.csv");
  std::ofstream profile(profile_name);
  profile << "indentation_um,theta0_rad,x_mid_um,z_mid_um\n";
  for (const ShellStep& step : curve.steps) {
    const ShellSection section = reference.section(step);
    for (Eigen::Index k = 0; k < section.mid_um.cols(); ++k) {
      profile << csv_number(step.indentation_um) << ',' << fixed(section.rest_angle_rad[k], 6) << ','
              << fixed(section.mid_um(0, k), 4) << ',' << fixed(section.mid_um(1, k), 4) << '\n';
    }
  }
  finish(profile, profile_name);
}

void write_reference_tables(const SolidReference& reference, const SolidCurve& curve,
                            const std::filesystem::path& folder, const std::string& stem) {
  const auto force_name = in_folder(folder, stem + "-force.csv");
  std::ofstream force(force_name);
  force << "indentation_um,force_uN,pressure_kPa\n";
  for (const SolidStep& step : curve.steps) {
    force << csv_number(step.indentation_um) << ',' << fixed(step.force_uN, 6) << ',' << fixed(step.pressure_kPa, 8)
          << '\n';
  }
  finish(force, force_name);

  const auto profile_name = in_folder(folder, stem + "-profile.csv");
  std::ofstream profile(profile_name);
  profile << "indentation_um,theta0_rad,outer_r_um,outer_z_um,inner_r_um,inner_z_um\n";
  for (const SolidStep& step : curve.steps) {
    for (Eigen::Index k = 0; k < reference.rest_angle_rad().size(); ++k) {
      profile << csv_number(step.indentation_um) << ',' << fixed(reference.rest_angle_rad()[k], 6);
      for (const auto* face : {&step.outer_um, &step.inner_um}) {
        profile << ',' << fixed((*face)(0, k), 4) << ',' << fixed((*face)(1, k), 4);
      }
      profile << '\n';
    }
  }
  finish(profile, profile_name);
}

}  // namespace pellucida
