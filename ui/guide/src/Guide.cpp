#include "pellucida/guide/Guide.h"

#include "GuideWindow.h"
#include "WindowMemory.h"
#include "WindowProgram.h"

namespace pellucida {

int run_guide(std::unique_ptr<LiveRun> run, std::unique_ptr<OperatorConsole> console, const GuideOptions& options) {
  WindowProgram program(options);
  GuideWindow window(std::move(run), std::move(console), options);
  const WindowMemory memory(window, "guide", options);
  const int status = program.show(window, options);
  window.end_run();
  window.screenshot().rethrow_fault();
  window.figures().write();
  return status;
}

}  // namespace pellucida
