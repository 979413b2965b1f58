#include "pellucida/core/Table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>

#include "pellucida/core/Error.h"

namespace pellucida {

std::vector<std::string> split_csv(std::string_view line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted) {
      // A doubled quote inside quotes is one quote.
      if (c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
        cells.back() += '"';
        ++i;
      } else if (c == '"') {
        quoted = false;
      } else {
        cells.back() += c;
      }
    } else if (c == '"' && cells.back().empty()) {
      quoted = true;
    } else if (c == ',') {
      cells.emplace_back();
    } else if (c != '\r') {
      cells.back() += c;
    }
  }
  return cells;
}

std::span<const std::string_view> CsvCells::split(std::string_view line) {
  cells_.clear();
  if (line.find_first_of("\"\r") != std::string_view::npos) {
    texts_ = split_csv(line);
    cells_.assign(texts_.begin(), texts_.end());
    return cells_;
  }
  for (;;) {
    const std::size_t comma = line.find(',');
    cells_.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return cells_;
    line.remove_prefix(comma + 1);
  }
}

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string cell = "\"";
  for (const char c : text) {
    if (c == '"') cell += '"';
    cell += (c == '\n' || c == '\r') ? ' ' : c;
  }
  return cell + '"';
}

std::string csv_number(double value) {
  if (std::isnan(value)) return "";
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 9).ptr;
  return std::string(buffer.data(), end);
}

Table Table::read(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file.string() + ": can't be opened; check the path and the permission");
  Table table;
  table.file_ = file.string();

  std::string line;
  if (!std::getline(stream, line)) throw InputError(table.file_ + ": empty; a CSV table starts with a header line");
  // Excel's "CSV UTF-8" begins with a byte order mark.
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (line.starts_with(kByteOrderMark)) line.erase(0, kByteOrderMark.size());
  table.names_ = split_csv(line);

  // Collect the rows, then lay them out as one matrix.
  std::vector<double> values;
  Eigen::Index row_count = 0;
  for (int number = 2; std::getline(stream, line); ++number) {
    if (line.empty() || line == "\r") continue;
    const auto cells = split_csv(line);
    const std::string where = table.file_ + ":" + std::to_string(number);
    if (cells.size() != table.names_.size()) {
      throw InputError(where + ": " + std::to_string(cells.size()) + " cells where the header has " +
                       std::to_string(table.names_.size()) + "; correct or remove the line");
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      double value = std::numeric_limits<double>::quiet_NaN();
      const auto& cell = cells[i];
      const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
      if (!cell.empty() && (code != std::errc() || end != cell.data() + cell.size())) {
        throw InputError(where + ": \"" + cell + "\" in column " + table.names_[i] + " is not a number");
      }
      values.push_back(value);
    }
    ++row_count;
  }
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  table.values_ = Eigen::Map<RowMajor>(values.data(), row_count, static_cast<Eigen::Index>(table.names_.size()));
  return table;
}

bool Table::has(std::string_view name) const noexcept {
  return std::find(names_.begin(), names_.end(), name) != names_.end();
}

Eigen::VectorXd Table::column(std::string_view name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) throw InputError(file_ + ": no column \"" + std::string(name) + "\"");
  return values_.col(found - names_.begin());
}

}  // namespace pellucida
