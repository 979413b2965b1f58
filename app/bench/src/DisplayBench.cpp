#include "pellucida/bench/DisplayBench.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include "pellucida/charts_vtk/ForceChart.h"
#include "pellucida/core/Clock.h"
#include "pellucida/core_vtk/StageSource.h"
#include "pellucida/visualization/VirtualDisplay.h"
#include "pellucida/visualization_vtk/FeedView.h"
#include "pellucida/visualization_vtk/MembraneView.h"
#include "pellucida/visualization_vtk/MessageLog.h"

namespace pellucida {

double draw_scenes(const std::function<std::optional<Scene>()>& next) {
  MessageLog::install();
  VirtualDisplay display;
  vtkNew<StageSource> source;
  FeedView feed(source);
  MembraneView membranes(source);
  ForceChart chart(ForceChartKind::kForceIndentation);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(1400, 900);
  feed.add_to(window, {0.0, 0.35, 0.5, 1.0});
  membranes.add_to(window, {0.5, 0.35, 1.0, 1.0});
  chart.add_to(window, {0.0, 0.0, 1.0, 0.35});

  const auto draw = [&](const Scene& scene) {
    source->SetScene(scene);
    chart.append(scene.measurement);
    feed.refresh();
    membranes.refresh();
    window->Render();
  };
  const auto first = next();
  if (!first) return 0.0;
  draw(*first);  // shaders are compiled at the first drawing
  const SteadyClock clock;
  long count = 0;
  for (auto scene = next(); scene; scene = next(), ++count) draw(*scene);
  window->Finalize();
  return count > 0 ? static_cast<double>(count) / clock.now_s() : 0.0;
}

double measure_display_frames_per_s(std::span<const Scene> scenes) {
  std::size_t index = 0;
  return draw_scenes([&]() -> std::optional<Scene> {
    if (index >= scenes.size()) return std::nullopt;
    return scenes[index++];
  });
}

}  // namespace pellucida
