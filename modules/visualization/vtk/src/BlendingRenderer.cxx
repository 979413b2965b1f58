#include "BlendingRenderer.h"

#include <vtkObjectFactory.h>

namespace pellucida {

vtkStandardNewMacro(BlendingRenderer);

void BlendingRenderer::DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase*) {
  UpdateTranslucentPolygonalGeometry();
}

}  // namespace pellucida
