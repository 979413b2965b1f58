#include "pellucida/start/Start.h"

#include "StartWindow.h"
#include "WindowProgram.h"

namespace pellucida {

std::optional<StartChoice> run_start(const StartOptions& options) {
  WindowProgram program(options);
  StartWindow window(options);
  program.show(window, options);
  window.screenshot().rethrow_fault();
  return window.choice();
}

}  // namespace pellucida
