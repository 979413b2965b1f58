#include "pellucida/core_vtk/VtkThreads.h"

#include <vtkSMPTools.h>

namespace pellucida {

void keep_vtk_loops_on_their_thread() {
  vtkSMPTools::SetBackend("Sequential");
}

}  // namespace pellucida
