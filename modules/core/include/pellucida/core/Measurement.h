#pragma once
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "pellucida/core/Observation.h"

namespace pellucida {

template <class S>
struct Field;  // FieldTable.h

/// One row of `measurements.csv`: the numbers of one frame. NaN means "not measured" and is written as an empty cell.
/// Meaning and unit of each: `measurement_columns`, printed in docs/file-format.md.
struct Measurement {
  static constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

  long frame = 0;
  double time_s = 0.0;
  std::optional<CellState> state;  ///< nothing for a frame that was kept but not measured: an empty cell
  double confidence = kNotMeasured;
  double cell_x_um = kNotMeasured;
  double cell_y_um = kNotMeasured;
  double axis_deg = kNotMeasured;
  double tip_x_um = kNotMeasured;
  double tip_y_um = kNotMeasured;
  double indentation_um = kNotMeasured;
  double dimple_radius_um = kNotMeasured;
  double contact_force_uN = kNotMeasured;
  double contact_force_lower_uN = kNotMeasured;
  double contact_force_upper_uN = kNotMeasured;
  double pressure_Pa = kNotMeasured;
  double volume_um3 = kNotMeasured;
  double frame_age_ms = kNotMeasured;

  // Later columns; a session of an earlier version lacks them.
  double lateral_force_uN = kNotMeasured;
  double stiffness_uN_per_um = kNotMeasured;
  double shape_residual_um = kNotMeasured;
  double asymmetry_um = kNotMeasured;
  double model_spread_percent = kNotMeasured;
  double puncture_probability = kNotMeasured;
  double contact_force_picture_lower_uN = kNotMeasured;
  double contact_force_picture_upper_uN = kNotMeasured;
  double contact_force_scale_lower_uN = kNotMeasured;
  double contact_force_scale_upper_uN = kNotMeasured;
  double expected_puncture_uN = kNotMeasured;
  double expected_puncture_um = kNotMeasured;
  double manipulator_x_um = kNotMeasured;
  double manipulator_y_um = kNotMeasured;
  double strain_stiffening = kNotMeasured;
  double strain_stiffening_lower = kNotMeasured;
  double strain_stiffening_upper = kNotMeasured;
};

/// The two parts of a force's uncertainty as standard deviations over the force, from their 95 % intervals; NaN where
/// there is no force above 0, or where an earlier version measured it.
struct ForceSpread {
  double picture_ratio = Measurement::kNotMeasured;  ///< depth, geometry, model: between forces of one cell
  double scale_ratio = Measurement::kNotMeasured;    ///< of this kind of cell, or of this one: against other cells
  bool is_own_scale = false;                         ///< the cell's own scale was measured
};
ForceSpread force_spread(const Measurement& m) noexcept;
/// "picture +-9 %, kind of cell +-46 %", or "..., this cell +-8 %" with a scale of its own; empty without numbers.
std::string to_string(const ForceSpread& spread);

/// The numeric columns after `frame`, `time_s` and `state`, in the order of the header; those required are in every
/// session.
std::span<const Field<Measurement>> measurement_columns() noexcept;

/// The header line of `measurements.csv` (a contract), without line end.
std::string_view measurement_header();
/// The beginning of the header common to the sessions of all versions.
std::string_view measurement_header_start();
/// One row, comma separated, shortest digits that read back to the same number to 9 significant figures, no line end.
std::string to_csv(const Measurement& m);
/// The inverse of `to_csv`. Columns after the known ones are ignored; later columns may be missing.
/// Throws InputError when a cell is not what its column holds; the text names the column.
Measurement measurement_from_csv(std::string_view row);
/// The same of a row's cells.
Measurement measurement_from_cells(std::span<const std::string_view> cells);

/// The part of a row that comes from the tracker alone.
Measurement measurement_from(const Observation& observation);

}  // namespace pellucida
