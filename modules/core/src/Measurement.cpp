#include "pellucida/core/Measurement.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

constexpr std::array<std::string_view, Measurement::kNumberCount> kNumberNames{"confidence",
                                                                               "cell_x_um",
                                                                               "cell_y_um",
                                                                               "axis_deg",
                                                                               "tip_x_um",
                                                                               "tip_y_um",
                                                                               "indentation_um",
                                                                               "dimple_radius_um",
                                                                               "contact_force_uN",
                                                                               "contact_force_lower_uN",
                                                                               "contact_force_upper_uN",
                                                                               "pressure_Pa",
                                                                               "volume_um3",
                                                                               "frame_age_ms",
                                                                               "lateral_force_uN",
                                                                               "stiffness_uN_per_um",
                                                                               "shape_residual_um",
                                                                               "asymmetry_um",
                                                                               "model_spread_percent",
                                                                               "puncture_probability"};

double parse_number(const std::string& cell, std::string_view name) {
  if (cell.empty()) return Measurement::kNotMeasured;
  double value = 0.0;
  const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (code != std::errc() || end != cell.data() + cell.size()) {
    throw InputError("measurements.csv: \"" + cell + "\" in column " + std::string(name) + " is not a number");
  }
  return value;
}

}  // namespace

std::array<double, Measurement::kNumberCount> Measurement::numbers() const noexcept {
  return {confidence,
          cell_x_um,
          cell_y_um,
          axis_deg,
          tip_x_um,
          tip_y_um,
          indentation_um,
          dimple_radius_um,
          contact_force_uN,
          contact_force_lower_uN,
          contact_force_upper_uN,
          pressure_Pa,
          volume_um3,
          frame_age_ms,
          lateral_force_uN,
          stiffness_uN_per_um,
          shape_residual_um,
          asymmetry_um,
          model_spread_percent,
          puncture_probability};
}

void Measurement::set_numbers(const std::array<double, kNumberCount>& values) noexcept {
  double* const targets[] = {&confidence,
                             &cell_x_um,
                             &cell_y_um,
                             &axis_deg,
                             &tip_x_um,
                             &tip_y_um,
                             &indentation_um,
                             &dimple_radius_um,
                             &contact_force_uN,
                             &contact_force_lower_uN,
                             &contact_force_upper_uN,
                             &pressure_Pa,
                             &volume_um3,
                             &frame_age_ms,
                             &lateral_force_uN,
                             &stiffness_uN_per_um,
                             &shape_residual_um,
                             &asymmetry_um,
                             &model_spread_percent,
                             &puncture_probability};
  for (std::size_t i = 0; i < kNumberCount; ++i) *targets[i] = values[i];
}

std::string_view measurement_header() noexcept {
  return "frame,time_s,state,confidence,cell_x_um,cell_y_um,axis_deg,tip_x_um,tip_y_um,indentation_um,dimple_radius_um,"
         "contact_force_uN,contact_force_lower_uN,contact_force_upper_uN,pressure_Pa,volume_um3,frame_age_ms,"
         "lateral_force_uN,stiffness_uN_per_um,shape_residual_um,asymmetry_um,model_spread_percent,"
         "puncture_probability";
}

std::string_view measurement_header_start() noexcept {
  constexpr std::string_view kLastOfFirst = "frame_age_ms";
  const std::string_view header = measurement_header();
  return header.substr(0, header.find(kLastOfFirst) + kLastOfFirst.size());
}

const std::array<std::string_view, Measurement::kNumberCount>& measurement_number_names() noexcept {
  return kNumberNames;
}

std::string to_csv(const Measurement& m) {
  std::string row = std::to_string(m.frame) + ',' + csv_number(m.time_s) + ',' + std::string(to_string(m.state));
  for (const double value : m.numbers()) row += ',' + csv_number(value);
  return row;
}

Measurement measurement_from_csv(std::string_view row) {
  const auto cells = split_csv(row);
  constexpr std::size_t kColumnCount = 3 + Measurement::kFirstNumberCount;
  if (cells.size() < kColumnCount) {
    throw InputError("measurements.csv: a row of " + std::to_string(cells.size()) + " cells; " +
                     std::to_string(kColumnCount) + " are needed");
  }
  Measurement m;
  m.frame = static_cast<long>(parse_number(cells[0], "frame"));
  m.time_s = parse_number(cells[1], "time_s");
  const auto state = cell_state_from_string(cells[2]);
  if (!state) throw InputError("measurements.csv: \"" + cells[2] + "\" in column state is not a state");
  m.state = *state;
  std::array<double, Measurement::kNumberCount> values{};
  values.fill(Measurement::kNotMeasured);
  const std::size_t count = std::min(values.size(), cells.size() - 3);
  for (std::size_t i = 0; i < count; ++i) values[i] = parse_number(cells[3 + i], kNumberNames[i]);
  m.set_numbers(values);
  return m;
}

Measurement measurement_from(const Observation& observation) {
  Measurement m;
  m.frame = observation.frame_index;
  m.time_s = observation.time_s;
  m.state = observation.state;
  m.confidence = observation.confidence;
  if (observation.outer) {
    m.cell_x_um = observation.center_um.x();
    m.cell_y_um = observation.center_um.y();
  }
  if (observation.needle) {
    m.tip_x_um = observation.needle->tip_um.x();
    m.tip_y_um = observation.needle->tip_um.y();
  }
  if (observation.outer && observation.needle) {
    m.axis_deg = std::atan2(observation.axis.y(), observation.axis.x()) * 180.0 / std::numbers::pi;
    m.indentation_um = observation.indentation_um;
    m.dimple_radius_um = observation.dimple_radius_um;
  }
  return m;
}

}  // namespace pellucida
