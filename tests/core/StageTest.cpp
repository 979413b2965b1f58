#include "pellucida/core/Stage.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "pellucida/core/Ring.h"
#include "pellucida/core/SharedLatest.h"

namespace pellucida {
namespace {

// Squares even numbers, has nothing to say of odd ones, and breaks at negative ones.
struct SquareStep {
  using Input = int;
  using Output = int;
  expected<int, StepFailure> process(const int& n) {
    if (n < 0) throw std::domain_error("negative");
    if (n % 2) return unexpected<StepFailure>({"odd: " + std::to_string(n)});
    return n * n;
  }
};
static_assert(Step<SquareStep>);

TEST(Stage, ProcessesARingInOrderAndCounts) {
  SquareStep step;
  Ring<int> input(16);
  std::vector<int> outputs;
  const SteadyClock clock;
  std::vector<int> failures;
  Stage stage(
      step, input, [&](int n) { outputs.push_back(n); }, clock,
      [&](const int& n, const StepFailure&) { failures.push_back(n); });
  stage.start();
  for (int i = 0; i < 5; ++i) input.push(i);
  input.close();
  stage.join();
  EXPECT_EQ(outputs, (std::vector<int>{0, 4, 16}));
  EXPECT_EQ(failures, (std::vector<int>{1, 3}));
  const StageCounts counts = stage.counts();
  EXPECT_EQ(counts.done_count, 3U);
  EXPECT_EQ(counts.failed_count, 2U);
  EXPECT_EQ(counts.last_failure, "odd: 3");
  EXPECT_GE(counts.total_step_s, counts.last_step_s);
  EXPECT_FALSE(stage.running());
}

TEST(Stage, ChainsThroughExchanges) {
  SquareStep first;
  SquareStep second;
  Ring<int> input(16);
  SharedLatest<int> middle;
  SharedLatest<int> output;
  const SteadyClock clock;
  Stage a(
      first, input, [&](int n) { middle.publish(n); }, clock);
  Stage b(
      second, middle, [&](int n) { output.publish(n); }, clock);
  b.start();
  a.start();
  input.push(2);
  input.push(4);
  input.close();
  a.join();
  middle.close();
  b.join();
  EXPECT_EQ(output.peek(), 256);  // the newest always gets through: ((4)^2)^2
}

TEST(Stage, AnExceptionEndsTheStageAndIsKept) {
  SquareStep step;
  Ring<int> input(16);
  const SteadyClock clock;
  Stage stage(
      step, input, [](int) {}, clock);
  stage.start();
  input.push(-1);
  stage.join();
  EXPECT_THROW(stage.rethrow(), std::domain_error);
  EXPECT_FALSE(input.push(2));  // it would never be taken
}

TEST(Stage, StopLeavesTheRestInTheInput) {
  SquareStep step;
  Ring<int> input(16);
  const SteadyClock clock;
  Stage stage(
      step, input, [](int) {}, clock);
  stage.start();
  stage.stop();
  input.push(2);
  EXPECT_EQ(input.size(), 1U);
  EXPECT_NO_THROW(stage.rethrow());
}

}  // namespace
}  // namespace pellucida
