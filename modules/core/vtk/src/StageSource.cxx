#include "pellucida/core_vtk/StageSource.h"

#include <vtkCompositeDataSet.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkObjectFactory.h>

namespace pellucida {
namespace {

template <class T>
void set_block(vtkMultiBlockDataSet* output, SceneBlock block, const Frozen<T>& part) {
  const auto index = static_cast<unsigned>(block);
  const auto copy = part.shallow_copy();
  output->SetBlock(index, copy);
  output->GetMetaData(index)->Set(vtkCompositeDataSet::NAME(), to_string(block));
}

}  // namespace

const char* to_string(SceneBlock block) noexcept {
  switch (block) {
    case SceneBlock::kFrame:
      return "frame";
    case SceneBlock::kMembranes:
      return "membranes";
    case SceneBlock::kTools:
      return "tools";
    case SceneBlock::kSurface:
      return "surface";
    case SceneBlock::kModel:
      return "model";
  }
  return "unknown";
}

vtkStandardNewMacro(StageSource);

StageSource::StageSource() {
  this->SetNumberOfInputPorts(0);
}

void StageSource::SetExchange(std::shared_ptr<SharedLatest<Scene>> exchange) {
  exchange_ = std::move(exchange);
  sequence_ = 0;
}

bool StageSource::Poll() {
  if (!exchange_) return false;
  const std::uint64_t sequence = exchange_->sequence();
  if (sequence == sequence_) return false;
  auto scene = exchange_->peek();
  if (!scene) return false;
  sequence_ = sequence;
  this->SetScene(*scene);
  return true;
}

void StageSource::SetScene(const Scene& scene) {
  scene_ = scene;
  this->Modified();
}

int StageSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  auto* output = vtkMultiBlockDataSet::GetData(outputs);
  output->SetNumberOfBlocks(5);
  set_block(output, SceneBlock::kFrame, scene_.frame);
  set_block(output, SceneBlock::kMembranes, scene_.membranes);
  set_block(output, SceneBlock::kTools, scene_.tools);
  set_block(output, SceneBlock::kSurface, scene_.surface);
  set_block(output, SceneBlock::kModel, scene_.model);
  return 1;
}

}  // namespace pellucida
