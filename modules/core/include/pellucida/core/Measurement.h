#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

#include "pellucida/core/Observation.h"

namespace pellucida {

/// One row of `measurements.csv`: the numbers of one frame. NaN means "not measured" and is written as an empty cell.
struct Measurement {
  static constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

  long frame = 0;
  double time_s = 0.0;
  CellState state = CellState::kNoCell;
  double confidence = 0.0;          ///< 0..1
  double cell_x_um = kNotMeasured;  ///< centre of the outer membrane at rest, moving with the cell
  double cell_y_um = kNotMeasured;
  double axis_deg = kNotMeasured;  ///< from cell centre to needle; 0 = +x, positive towards +y
  double tip_x_um = kNotMeasured;
  double tip_y_um = kNotMeasured;
  double indentation_um = kNotMeasured;  ///< >= 0
  double dimple_radius_um = kNotMeasured;
  double contact_force_uN = kNotMeasured;        ///< force of the needle on the cell along its push; 0 when free
  double contact_force_lower_uN = kNotMeasured;  ///< 95 % interval
  double contact_force_upper_uN = kNotMeasured;
  double pressure_Pa = kNotMeasured;   ///< excess pressure inside the cell
  double volume_um3 = kNotMeasured;    ///< enclosed by the outer membrane
  double frame_age_ms = kNotMeasured;  ///< from the frame's arrival to this row

  // Later columns; a session of an earlier version lacks them.
  double lateral_force_uN = kNotMeasured;      ///< magnitude of the force of the needle on the cell across its push
  double stiffness_uN_per_um = kNotMeasured;   ///< tangent stiffness felt along the push; 0 when free
  double shape_residual_um = kNotMeasured;     ///< RMS distance of the tracked contour from the model's section
  double asymmetry_um = kNotMeasured;          ///< what of the contour a surface of revolution can't show, RMS
  double model_spread_percent = kNotMeasured;  ///< disagreement of the models of the force, % of their mean
  double puncture_probability = kNotMeasured;  ///< 0..1, that this force punctures; only where a cell was palpated

  /// The numeric columns between `state` and the end, in the order of the header; the first of them are in every
  /// session.
  static constexpr std::size_t kNumberCount = 20;
  static constexpr std::size_t kFirstNumberCount = 14;
  std::array<double, kNumberCount> numbers() const noexcept;
  void set_numbers(const std::array<double, kNumberCount>& values) noexcept;
};

/// The header line of `measurements.csv` (a contract), without line end.
std::string_view measurement_header() noexcept;
/// How the header of every session begins, also of an earlier version's.
std::string_view measurement_header_start() noexcept;
/// Names of the numeric columns, in order.
const std::array<std::string_view, Measurement::kNumberCount>& measurement_number_names() noexcept;

/// One row, comma separated, shortest digits that read back to the same number to 9 significant figures, no line end.
std::string to_csv(const Measurement& m);
/// The inverse of `to_csv`. Columns after the known ones are ignored; later columns may be missing.
/// Throws InputError when a cell is not what its column holds; the text names the column.
Measurement measurement_from_csv(std::string_view row);

/// The part of a row that the tracker alone knows.
Measurement measurement_from(const Observation& observation);

}  // namespace pellucida
