#pragma once
#include "pellucida/teaching/Lesson.h"

class QWidget;

namespace pellucida {

/// A page of Teach mode: what a lesson is about. Its widgets belong to the window and go before it.
class TeachPage {
 public:
  virtual ~TeachPage() = default;

  /// The line of figures on top, what is seen in the middle, and the controls beside it. Each is made once.
  virtual QWidget* make_figures() = 0;
  virtual QWidget* make_stage() = 0;
  virtual QWidget* make_side() = 0;

  /// Sets everything up as a lesson of this page has it.
  virtual void begin(const Lesson& lesson) = 0;
  /// A page that is not shown does no work.
  virtual void set_shown(bool shown) = 0;
  /// Thirty times a second while it is shown.
  virtual void tick() = 0;
  /// Shows what is newest at once, for a picture.
  virtual void show_newest() = 0;
  virtual void restart() = 0;
  /// What the arrow keys move: um to the right and up on screen.
  virtual void nudge(double right_um, double up_um) = 0;
  virtual void reset_view() = 0;
  virtual void set_type_scale(double scale) = 0;
};

}  // namespace pellucida
