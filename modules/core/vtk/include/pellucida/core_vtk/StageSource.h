#pragma once
#include <vtkMultiBlockDataSetAlgorithm.h>

#include <cstdint>
#include <memory>

#include "pellucida/core/SharedLatest.h"
#include "pellucida/core_vtk/Scene.h"

namespace pellucida {

/// Names of the blocks, in order: frame, membranes, tools, surface, model.
enum class SceneBlock : unsigned { kFrame, kMembranes, kTools, kSurface, kModel };
const char* to_string(SceneBlock block) noexcept;

/// A VTK source (no input) that passes the newest frozen scene to any pipeline: a view, a writer or a third-party
/// filter is fed by a module as by a reader. Output port 0: vtkMultiBlockDataSet, one block for each part of the scene
/// (empty where the scene lacks it), blocks named. Use on one thread; `Poll` is the only call that reads across
/// threads.
class StageSource : public vtkMultiBlockDataSetAlgorithm {
 public:
  static StageSource* New();
  vtkTypeMacro(StageSource, vtkMultiBlockDataSetAlgorithm);
  StageSource(const StageSource&) = delete;
  void operator=(const StageSource&) = delete;

  /// The exchange to poll; may be nullptr.
  void SetExchange(std::shared_ptr<SharedLatest<Scene>> exchange);

  /// Checks for a newer scene; marks the source modified and returns true when there is one.
  bool Poll();

  /// Outputs `scene` from now on (replay, tests, one picture).
  void SetScene(const Scene& scene);

  /// The scene being output.
  const Scene& GetScene() const { return scene_; }

 protected:
  StageSource();
  ~StageSource() override = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  std::shared_ptr<SharedLatest<Scene>> exchange_;
  std::uint64_t sequence_ = 0;
  Scene scene_;
};

}  // namespace pellucida
