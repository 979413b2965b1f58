#include "pellucida/pipeline/ChangeFigures.h"

#include <cmath>

#include "pellucida/core/FieldCsv.h"

namespace pellucida {
namespace {

using C = ChangeFigures;
constexpr FieldRange kAnyChange;
constexpr Field<C> kChangeColumns[] = {
    {"frames", "", &C::frame_count, kAnyChange, "frames replayed"},
    {"equal_rows", "", &C::equal_row_count, kAnyChange,
     "of them, with the same row of `measurements.csv` to the last digit (`frame_age_ms` aside)"},
    {"state_changes", "", &C::state_change_count, kAnyChange, "of them, with another state"},
    {"forces", "", &C::force_count, kAnyChange, "of them, with a force in both"},
    {"forces_lost", "", &C::force_lost_count, kAnyChange, "with a force in the recording alone"},
    {"forces_new", "", &C::force_new_count, kAnyChange, "with a force in the replay alone"},
    {"recorded_peak_force_uN", "uN", &C::recorded_peak_force_uN, kAnyChange, "largest contact force recorded"},
    {"peak_force_uN", "uN", &C::peak_force_uN, kAnyChange, "largest contact force of the replay"},
    {"recorded_peak_time_s", "s", &C::recorded_peak_time_s, kAnyChange, "when it was recorded"},
    {"peak_time_s", "s", &C::peak_time_s, kAnyChange, "when it is in the replay"},
    {"force_ratio", "", &C::force_ratio, kAnyChange, "replayed force over recorded force, by least squares"},
    {"force_rms_uN", "uN", &C::force_rms_uN, kAnyChange, "RMS difference of the contact force"},
    {"largest_force_difference_uN", "uN", &C::largest_force_uN, kAnyChange,
     "largest difference of the contact force, with its sign"},
    {"largest_force_difference_frame", "", &C::largest_force_frame, kAnyChange, "its frame; -1 for none"},
    {"indentation_rms_um", "um", &C::indentation_rms_um, kAnyChange, "RMS difference of the indentation"},
    {"largest_contour_difference_um", "um", &C::largest_contour_um, kAnyChange,
     "farthest that a point of a contour lies from the recorded contour"},
    {"largest_displacement_difference_um", "um", &C::largest_displacement_um, kAnyChange,
     "largest difference of a node's displacement"},
    {"largest_node_force_difference_uN", "uN", &C::largest_node_force_uN, kAnyChange,
     "largest difference of the force on a node"},
};

double number_in(const Measurement& row, const Field<Measurement>& column) {
  return row.*std::get<double Measurement::*>(column.member);
}

bool is_compared(const Field<Measurement>& column) {
  return column.name != "frame_age_ms";
}

/// The larger magnitude of the two, with NaN as none.
double larger(double one, double other) {
  return std::isnan(one) || std::abs(other) > std::abs(one) ? other : one;
}

}  // namespace

std::span<const Field<ChangeFigures>> change_columns() noexcept {
  return kChangeColumns;
}

std::string change_header() {
  return "variant," + csv_header(change_columns());
}

std::string to_csv(std::string_view variant, const ChangeFigures& figures) {
  return csv_cell(variant) + ',' + csv_row(change_columns(), figures);
}

bool equal_as_written(const Measurement& one, const Measurement& other) {
  Measurement a = one, b = other;
  a.frame_age_ms = b.frame_age_ms = Measurement::kNotMeasured;
  return to_csv(a) == to_csv(b);
}

std::string ChangeLog::table_header() {
  std::string header = "frame,time_s,recorded_state,state";
  for (const auto& column : measurement_columns()) {
    if (!is_compared(column)) continue;
    const std::string name(column.name);
    header += ",recorded_" + name + ",difference_" + name;
  }
  return header;
}

void ChangeLog::add(const Measurement& recorded, const Measurement& replayed) {
  ++figures_.frame_count;
  if (equal_as_written(recorded, replayed)) ++figures_.equal_row_count;
  if (recorded.state != replayed.state) ++figures_.state_change_count;

  const double before_uN = recorded.contact_force_uN, now_uN = replayed.contact_force_uN;
  if (std::isnan(now_uN) && !std::isnan(before_uN)) ++figures_.force_lost_count;
  if (!std::isnan(now_uN) && std::isnan(before_uN)) ++figures_.force_new_count;
  if (!std::isnan(before_uN) && !(before_uN <= figures_.recorded_peak_force_uN)) {
    figures_.recorded_peak_force_uN = before_uN;
    figures_.recorded_peak_time_s = recorded.time_s;
  }
  if (!std::isnan(now_uN) && !(now_uN <= figures_.peak_force_uN)) {
    figures_.peak_force_uN = now_uN;
    figures_.peak_time_s = replayed.time_s;
  }
  if (!std::isnan(before_uN) && !std::isnan(now_uN)) {
    const double difference_uN = now_uN - before_uN;
    ++figures_.force_count;
    force_square_sum_ += difference_uN * difference_uN;
    force_product_sum_ += now_uN * before_uN;
    recorded_square_sum_ += before_uN * before_uN;
    if (!(std::abs(difference_uN) <= std::abs(figures_.largest_force_uN))) {
      figures_.largest_force_uN = difference_uN;
      figures_.largest_force_frame = static_cast<int>(replayed.frame);
    }
  }
  const double deeper_um = replayed.indentation_um - recorded.indentation_um;
  if (!std::isnan(deeper_um)) {
    indentation_square_sum_ += deeper_um * deeper_um;
    ++indentation_count_;
  }

  const auto name_of = [](const Measurement& row) { return row.state ? std::string(to_string(*row.state)) : ""; };
  table_ += std::to_string(replayed.frame) + ',' + csv_number(replayed.time_s) + ',' + name_of(recorded) + ',' +
            name_of(replayed);
  for (const auto& column : measurement_columns()) {
    if (!is_compared(column)) continue;
    const double before = number_in(recorded, column);
    table_ += ',' + csv_number(before) + ',' + csv_number(number_in(replayed, column) - before);
  }
  table_ += '\n';
}

void ChangeLog::add_fields(double contour_um, double displacement_um, double node_force_uN) {
  figures_.largest_contour_um = larger(figures_.largest_contour_um, contour_um);
  figures_.largest_displacement_um = larger(figures_.largest_displacement_um, displacement_um);
  figures_.largest_node_force_uN = larger(figures_.largest_node_force_uN, node_force_uN);
}

ChangeFigures ChangeLog::figures() const {
  ChangeFigures figures = figures_;
  if (figures.force_count > 0) figures.force_rms_uN = std::sqrt(force_square_sum_ / figures.force_count);
  if (recorded_square_sum_ > 0.0) figures.force_ratio = force_product_sum_ / recorded_square_sum_;
  if (indentation_count_ > 0) figures.indentation_rms_um = std::sqrt(indentation_square_sum_ / indentation_count_);
  return figures;
}

}  // namespace pellucida
