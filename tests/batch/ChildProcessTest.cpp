#include "pellucida/batch/ChildProcess.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "pellucida/core/TemporaryFolder.h"
#include "support/Files.h"
#include "support/WaitUntil.h"

namespace pellucida {
namespace {

ChildProcess shell(const std::string& script) {
  return {"/bin/sh", {"-c", script}};
}

ChildEnd wait_for(ChildProcess& child) {
  std::optional<ChildEnd> end;
  EXPECT_TRUE(test::wait_until([&] {
    end = child.end();
    return end.has_value();
  }));
  return end.value_or(ChildEnd{});
}

TEST(ChildProcess, SaysHowItEndedAndWhatItSaid) {
  ChildProcess child = shell("echo unheard; echo 'pellucida: it broke' >&2; exit 3");
  const ChildEnd end = wait_for(child);
  EXPECT_EQ(end.exit_code, 3);
  EXPECT_EQ(end.signal, 0);
  EXPECT_EQ(end.error_output, "pellucida: it broke\n");
  EXPECT_GT(end.wall_time_s, 0.0);
  EXPECT_FALSE(child.end());
}

TEST(ChildProcess, ACrashIsASignal) {
  ChildProcess child = shell("kill -SEGV $$");
  const ChildEnd end = wait_for(child);
  EXPECT_EQ(end.signal, SIGSEGV);
  EXPECT_EQ(end.exit_code, 128 + SIGSEGV);
}

TEST(ChildProcess, WhatCantBeStartedSaysWhy) {
  ChildProcess child("/nowhere/program", {});
  const ChildEnd end = wait_for(child);
  EXPECT_EQ(end.exit_code, 127);
  EXPECT_NE(end.error_output.find("/nowhere/program can't be started"), std::string::npos) << end.error_output;
}

TEST(ChildProcess, TakesASignalAndManyWords) {
  ChildProcess child = shell("i=0; while [ $i -lt 20000 ]; do echo line $i >&2; i=$((i+1)); done; sleep 60");
  EXPECT_FALSE(child.end());
  child.send(SIGTERM);
  EXPECT_EQ(wait_for(child).signal, SIGTERM);

  ChildProcess talker = shell("i=0; while [ $i -lt 20000 ]; do echo line $i >&2; i=$((i+1)); done");
  const ChildEnd end = wait_for(talker);
  EXPECT_LE(end.error_output.size(), 65536U);
  EXPECT_TRUE(end.error_output.ends_with("line 19999\n"));
}

// Neither the end of its owner, nor a kill of the whole program, leaves a child behind.
TEST(ChildProcess, EndsWithItsParent) {
  const TemporaryFolder folder;
  const auto file = folder / "pid";
  const std::string script = "echo $$ > '" + file.string() + "'; exec sleep 60";
  const auto started = [&] { return test::wait_until([&] { return !test::text_of(file).empty(); }); };
  const auto gone = [&] {
    const pid_t pid = std::stoi(test::text_of(file));
    return test::wait_until([&] { return ::kill(pid, 0) != 0; });
  };
  {
    ChildProcess child = shell(script);
    ASSERT_TRUE(started());
  }
  EXPECT_TRUE(gone());

  std::filesystem::remove(file);
  const pid_t parent = ::fork();
  ASSERT_GE(parent, 0);
  if (parent == 0) {
    ChildProcess child = shell(script);
    ::pause();
    ::_exit(0);
  }
  ASSERT_TRUE(started());
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  EXPECT_TRUE(gone());
}

}  // namespace
}  // namespace pellucida
