#pragma once
#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkObject.h>

namespace pellucida {

/// From here on what VTK has to say of `object`'s errors and warnings isn't printed: the caller says it in its own
/// words.
inline void silence(vtkObject& object) {
  vtkNew<vtkCallbackCommand> silent;
  silent->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  object.AddObserver(vtkCommand::ErrorEvent, silent);
  object.AddObserver(vtkCommand::WarningEvent, silent);
}

}  // namespace pellucida
