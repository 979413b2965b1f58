#pragma once

class vtkTextProperty;

namespace pellucida {

/// Sets the typeface of all writing in the views: DejaVu Sans (Debian fonts-dejavu-core), which the window uses too;
/// where the files are missing, the face built into VTK.
void set_typeface(vtkTextProperty* letters, bool bold);

}  // namespace pellucida
