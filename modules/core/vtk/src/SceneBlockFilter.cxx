#include "pellucida/core_vtk/SceneBlockFilter.h"

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

namespace pellucida {

vtkStandardNewMacro(SceneBlockFilter);

void SceneBlockFilter::SetBlock(SceneBlock block) {
  if (block == block_) return;
  block_ = block;
  this->Modified();
}

int SceneBlockFilter::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMultiBlockDataSet");
  return 1;
}

int SceneBlockFilter::FillOutputPortInformation(int, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataSet");
  return 1;
}

int SceneBlockFilter::RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  // The output's type follows the block chosen.
  const char* type = block_ == SceneBlock::kFrame ? "vtkImageData" : "vtkPolyData";
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkDataObject* output = info->Get(vtkDataObject::DATA_OBJECT());
  if (output && output->IsA(type)) return 1;
  vtkSmartPointer<vtkDataObject> fresh;
  if (block_ == SceneBlock::kFrame) {
    fresh = vtkSmartPointer<vtkImageData>::New();
  } else {
    fresh = vtkSmartPointer<vtkPolyData>::New();
  }
  info->Set(vtkDataObject::DATA_OBJECT(), fresh);
  return 1;
}

int SceneBlockFilter::RequestInformation(vtkInformation*, vtkInformationVector** inputs,
                                         vtkInformationVector* outputs) {
  if (block_ != SceneBlock::kFrame) return 1;
  // Image consumers ask for the extent before the data. The scene is at hand and handing it out costs nothing, so the
  // source is asked now.
  this->GetInputAlgorithm()->Update();
  auto* blocks = vtkMultiBlockDataSet::GetData(inputs[0]);
  auto* frame = blocks && blocks->GetNumberOfBlocks() > 0
                    ? vtkImageData::SafeDownCast(blocks->GetBlock(static_cast<unsigned>(block_)))
                    : nullptr;
  if (!frame) return 1;
  vtkInformation* info = outputs->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), frame->GetExtent(), 6);
  info->Set(vtkDataObject::SPACING(), frame->GetSpacing(), 3);
  info->Set(vtkDataObject::ORIGIN(), frame->GetOrigin(), 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, frame->GetScalarType(), frame->GetNumberOfScalarComponents());
  return 1;
}

int SceneBlockFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  auto* blocks = vtkMultiBlockDataSet::GetData(inputs[0]);
  vtkDataObject* output = outputs->GetInformationObject(0)->Get(vtkDataObject::DATA_OBJECT());
  const auto index = static_cast<unsigned>(block_);
  vtkDataObject* part = blocks->GetNumberOfBlocks() > index ? blocks->GetBlock(index) : nullptr;
  if (part) {
    output->ShallowCopy(part);
  } else {
    output->Initialize();
  }
  return 1;
}

}  // namespace pellucida
