#include "pellucida/teach/Teach.h"

#include "TeachWindow.h"
#include "WindowMemory.h"
#include "WindowProgram.h"

namespace pellucida {

int run_teach(const TeachOptions& options) {
  // A wrong name is said before a window opens.
  choose_lessons(options.lesson);
  WindowProgram program(options);
  TeachWindow window(choose_lessons(options.lesson), options);
  const WindowMemory memory(window, "teach", options);
  const int status = program.show(window, options);
  window.screenshot().rethrow_fault();
  return status;
}

}  // namespace pellucida
