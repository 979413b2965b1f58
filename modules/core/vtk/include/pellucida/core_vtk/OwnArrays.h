#pragma once

class vtkDataObject;

namespace pellucida {

/// Gives a shallow copy arrays of its own that share the values: those of its points, cells and fields. VTK's XML
/// writers keep each array's range in the array itself while they write, so that two threads may write shallow copies
/// of one object only after this. Strings are copied.
void give_own_arrays(vtkDataObject* copy);

}  // namespace pellucida
