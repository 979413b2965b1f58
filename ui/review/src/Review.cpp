#include "pellucida/review/Review.h"

#include "ReviewWindow.h"
#include "WindowMemory.h"
#include "WindowProgram.h"

namespace pellucida {

int run_review(const std::string& session, const ReviewOptions& options) {
  WindowProgram program(options);
  ReviewWindow window(options);
  if (!session.empty()) window.open(session);
  const WindowMemory memory(window, "review", options);
  const int status = program.show(window, options);
  window.screenshot().rethrow_fault();
  return status;
}

}  // namespace pellucida
