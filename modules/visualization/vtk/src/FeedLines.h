#pragma once
#include <vtkActor.h>
#include <vtkNew.h>

#include "RibbonFilter.h"

class vtkAlgorithmOutput;
class vtkRenderer;

namespace pellucida {

/// Lines with a dark underlay, so that they read on bright and dark parts of the image alike.
struct FeedLines {
  vtkNew<RibbonFilter> ribbon;
  vtkNew<RibbonFilter> under_ribbon;
  vtkNew<vtkActor> actor;
  vtkNew<vtkActor> under;

  /// `level` orders lines one above the other.
  void build(vtkAlgorithmOutput* input, vtkRenderer* renderer, int level);
  /// Width in logical pixels; the underlay is 2 wider.
  void set_width(double width, double um_per_px);
  void show(bool shown) {
    actor->SetVisibility(shown);
    under->SetVisibility(shown);
  }
};

}  // namespace pellucida
