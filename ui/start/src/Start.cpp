#include "pellucida/start/Start.h"

#include "StartWindow.h"
#include "WindowProgram.h"

namespace pellucida {

std::optional<StartChoice> run_start(const StartOptions& options) {
  WindowProgram program;
  StartWindow window(options);
  program.show(window);
  window.screenshot().rethrow_fault();
  return window.choice();
}

}  // namespace pellucida
