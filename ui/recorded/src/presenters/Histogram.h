#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "pellucida/charts_vtk/CurveChart.h"
#include "presenters/RecordedSession.h"

class vtkPolyData;

namespace pellucida {

/// What can be counted: numbers of the session's frames, then those of the nodes in one frame.
enum class Quantity {
  kForce,
  kForceHalfWidth,  ///< half the 95 % interval of the force
  kIndentation,
  kPressure,
  kStiffness,
  kConfidence,
  kNodeForce,
  kNodeForceSigma,
  kNodeTension,
  kNodeDisplacement,
};
inline constexpr std::array kQuantities{Quantity::kForce,           Quantity::kForceHalfWidth, Quantity::kIndentation,
                                        Quantity::kPressure,        Quantity::kStiffness,      Quantity::kConfidence,
                                        Quantity::kNodeForce,       Quantity::kNodeForceSigma, Quantity::kNodeTension,
                                        Quantity::kNodeDisplacement};
/// "Force", "Force of the nodes".
std::string name_of(Quantity quantity);
/// Whether it is counted over the nodes of a frame.
bool is_of_nodes(Quantity quantity) noexcept;
/// Of one frame; NaN where it was not measured. Precondition: not of nodes.
double value_of(const Measurement& row, Quantity quantity) noexcept;

/// Finite numbers, sorted, and what they are.
struct Sample {
  Quantity quantity = Quantity::kForce;
  std::vector<double> values;
};
/// Over the session's frames. A force counts in contact alone: elsewhere it is 0 by definition.
Sample sample_of(const RecordedSession& session, Quantity quantity);
/// Over the nodes of a surface, which may be null.
Sample sample_of(vtkPolyData* surface, Quantity quantity);

/// Counts in intervals of one width, which is round: after Freedman and Diaconis, 5 to 60 of them.
struct Histogram {
  double begin = 0.0;
  double width = 0.0;  ///< 0: there is nothing to count
  std::vector<std::size_t> counts;
};
Histogram histogram_of(const Sample& sample);

/// The histogram as a chart: steps, filled; median and quartiles marked.
CurveChartData histogram_chart(const Sample& sample);
/// "312 frames · median 1.23 µN · quartiles 0.87 to 1.64 · 5 to 95 %: 0.21 to 2.30"; for no numbers, that.
std::string histogram_facts(const Sample& sample);
/// `from,to,count`, the unit in the names. Throws OutputError.
void write_histogram(const Sample& sample, const std::filesystem::path& file);

}  // namespace pellucida
