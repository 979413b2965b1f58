#pragma once
#include <filesystem>

#include "SessionFolder.h"
#include "SessionIndex.h"
#include "pellucida/core/SourceInfo.h"
#include "pellucida/vtk_files/DataFile.h"

namespace pellucida {

/// Reads the data files of a session, each held against its checksum, its name and its meaning (docs/file-format.md).
/// Whatever a file holds, the worst that comes of it is an InputError that starts with its path.
class PartReader {
 public:
  /// `checksums` must outlive the reader. `source`: what the head says of the images; its zeros say nothing.
  PartReader(std::filesystem::path folder, const SessionTable<FileChecksum>& checksums, SourceInfo source);

  vtkSmartPointer<vtkImageData> read_image(long frame_index) const;
  /// The surface, the membranes or the tools; with kHandKind a block of the recording of the hand.
  vtkSmartPointer<vtkPolyData> read_poly(const DataName& name) const;

 private:
  template <class Data, class Make>
  vtkSmartPointer<Data> read(const DataName& name, Make make) const;

  std::filesystem::path folder_;
  const SessionTable<FileChecksum>& checksums_;
  SourceInfo source_;
};

}  // namespace pellucida
