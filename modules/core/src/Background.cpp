#include "pellucida/core/Background.h"

#include <pthread.h>
#include <sched.h>

namespace pellucida {

void work_in_background() noexcept {
  const sched_param parameters{};
  pthread_setschedparam(pthread_self(), SCHED_BATCH, &parameters);
}

}  // namespace pellucida
