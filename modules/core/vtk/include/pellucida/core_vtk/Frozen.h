#pragma once
#include <vtkSmartPointer.h>

#include <memory>
#include <utility>

class vtkDataObject;

namespace pellucida {

/// Computes what VTK would cache at a first read (bounds, array ranges), so that many threads may read `data` at once.
void prepare_for_sharing(vtkDataObject* data);

/// A VTK data object that is never written again. It may cross threads freely; a pipeline uses a shallow copy of its
/// own. An empty handle (the default) means "absent".
///
/// The handles share one reference to the object, counted outside VTK. If each handle held a reference of its own,
/// releasing one that is not the last would send VTK's garbage collector through the object, where it could meet
/// another thread's deletion.
template <class T>
class Frozen {
 public:
  Frozen() = default;

  /// Freezes `data`: the caller hands it over and never writes to it again.
  explicit Frozen(vtkSmartPointer<T> data) {
    if (!data) return;
    prepare_for_sharing(data);
    data_ = std::make_shared<const vtkSmartPointer<T>>(std::move(data));
  }

  explicit operator bool() const noexcept { return data_ != nullptr; }

  /// Read access, any thread; valid while this handle lives. Don't take references (smart pointers) to it.
  const T* get() const noexcept { return data_ ? data_->GetPointer() : nullptr; }

  /// A data object of the caller's own that shares the frozen arrays; nullptr for an empty handle.
  vtkSmartPointer<T> shallow_copy() const {
    if (!data_) return nullptr;
    auto copy = vtkSmartPointer<T>::New();
    copy->ShallowCopy(data_->GetPointer());
    return copy;
  }

 private:
  std::shared_ptr<const vtkSmartPointer<T>> data_;
};

}  // namespace pellucida
