#include "pellucida/core/Measurement.h"

#include <charconv>
#include <cmath>
#include <numbers>

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

using M = Measurement;
constexpr FieldNeed kFirst = FieldNeed::kRequired;  // in every session
constexpr FieldRange kAny;
constexpr Field<M> kColumns[] = {
    {"confidence", "0..1", &M::confidence, {0, 1}, "confidence in the frame as a whole", kFirst},
    {"cell_x_um", "um", &M::cell_x_um, kAny, "centre of the outer membrane at rest, moving with the cell", kFirst},
    {"cell_y_um", "um", &M::cell_y_um, kAny, "the same, down", kFirst},
    {"axis_deg", "degrees", &M::axis_deg, kAny,
     "direction from the cell's centre to the needle; 0 = +x, positive towards +y", kFirst},
    {"tip_x_um", "um", &M::tip_x_um, kAny, "the needle's tip", kFirst},
    {"tip_y_um", "um", &M::tip_y_um, kAny, "the same, down", kFirst},
    {"indentation_um", "um", &M::indentation_um, kAny,
     "displacement of the contact point along the axis, with the cell's rigid motion removed; at least 0", kFirst},
    {"dimple_radius_um", "um", &M::dimple_radius_um, kAny, "radius of the dimple's mouth; 0 without contact", kFirst},
    {"contact_force_uN", "uN", &M::contact_force_uN, kAny,
     "force of the needle on the cell along its push; 0 when free or punctured", kFirst},
    {"contact_force_lower_uN", "uN", &M::contact_force_lower_uN, kAny,
     "lower end of its 95 % interval, the whole: picture and scale", kFirst},
    {"contact_force_upper_uN", "uN", &M::contact_force_upper_uN, kAny, "upper end of it", kFirst},
    {"pressure_Pa", "Pa", &M::pressure_Pa, kAny, "excess pressure inside the cell", kFirst},
    {"volume_um3", "um^3", &M::volume_um3, kAny, "volume enclosed by the outer membrane", kFirst},
    {"frame_age_ms", "ms", &M::frame_age_ms, kAny, "time from the frame's arrival to this row", kFirst},
    {"lateral_force_uN", "uN", &M::lateral_force_uN, kAny,
     "force of the needle on the cell across its push, computed from the model; the magnitude of the whole force is "
     "`sqrt(contact_force_uN^2 + lateral_force_uN^2)`"},
    {"stiffness_uN_per_um", "uN/um", &M::stiffness_uN_per_um, kAny, "tangent stiffness along the push; 0 when free"},
    {"shape_residual_um", "um", &M::shape_residual_um, kAny,
     "RMS distance of the tracked contour from the model's section"},
    {"asymmetry_um", "um", &M::asymmetry_um, kAny,
     "RMS of the part of the contour that no surface of revolution about the axis through the contact point can show"},
    {"model_spread_percent", "%", &M::model_spread_percent, kAny,
     "how far three models of the force differ: this one, the point-load formula, the finite-element table; standard "
     "deviation over mean. For comparison only: no part of the interval. The formula takes the zona for a flat, "
     "clamped membrane, so 30 to 50 % are usual on a good measurement "
     "([method.md](method.md#38-from-the-contour-to-the-force))"},
    {"puncture_probability",
     "0..1",
     &M::puncture_probability,
     {0, 1},
     "probability that a force like this punctures the membrane; only if the cell's own scale was measured"},
    {"contact_force_picture_lower_uN", "uN", &M::contact_force_picture_lower_uN, kAny,
     "lower end of the 95 % interval of what the picture leaves open (depth, shape, geometry, model): for comparing "
     "forces of one cell with each other"},
    {"contact_force_picture_upper_uN", "uN", &M::contact_force_picture_upper_uN, kAny, "upper end of it"},
    {"contact_force_scale_lower_uN", "uN", &M::contact_force_scale_lower_uN, kAny,
     "lower end of the 95 % interval of what the scale leaves open (how single cells of the kind differ; less once "
     "this "
     "cell's scale was measured): one factor on all forces of a cell"},
    {"contact_force_scale_upper_uN", "uN", &M::contact_force_scale_upper_uN, kAny, "upper end of it"},
    {"expected_puncture_uN", "uN", &M::expected_puncture_uN, kAny,
     "force at which a cell of these sizes is expected to give way under this needle; log-normal about it, by 35 % and "
     "more ([method.md](method.md#38-from-the-contour-to-the-force))"},
    {"expected_puncture_um", "um", &M::expected_puncture_um, kAny, "indentation at which this cell bears that force"},
    {"manipulator_x_um", "um", &M::manipulator_x_um, kAny,
     "where the manipulator reported the tip at the frame's time, to 1 nm; only while one moves the needle. Known "
     "before the frame was measured: evidence for the tracker, not a measurement"},
    {"manipulator_y_um", "um", &M::manipulator_y_um, kAny, "the same, down"},
    {"strain_stiffening", "", &M::strain_stiffening, kAny,
     "how the zona stiffens with strain, as the contours of this contact have shown so far: b of its law "
     "mu/(2 b) (exp(b (I1 - 3)) - 1), 0 if it does not ([method.md](method.md#38-from-the-contour-to-the-force)); only "
     "where the needle comes from opposite the holding pipette"},
    {"strain_stiffening_lower", "", &M::strain_stiffening_lower, kAny, "lower end of its 95 % interval"},
    {"strain_stiffening_upper", "", &M::strain_stiffening_upper, kAny, "upper end of it"},
};

