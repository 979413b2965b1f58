#include "pellucida/core/Background.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>

#include <thread>

namespace pellucida {
namespace {

int policy_now() {
  int policy = -1;
  sched_param parameters{};
  pthread_getschedparam(pthread_self(), &policy, &parameters);
  return policy;
}

TEST(Background, ConcernsTheCallingThreadAlone) {
  const int before = policy_now();
  int beside = -1;
  std::thread([&] {
    work_in_background();
    beside = policy_now();
  }).join();
  EXPECT_EQ(beside, SCHED_BATCH);
  EXPECT_EQ(policy_now(), before);
}

}  // namespace
}  // namespace pellucida
