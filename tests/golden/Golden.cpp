#include "golden/Golden.h"

#include <vtkImageDifference.h>
#include <vtkImageExtractComponents.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace pellucida::test {
namespace {

constexpr int kThreshold = 20;

std::filesystem::path golden_file(const std::string& name) {
  return std::filesystem::path(PELLUCIDA_SOURCE_DIR) / "tests/golden/images" / (name + ".png");
}

}  // namespace

std::string GoldenDifference::text() const {
  return "differs by " + std::to_string(worst_tile) + " pixels of a square about (" + std::to_string(worst_x_px) +
         ", " + std::to_string(worst_y_px) + "); the limit is " + std::to_string(kMost);
}

GoldenDifference difference_of(vtkImageData* one, vtkImageData* other) {
  GoldenDifference result;
  int size[3], size_of_other[3];
  one->GetDimensions(size);
  other->GetDimensions(size_of_other);
  if (size[0] != size_of_other[0] || size[1] != size_of_other[1]) {
    result.worst_tile = static_cast<double>(size[0]) * size[1];
    return result;
  }
  vtkNew<vtkImageDifference> difference;
  difference->SetInputData(one);
  difference->SetImageData(other);
  difference->SetThreshold(kThreshold);
  difference->AllowShiftOn();
  difference->AveragingOff();
  difference->Update();
  vtkImageData* off = difference->GetOutput();
  const int columns = (size[0] + GoldenDifference::kTile_px - 1) / GoldenDifference::kTile_px;
  const int rows = (size[1] + GoldenDifference::kTile_px - 1) / GoldenDifference::kTile_px;
  std::vector<double> tiles(static_cast<std::size_t>(columns) * rows, 0.0);
  for (int y = 0; y < size[1]; ++y) {
    for (int x = 0; x < size[0]; ++x) {
      // The part that differs most: a yellow line on grey is one of blue.
      double most = 0.0;
      for (int k = 0; k < 3; ++k) most = std::max(most, off->GetScalarComponentAsDouble(x, y, 0, k) / 255.0);
      tiles[static_cast<std::size_t>(y / GoldenDifference::kTile_px) * columns + x / GoldenDifference::kTile_px] +=
          most;
    }
  }
  for (std::size_t k = 0; k < tiles.size(); ++k) {
    if (tiles[k] <= result.worst_tile) continue;
    result.worst_tile = tiles[k];
    const int half = GoldenDifference::kTile_px / 2;
    result.worst_x_px = static_cast<int>(k % columns) * GoldenDifference::kTile_px + half;
    result.worst_y_px = size[1] - 1 - (static_cast<int>(k / columns) * GoldenDifference::kTile_px + half);
  }
  return result;
}

vtkSmartPointer<vtkImageData> golden_picture(const std::string& name) {
  if (!std::filesystem::exists(golden_file(name))) return nullptr;
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(golden_file(name).c_str());
  // A picture of a palette is read as its colours.
  vtkNew<vtkImageExtractComponents> colours;
  colours->SetInputConnection(reader->GetOutputPort());
  colours->SetComponents(0, 1, 2);
  colours->Update();
  return colours->GetOutput();
}

bool writes_golden() {
  return std::getenv("PELLUCIDA_WRITE_GOLDEN") != nullptr;
}

void write_golden(vtkImageData* picture, const std::string& name) {
  std::filesystem::create_directories(golden_file(name).parent_path());
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->SetFileName(golden_file(name).c_str());
  writer->Write();
  const std::string file = golden_file(name).string();
  const std::string quantise = "pngquant --force --nofs --strip --output '" + file + "' 128 '" + file + "' 2>/dev/null";
  if (std::system(quantise.c_str()) != 0) std::printf("%s: left in full colours\n", file.c_str());
}

}  // namespace pellucida::test
