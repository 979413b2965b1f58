#pragma once
#include <vtkSmartPointer.h>

class vtkDataObject;

namespace pellucida {

/// Computes what VTK would cache at a first read (bounds, array ranges), so that many threads may read `data` at once.
void prepare_for_sharing(vtkDataObject* data);

/// A VTK data object that nobody writes again. It crosses threads freely; who wants to use it in a pipeline takes a
/// shallow copy of its own. An empty handle (the default) stands for "not there".
template <class T>
class Frozen {
 public:
  Frozen() = default;

  /// Freezes `data`: the caller gives it up and writes to it no more.
  explicit Frozen(vtkSmartPointer<T> data) : data_(std::move(data)) {
    if (data_) prepare_for_sharing(data_);
  }

  explicit operator bool() const noexcept { return data_ != nullptr; }

  /// Read access, any thread; valid while this handle lives.
  const T* get() const noexcept { return data_; }

  /// A data object of the caller's own that shares the frozen arrays; nullptr for an empty handle.
  vtkSmartPointer<T> shallow_copy() const {
    if (!data_) return nullptr;
    auto copy = vtkSmartPointer<T>::New();
    copy->ShallowCopy(data_);
    return copy;
  }

 private:
  // VTK's readers are not const-correct: the pointer is kept mutable here and handed out as const or as a copy only.
  vtkSmartPointer<T> data_;
};

}  // namespace pellucida
