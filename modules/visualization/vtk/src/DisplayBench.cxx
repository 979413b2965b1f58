#include "pellucida/visualization_vtk/DisplayBench.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include "pellucida/core/Clock.h"
#include "pellucida/core_vtk/StageSource.h"
#include "pellucida/visualization/VirtualDisplay.h"
#include "pellucida/visualization_vtk/FeedView.h"
#include "pellucida/visualization_vtk/ForceChart.h"
#include "pellucida/visualization_vtk/MembraneView.h"
#include "pellucida/visualization_vtk/MessageLog.h"

namespace pellucida {

double measure_display_frames_per_s(std::span<const Scene> scenes) {
  if (scenes.empty()) return 0.0;
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
  draw(scenes.front());  // shaders are compiled at the first drawing
  const SteadyClock clock;
  for (const Scene& scene : scenes) draw(scene);
  window->Finalize();
  return static_cast<double>(scenes.size()) / clock.now_s();
}

}  // namespace pellucida
