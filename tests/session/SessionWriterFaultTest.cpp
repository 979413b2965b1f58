// A full disk and a kill in the middle of a recording.
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <random>

#include "TestSession.h"
#include "pellucida/core/Error.h"
#include "pellucida/session/SessionCheck.h"
#include "pellucida/session/SessionWriter.h"

namespace pellucida {
namespace {

using namespace test;

// A limit on the size of files simulates a full disk: the system refuses the write in the same place. It can't be
// lifted again, so the writing is done by a child.
TEST(SessionWriterFault, FullDiskKeepsWhatWasWrittenBefore) {
  const TemporaryFolder folder;
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    int code = 1;
    try {
      SessionWriter writer(folder / "s", make_info());
      for (long frame = 0; frame < 5; ++frame) writer.write(make_scene(frame));
      // Rows and small files still fit below this limit, the image of the next frame doesn't.
      const rlimit limit{32768, 32768};
      setrlimit(RLIMIT_FSIZE, &limit);
      Scene scene = make_scene(5);
      std::vector<std::uint8_t> pixels(256 * 256);
      std::mt19937 random(1);
      for (std::uint8_t& pixel : pixels) pixel = static_cast<std::uint8_t>(random());
      scene.frame = Frozen(make_frame({pixels.data(), PixelFormat::kGray8, 256, 256, 256, 0.825}, time_of(5), 5));
      try {
        writer.write(scene);
        code = 2;
      } catch (const OutputError& error) {
        const std::string text = error.what();
        code = text.find("frame_00000005.vti: can't be written (File too large)") != std::string::npos ? 0 : 3;
        if (writer.counts().step_count != 5) code = 4;
        writer.close();
      }
    } catch (...) {
      code = 5;
    }
    _exit(code);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  // The five steps before are whole, and of the sixth nothing is left.
  const SessionReport report = check_session(folder / "s", false);
  EXPECT_TRUE(report.fine()) << (report.problems.empty() ? "" : report.problems.front());
  EXPECT_EQ(report.counts.step_count, 5U);
  EXPECT_TRUE(report.notes.empty());
}

TEST(SessionWriterFault, KillAtAnyMomentLosesNoWholeStep) {
  const TemporaryFolder folder;
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    try {
      SessionWriter writer(folder / "s", make_info());
      for (long frame = 0;; ++frame) {
        writer.write(make_scene(frame));
        // Tells each step that is done.
        const char one = 1;
        if (::write(ready[1], &one, 1) != 1) _exit(1);
      }
    } catch (...) {
      _exit(1);
    }
  }
  char byte = 0;
  for (int i = 0; i < 25; ++i) ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  close(ready[0]);
  close(ready[1]);

  const SessionReport before = check_session(folder / "s", false);
  EXPECT_FALSE(before.fine());
  EXPECT_GE(before.counts.step_count, 25U);
  EXPECT_GE(before.counts.files(SessionPart::kSurface), 25U);
  EXPECT_TRUE(check_session(folder / "s", true).repaired);
  EXPECT_TRUE(check_session(folder / "s", false).fine());
}

}  // namespace
}  // namespace pellucida
