#pragma once
#include <Eigen/Core>
#include <filesystem>

namespace pellucida {

/// A measured force-indentation curve, needle opposite the holder (configuration 1).
struct MeasuredCurve {
  Eigen::VectorXd indentation_um;  ///< (n) rising, at least 0
  Eigen::VectorXd force_uN;        ///< (n)
};

/// Reads a CSV file with the columns `indentation_um` and `force_uN` (others are ignored; rows in any order). Throws
/// InputError, with file and reason, when a column is missing, a number isn't one, an indentation is negative, or fewer
/// than three points lie beyond rest.
MeasuredCurve read_measured_curve(const std::filesystem::path& file);

}  // namespace pellucida
