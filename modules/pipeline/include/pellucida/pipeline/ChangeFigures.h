#pragma once
#include <span>
#include <string>
#include <string_view>

#include "pellucida/core/FieldTable.h"
#include "pellucida/core/Measurement.h"

namespace pellucida {

/// What is different between a session and its replay: one row of `changes.csv`. NaN: nothing to compare.
struct ChangeFigures {
  static constexpr double kNone = Measurement::kNotMeasured;

  int frame_count = 0;
  int equal_row_count = 0;
  int state_change_count = 0;
  int force_count = 0;
  int force_lost_count = 0;
  int force_new_count = 0;
  double recorded_peak_force_uN = kNone;
  double peak_force_uN = kNone;
  double recorded_peak_time_s = kNone;
  double peak_time_s = kNone;
  double force_ratio = kNone;
  double force_rms_uN = kNone;
  double largest_force_uN = kNone;
  int largest_force_frame = -1;
  double indentation_rms_um = kNone;
  double largest_contour_um = kNone;
  double largest_displacement_um = kNone;
  double largest_node_force_uN = kNone;
};

/// The columns of `changes.csv` after `variant`, with unit and meaning.
std::span<const Field<ChangeFigures>> change_columns() noexcept;
std::string change_header();
std::string to_csv(std::string_view variant, const ChangeFigures& figures);

/// Collects the changes of one replay, frame by frame.
class ChangeLog {
 public:
  void add(const Measurement& recorded, const Measurement& replayed);
  /// Largest differences of one frame's fields; NaN for none.
  void add_fields(double contour_um, double displacement_um, double node_force_uN);

  ChangeFigures figures() const;
  /// `differences.csv`: every number of both, a row a frame.
  const std::string& table() const noexcept { return table_; }
  static std::string table_header();

 private:
  ChangeFigures figures_;
  double force_square_sum_ = 0.0, force_product_sum_ = 0.0, recorded_square_sum_ = 0.0;
  double indentation_square_sum_ = 0.0;
  int indentation_count_ = 0;
  std::string table_;
};

/// True when both rows are written with the same digits, their `frame_age_ms` aside: the age belongs to the computer.
bool equal_as_written(const Measurement& one, const Measurement& other);

}  // namespace pellucida
