#pragma once
#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace pellucida {

/// How images are packed: small, or quick where writing falls behind: larger files in less time. Every reader of VTK
/// files reads both.
enum class Packing { kSmall, kQuick };

/// Arrays as they are in data files, packed once for all files that have them in common.
class PackedArrays {
 public:
  /// What an array, or the cells of one kind, were packed to; nullptr for others. By the object: it must be this one.
  const std::string* find(const vtkObjectBase* object, int part = 0) const;

 private:
  friend class DataWriter;
  std::vector<vtkSmartPointer<vtkObjectBase>> kept_;  // so that no other object takes an address
  std::map<std::pair<const vtkObjectBase*, int>, std::string> packed_;
};

/// Makes the contents of VTK XML files (`.vti`, `.vtp`: appended raw, UInt32 heads, zlib by libdeflate, cell indices as
/// Int32), one after another. What stays the same from file to file, such as the topology of a surface, is packed once:
/// the writer keeps the last arrays and what they were packed to. One thread at a time.
class DataWriter {
 public:
  DataWriter();
  ~DataWriter();
  DataWriter(const DataWriter&) = delete;
  DataWriter& operator=(const DataWriter&) = delete;

  /// The content of a `.vti` file; with quick packing nothing is compressed. `data` isn't changed.
  std::string write(vtkImageData* data, Packing packing = Packing::kSmall);
  /// The content of a `.vtp` file. Numbers are written in the type they have. `data` isn't changed. `common`: what is
  /// packed already, by this writer or another one.
  std::string write(vtkPolyData* data, const PackedArrays* common = nullptr);
  /// Packs points, cells and point arrays of `data` for other files that have the same objects.
  PackedArrays pack(vtkPolyData* data);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