double M::*number_of(const Field<M>& column) {
  return std::get<double M::*>(column.member);
}

// The header of all columns, or of those in every session.
std::string header_of(bool all) {
  std::string header = "frame,time_s,state";
  for (const auto& column : kColumns)
    if (all || column.need == kFirst) header += ',' + std::string(column.name);
  return header;
}

double parse_number(std::string_view cell, std::string_view name) {
  if (cell.empty()) return Measurement::kNotMeasured;
  double value = 0.0;
  const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (code != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
    throw InputError("measurements.csv: \"" + std::string(cell) + "\" in column " + std::string(name) +
                     " is not a number");
  }
  return value;
}

}  // namespace

std::span<const Field<Measurement>> measurement_columns() noexcept {
  return kColumns;
}

std::string_view measurement_header() {
  static const std::string header = header_of(true);
  return header;
}

std::string_view measurement_header_start() {
  static const std::string header = header_of(false);
  return header;
}

std::string to_csv(const Measurement& m) {
  std::string row = std::to_string(m.frame) + ',' + csv_number(m.time_s) + ',' +
                    (m.state ? std::string(to_string(*m.state)) : std::string());
  for (const auto& column : kColumns) row += ',' + csv_number(m.*number_of(column));
  return row;
}

Measurement measurement_from_csv(std::string_view row) {
  CsvCells cells;
  return measurement_from_cells(cells.split(row));
}

Measurement measurement_from_cells(std::span<const std::string_view> cells) {
  static const std::size_t kColumnCount = split_csv(measurement_header_start()).size();
  if (cells.size() < kColumnCount) {
    throw InputError("measurements.csv: a row of " + std::to_string(cells.size()) + " cells; " +
                     std::to_string(kColumnCount) + " are needed");
  }
  Measurement m;
  m.frame = static_cast<long>(parse_number(cells[0], "frame"));
  m.time_s = parse_number(cells[1], "time_s");
  m.state = cell_state_from_string(cells[2]);
  if (!m.state && !cells[2].empty()) {
    throw InputError("measurements.csv: \"" + std::string(cells[2]) + "\" in column state is not a state");
  }
  for (std::size_t i = 0; i < std::size(kColumns); ++i) {
    const std::size_t cell = 3 + i;
    m.*number_of(kColumns[i]) =
        cell < cells.size() ? parse_number(cells[cell], kColumns[i].name) : Measurement::kNotMeasured;
  }
  return m;
}

ForceSpread force_spread(const Measurement& m) noexcept {
  // Half the width of a 95 % interval is 1.96 standard deviations.
  const auto ratio = [&](double lower_uN, double upper_uN) {
    return m.contact_force_uN > 0.0 ? (upper_uN - lower_uN) / (2.0 * 1.96 * m.contact_force_uN)
                                    : Measurement::kNotMeasured;
  };
  ForceSpread spread;
  spread.picture_ratio = ratio(m.contact_force_picture_lower_uN, m.contact_force_picture_upper_uN);
  // The scale's is of the logarithm, and large: there the width is no measure of it.
  if (m.contact_force_uN > 0.0 && m.contact_force_scale_lower_uN > 0.0) {
    spread.scale_ratio = std::log(m.contact_force_scale_upper_uN / m.contact_force_scale_lower_uN) / (2.0 * 1.96);
  }
  spread.is_own_scale = std::isfinite(m.puncture_probability);
  return spread;
}

std::string to_string(const ForceSpread& spread) {
  if (!std::isfinite(spread.picture_ratio) || !std::isfinite(spread.scale_ratio)) return {};
  const auto percent = [](double ratio) { return std::to_string(std::lround(100.0 * ratio)) + " %"; };
  return "picture +-" + percent(spread.picture_ratio) + (spread.is_own_scale ? ", this cell +-" : ", kind of cell +-") +
         percent(spread.scale_ratio);
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
