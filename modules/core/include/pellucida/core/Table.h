#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pellucida {

/// A numeric CSV file: one header line, then rows of numbers; an empty cell reads as NaN.
class Table {
 public:
  /// Throws InputError (file, line, column) when the file can't be read or a cell is not a number.
  static Table read(const std::filesystem::path& file);

  /// Values of a column, one per row. Throws InputError when there is no such column.
  Eigen::VectorXd column(std::string_view name) const;
  bool has(std::string_view name) const noexcept;
  Eigen::Index rows() const noexcept { return values_.rows(); }
  const std::vector<std::string>& names() const noexcept { return names_; }

 private:
  std::string file_;
  std::vector<std::string> names_;
  Eigen::MatrixXd values_;  // (rows x columns)
};

/// Splits a CSV line at its commas; a cell in double quotes may hold commas and doubled quotes.
std::vector<std::string> split_csv(std::string_view line);

/// The same for many lines, without memory of its own for the cells of a line that has no quotes.
class CsvCells {
 public:
  /// At least one cell. The cells are valid until the next call, and as long as `line` is.
  std::span<const std::string_view> split(std::string_view line);

 private:
  std::vector<std::string_view> cells_;
  std::vector<std::string> texts_;
};

/// `text` as a CSV cell: quoted when it holds a comma, a quote or a line end.
std::string csv_cell(std::string_view text);

/// A number with 9 significant digits, shortest form, "" for NaN.
std::string csv_number(double value);

}  // namespace pellucida
