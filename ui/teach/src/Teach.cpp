#include "pellucida/teach/Teach.h"

#include "TeachWindow.h"
#include "WindowProgram.h"

namespace pellucida {

int run_teach(const TeachOptions& options) {
  // A wrong name is said before a window opens.
  LessonChoice lessons = choose_lessons(options.lesson);
  WindowProgram program(options.light_theme ? light_theme() : dark_theme());
  TeachWindow window(std::move(lessons), options);
  const int status = program.show(window);
  window.screenshot().rethrow_fault();
  return status;
}

}  // namespace pellucida
