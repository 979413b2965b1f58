#include "pellucida/teaching/SnakeField.h"

#include <algorithm>
#include <utility>

namespace pellucida {

SnakeField::SnakeField(Eigen::ArrayXXd energy) : energy_(std::move(energy)) {
  const Eigen::Index rows = energy_.rows(), columns = energy_.cols();
  along_x_.setZero(rows, columns);
  along_y_.setZero(rows, columns);
  along_x_.middleCols(1, columns - 2) = 0.5 * (energy_.rightCols(columns - 2) - energy_.leftCols(columns - 2));
  along_y_.middleRows(1, rows - 2) = 0.5 * (energy_.bottomRows(rows - 2) - energy_.topRows(rows - 2));
}

double SnakeField::sample(const Eigen::ArrayXXd& values, const Eigen::Vector2d& place_px) {
  const double x = std::clamp(place_px.x(), 0.0, static_cast<double>(values.cols() - 1));
  const double y = std::clamp(place_px.y(), 0.0, static_cast<double>(values.rows() - 1));
  const auto column = std::min(static_cast<Eigen::Index>(x), values.cols() - 2);
  const auto row = std::min(static_cast<Eigen::Index>(y), values.rows() - 2);
  const double u = x - static_cast<double>(column), v = y - static_cast<double>(row);
  return (1.0 - v) * ((1.0 - u) * values(row, column) + u * values(row, column + 1)) +
         v * ((1.0 - u) * values(row + 1, column) + u * values(row + 1, column + 1));
}

}  // namespace pellucida
