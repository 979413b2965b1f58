#pragma once
#include "pellucida/teaching/KassSnake.h"
#include "pellucida/teaching/SnakeField.h"

class vtkImageData;

namespace pellucida {

/// An image as a snake's field, blurred by `blur_px` first: Kass's line energy, grey above the image's median, or his
/// edge energy, minus the squared gradient. Scaled so that only one pixel in a thousand lies below -1. `image`: one
/// component, 8 or 16 bit unsigned, at least 8 x 8.
SnakeField snake_field(const vtkImageData* image, double blur_px, SnakeAttraction attraction);

}  // namespace pellucida
