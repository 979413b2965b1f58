#include "presenters/Histogram.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

#include "pellucida/core/OutputFile.h"
#include "pellucida/core/RoundNumbers.h"
#include "pellucida/core/Statistics.h"
#include "pellucida/core/Table.h"
#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"
#include "presenters/SurfaceNode.h"

namespace pellucida {
namespace {

constexpr double kFewestBins = 5.0, kMostBins = 60.0;

struct QuantityName {
  const char* name;
  const char* title;  // of the axis
  const char* unit;
  const char* column;  // of the table
};
// In the order of `Quantity`.
constexpr QuantityName kQuantityNames[] = {
    {PELLUCIDA_WORDS("Force"), PELLUCIDA_WORDS("Force (µN)"), " µN", "force_uN"},
    {PELLUCIDA_WORDS("Half-width of the force's interval"), PELLUCIDA_WORDS("Half the 95 % interval (µN)"), " µN",
     "half_width_uN"},
    {PELLUCIDA_WORDS("Indentation"), PELLUCIDA_WORDS("Indentation (µm)"), " µm", "indentation_um"},
    {PELLUCIDA_WORDS("Pressure"), PELLUCIDA_WORDS("Pressure (Pa)"), " Pa", "pressure_Pa"},
    {PELLUCIDA_WORDS("Stiffness"), PELLUCIDA_WORDS("Stiffness (µN/µm)"), " µN/µm", "stiffness_uN_per_um"},
    {PELLUCIDA_WORDS("Confidence"), PELLUCIDA_WORDS("Confidence (%)"), " %", "confidence_percent"},
    {PELLUCIDA_WORDS("Force of the nodes"), PELLUCIDA_WORDS("Force of a node (µN)"), " µN", "node_force_uN"},
    {PELLUCIDA_WORDS("Sigma of the nodes' forces"), PELLUCIDA_WORDS("Sigma of a node's force (µN)"), " µN",
     "node_force_sigma_uN"},
    {PELLUCIDA_WORDS("Tension of the nodes"), PELLUCIDA_WORDS("Tension at a node (µN/µm)"), " µN/µm",
     "node_tension_uN_per_um"},
    {PELLUCIDA_WORDS("Displacement of the nodes"), PELLUCIDA_WORDS("Displacement of a node (µm)"), " µm",
     "node_displacement_um"},
};

const QuantityName& names_of(Quantity quantity) {
  return kQuantityNames[static_cast<std::size_t>(quantity)];
}

double node_value(const SurfaceNode& node, Quantity quantity) {
  if (quantity == Quantity::kNodeForceSigma) return node.force_sigma_uN;
  if (quantity == Quantity::kNodeTension) return node.tension_uN_per_um;
  if (quantity == Quantity::kNodeDisplacement) return node.displacement_um;
  return node.force_magnitude_uN;
}

void add_finite(Sample& sample, double value) {
  if (std::isfinite(value)) sample.values.push_back(value);
}

// Three figures, as few as a number needs.
std::string three_figures(double value) {
  if (value == 0.0) return "0";
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
  return readout::plain(std::round(value / unit) * unit);
}

}  // namespace

std::string name_of(Quantity quantity) {
  return say(names_of(quantity).name);
}

bool is_of_nodes(Quantity quantity) noexcept {
  return quantity >= Quantity::kNodeForce;
}

double value_of(const Measurement& row, Quantity quantity) noexcept {
  switch (quantity) {
    case Quantity::kForce:
      return row.state == CellState::kContact ? row.contact_force_uN : Measurement::kNotMeasured;
    case Quantity::kForceHalfWidth:
      return row.state == CellState::kContact ? 0.5 * (row.contact_force_upper_uN - row.contact_force_lower_uN)
                                              : Measurement::kNotMeasured;
    case Quantity::kIndentation:
      return row.state == CellState::kContact ? row.indentation_um : Measurement::kNotMeasured;
    case Quantity::kPressure:
      return row.pressure_Pa;
    case Quantity::kStiffness:
      return row.stiffness_uN_per_um;
    case Quantity::kConfidence:
      return 100.0 * row.confidence;
    default:
      return Measurement::kNotMeasured;
  }
}

Sample sample_of(const RecordedSession& session, Quantity quantity) {
  Sample sample{quantity, {}};
  for (const Measurement& row : session.rows) add_finite(sample, value_of(row, quantity));
  std::sort(sample.values.begin(), sample.values.end());
  return sample;
}

Sample sample_of(vtkPolyData* surface, Quantity quantity) {
  Sample sample{quantity, {}};
  for (long i = 0; surface && i < surface->GetNumberOfPoints(); ++i) {
    if (const auto node = surface_node(surface, i)) add_finite(sample, node_value(*node, quantity));
  }
  std::sort(sample.values.begin(), sample.values.end());
  return sample;
}

Histogram histogram_of(const Sample& sample) {
  Histogram histogram;
  const auto& values = sample.values;
  if (values.empty()) return histogram;
  const double range = values.back() - values.front();
  const double spread = quantile(values, 0.75) - quantile(values, 0.25);
  const double wanted = 2.0 * spread / std::cbrt(static_cast<double>(values.size()));
  const double least = std::max(range / kMostBins, 1e-9 * std::max(std::abs(values.back()), 1.0));
  const double most = std::max(range / kFewestBins, least);
  histogram.width = std::max(nice_floor(std::clamp(wanted, least, most)), nice_ceiling(least, 1e-12));
  histogram.begin = histogram.width * std::floor(values.front() / histogram.width);
  const auto place = [&](double value) {
    return static_cast<std::size_t>(std::max(std::floor((value - histogram.begin) / histogram.width), 0.0));
  };
  histogram.counts.resize(place(values.back()) + 1);
  for (const double value : values) ++histogram.counts[place(value)];
  return histogram;
}

CurveChartData histogram_chart(const Sample& sample) {
  CurveChartData data;
  data.x_title = say(names_of(sample.quantity).title);
  data.y_title = is_of_nodes(sample.quantity) ? say("Nodes") : say("Frames");
  data.band_name = say("count");
  data.empty_text = is_of_nodes(sample.quantity) ? say("This frame's surface holds no such numbers")
                                                 : say("No frame of this session has such a number");
  const Histogram histogram = histogram_of(sample);
  if (histogram.counts.empty()) return data;
  const auto step = [&](std::size_t edge, std::size_t count) {
    const double x = histogram.begin + static_cast<double>(edge) * histogram.width;
    data.curve.add(x, static_cast<double>(count), 0.0, static_cast<double>(count));
  };
  step(0, 0);
  for (std::size_t k = 0; k < histogram.counts.size(); ++k) {
    step(k, histogram.counts[k]);
    step(k + 1, histogram.counts[k]);
  }
  step(histogram.counts.size(), 0);
  data.x_begin = data.curve.x.front();
  data.x_end = data.curve.x.back();
  data.marks = {{quantile(sample.values, 0.25), "25 %", current_theme().text_dim},
                {quantile(sample.values, 0.5), say("median"), current_theme().text},
                {quantile(sample.values, 0.75), "75 %", current_theme().text_dim}};
  return data;
}

std::string histogram_facts(const Sample& sample) {
  const auto& values = sample.values;
  const bool nodes = is_of_nodes(sample.quantity);
  if (values.empty()) return nodes ? say("No node has this number") : say("No frame has this number");
  const auto range = [&](double low, double high) {
    return three_figures(quantile(values, low)) + say(" to ") + three_figures(quantile(values, high));
  };
  return std::to_string(values.size()) + (nodes ? say(" nodes") : say(" frames")) + say(" · median ") +
         three_figures(quantile(values, 0.5)) + names_of(sample.quantity).unit + say(" · quartiles ") +
         range(0.25, 0.75) + say(" · 5 to 95 %: ") + range(0.05, 0.95);
}

void write_histogram(const Sample& sample, const std::filesystem::path& file) {
  const std::string column = names_of(sample.quantity).column;
  OutputFile output(file);
  output.add(column + "_from," + column + "_to,count");
  const Histogram histogram = histogram_of(sample);
  for (std::size_t k = 0; k < histogram.counts.size(); ++k) {
    const double from = histogram.begin + static_cast<double>(k) * histogram.width;
    output.add(csv_number(from) + ',' + csv_number(from + histogram.width) + ',' + std::to_string(histogram.counts[k]));
  }
  output.finish();
}

}  // namespace pellucida
