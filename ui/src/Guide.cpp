#include "pellucida/ui/Guide.h"

#include "GuideWindow.h"
#include "WindowProgram.h"

namespace pellucida {

int run_guide(std::unique_ptr<LiveRun> run, std::unique_ptr<OperatorConsole> console, const GuideOptions& options) {
  WindowProgram program;
  GuideWindow window(std::move(run), std::move(console), options);
  const int status = program.show(window);
  window.screenshot().rethrow_fault();
  return status;
}

}  // namespace pellucida
