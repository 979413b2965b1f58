#pragma once
#include <vtkOpenGLRenderer.h>

namespace pellucida {

/// Blends translucent actors over what is there, in the order in which they were added. VTK's own pass without an order
/// needs two more pictures of floats, a copy of the depth and a mixing of the whole viewport: on a software renderer
/// half of the 3-D view's time. Convex bodies drawn far side first need none of it.
class BlendingRenderer : public vtkOpenGLRenderer {
 public:
  static BlendingRenderer* New();
  vtkTypeMacro(BlendingRenderer, vtkOpenGLRenderer);

 protected:
  void DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* buffer) override;
};

}  // namespace pellucida
