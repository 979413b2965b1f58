#include "pellucida/visualization_vtk/PanZoomStyle.h"

#include <vtkObjectFactory.h>

namespace pellucida {

vtkStandardNewMacro(PanZoomStyle);

}  // namespace pellucida
