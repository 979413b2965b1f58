// Hand force and pipette after each fault, as one chart and as a table: haptics_faults CHART.png [TABLE.csv]
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "haptics/HandRun.h"
#include "pellucida/charts_vtk/ChartPicture.h"
#include "pellucida/core/Error.h"
#include "pellucida/haptics/DeviceCatalog.h"

namespace pellucida {
namespace {

constexpr double kScale_um_per_m = 2000.0;
constexpr double kFault_s = 2.5, kBack_s = 3.5, kFrom_s = 2.4, kTo_s = 4.0;
constexpr Color kBlue = Color::from_hex(0x1F6FB2), kOrange = Color::from_hex(0xC8640A),
                kGrey = Color::from_hex(0x8A929C);

// What happens to the run at `kFault_s`, and what makes it good at `kBack_s`.
struct Fault {
  std::string name;
  std::function<void(test::HandRun&)> begin;
  std::function<void(test::HandRun&)> end;
  bool late_ticks = false;
};

std::vector<Fault> all_faults() {
  const auto nothing = [](test::HandRun&) {};
  return {
      {"camera stalls", [](auto& run) { run.camera_stalled = true; }, [](auto& run) { run.camera_stalled = false; }},
      {"model says NaN", [](auto& run) { run.camera_says_nan = true; }, [](auto& run) { run.camera_says_nan = false; }},
      {"membrane gives way", [](auto& run) { run.cell.punctured = true; }, nothing},
      {"device lost", [](auto& run) { run.arm.lost = true; }, [](auto& run) { run.arm.lost = false; }},
      {"ticks 40 ms late", nothing, nothing, true},
      {"emergency stop", [](auto& run) { run.servo().emergency_stop(); },
       [](auto& run) { run.servo().release_emergency_stop(); }},
  };
}

struct Traces {
  std::vector<double> time_ms, force_N, cell_N, tip_um, hand_um, pipette_um;
};

Traces run_fault(const Fault& fault, const DeviceSpecification& device) {
  HapticSettings settings = default_settings(device, kScale_um_per_m);
  settings.predictor.tip_lag_s = 0.03;
  test::HandRun run(device, settings, kScale_um_per_m);
  run.cell.contact_x_um = 20.0;
  Traces traces;
  bool begun = false, ended = false;
  while (run.now_s() < kTo_s) {
    // Pushes to some 30 um, and to and fro there.
    const double t = run.now_s();
    run.arm.intent_m.x() = 0.03 * std::min(1.0, t) + 0.002 * std::sin(2.0 * std::numbers::pi * 2.5 * t);
    const bool during = t >= kFault_s && t < kBack_s;
    if (during && !begun) fault.begin(run);
    if (t >= kBack_s && !ended) fault.end(run);
    begun = begun || during;
    ended = ended || t >= kBack_s;
    const HapticRecord record = run.tick(fault.late_ticks && during ? 0.04 : 0.001);
    if (t < kFrom_s) continue;
    traces.time_ms.push_back(1e3 * (run.now_s() - kFault_s));
    traces.force_N.push_back(-record.hand_force_N.x);
    traces.cell_N.push_back(settings.force_scale_N_per_uN * run.cell.force_at(run.cell.depth_um(run.pipette_x_um())));
    traces.tip_um.push_back(record.tip_um.x);
    traces.hand_um.push_back(kScale_um_per_m * run.arm.position_m().x());
    traces.pipette_um.push_back(run.pipette_x_um());
  }
  return traces;
}

ChartSeries line(const std::string& name, const Traces& traces, const std::vector<double>& y, Color color,
                 ChartStyle style = ChartStyle::kLine) {
  ChartSeries series;
  series.name = name;
  series.style = style;
  series.x = traces.time_ms;
  series.y = y;
  series.color = color;
  return series;
}

ChartPanel panel(const std::string& title, const std::string& y_title, double y_begin, double y_end) {
  ChartPanel panel;
  panel.title = title;
  panel.x_title = "time since the fault, ms";
  panel.y_title = y_title;
  panel.x_begin = -100.0;
  panel.x_end = 1500.0;
  panel.y_begin = y_begin;
  panel.y_end = y_end;
  panel.legend_right = true;
  return panel;
}

void run_tool(const std::string& chart, const std::string& table) {
  const DeviceSpecification device = find_device("Touch");
  const std::vector<Fault> faults = all_faults();
  std::vector<Traces> all;
  for (const Fault& fault : faults) all.push_back(run_fault(fault, device));

  // Two rows for three faults: force above, tip below.
  std::vector<ChartPanel> panels;
  constexpr std::size_t kColumns = 3;
  for (std::size_t from = 0; from < faults.size(); from += kColumns) {
    for (std::size_t k = from; k < from + kColumns; ++k) {
      ChartPanel force = panel(faults[k].name, "force against the push, N", 0.0, 2.0);
      force.series = {line("the cell's, scaled", all[k], all[k].cell_N, kGrey, ChartStyle::kDashedLine),
                      line("on the hand", all[k], all[k].force_N, kBlue)};
      panels.push_back(force);
    }
    for (std::size_t k = from; k < from + kColumns; ++k) {
      ChartPanel tip = panel("", "along the path, um", 30.0, 80.0);
      tip.series = {line("the hand, scaled", all[k], all[k].hand_um, kGrey, ChartStyle::kDashedLine),
                    line("commanded to the pipette", all[k], all[k].tip_um, kOrange)};
      panels.push_back(tip);
    }
  }
  render_charts(panels, static_cast<int>(kColumns), chart, {.width_px = 1800, .height_px = 1600});

  if (table.empty()) return;
  std::ofstream stream(table);
  stream << "fault,time_ms,hand_force_N,cell_force_N,hand_um,tip_um,pipette_um\n";
  for (std::size_t k = 0; k < faults.size(); ++k) {
    for (std::size_t i = 0; i < all[k].time_ms.size(); ++i) {
      stream << faults[k].name << ',' << all[k].time_ms[i] << ',' << all[k].force_N[i] << ',' << all[k].cell_N[i] << ','
             << all[k].hand_um[i] << ',' << all[k].tip_um[i] << ',' << all[k].pipette_um[i] << '\n';
    }
  }
  stream.flush();
  if (!stream) throw OutputError(table + ": the table can't be written; check disk space and permissions");
}

}  // namespace
}  // namespace pellucida

int main(int count, char** arguments) {
  if (count < 2 || count > 3) {
    std::cerr << "usage: haptics_faults CHART.png [TABLE.csv]\n";
    return 2;
  }
  try {
    pellucida::run_tool(arguments[1], count == 3 ? arguments[2] : "");
  } catch (const pellucida::Error& error) {
    std::cerr << error.what() << '\n';
    return static_cast<int>(error.code());
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
