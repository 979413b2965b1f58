// Sessions changed by chance in many ways, each in a process of its own: the change is named, nothing crashes or hangs,
// and a repair loses nothing that was good. PELLUCIDA_MUTATIONS=500,200 asks for so many flipped bits and other
// mutations.
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "SessionMutations.h"
#include "TestSession.h"
#include "pellucida/core/Error.h"
#include "pellucida/session/SessionCheck.h"
#include "pellucida/session/SessionExport.h"

namespace pellucida {
namespace {

using namespace test;

constexpr unsigned kHang_s = 60;

bool is_table(const std::string& file) {
  return file.ends_with(".csv");
}

// Everything that was not changed must be there afterwards: files at their place to the bit, rows in their tables, the
// head's values. Of what was changed, nothing is asked but that it is kept somewhere.
std::string lost_by_repair(const fs::path& before, const fs::path& after, const Mutation& mutation) {
  const std::set<std::string> changed(mutation.named.begin(), mutation.named.end());
  for (const std::string& file : files_of(before)) {
    if (changed.contains(file) || changed.contains(file.substr(0, file.find('/')))) continue;
    if (file == "session.pvd") continue;
    if (is_table(file)) {
      // The rows of what is damaged may go; all others stay.
      const std::vector<std::string> rows = lines_of(after / file);
      for (const std::string& row : lines_of(before / file)) {
        const bool of_changed = std::any_of(changed.begin(), changed.end(), [&](const std::string& name) {
          return file == "checksums.csv" && row.starts_with(name);
        });
        if (!of_changed && std::find(rows.begin(), rows.end(), row) == rows.end()) return file + ": " + row;
      }
    } else if (file == "session.json") {
      auto was = nlohmann::json::parse(text_of(before / file));
      auto is = nlohmann::json::parse(text_of(after / file));
      for (const char* key : {"crc32", "counts", "complete", "recovered"}) {
        was.erase(key);
        is.erase(key);
      }
      if (was != is) return file;
    } else if (text_of(after / file) != text_of(before / file)) {
      return file;
    }
  }
  return {};
}

// Check, repair, check, export: as a user would. One line a finding.
std::vector<std::string> examine(const fs::path& session, const fs::path& before, const Mutation& mutation) {
  std::vector<std::string> faults;
  const auto is_named = [&](const std::string& text) {
    return std::any_of(mutation.named.begin(), mutation.named.end(),
                       [&](const std::string& name) { return text.find(name) != std::string::npos; });
  };
  try {
    const SessionReport report = check_session(session, false);
    if (!std::any_of(report.problems.begin(), report.problems.end(), is_named)) {
      faults.push_back("not named: " + testing::PrintToString(report.problems));
    }
  } catch (const Error& error) {
    if (!is_named(error.what())) faults.push_back(std::string("not named: ") + error.what());
  }
  bool refused = false;
  try {
    check_session(session, true);
  } catch (const InputError&) {
    refused = true;
  }
  if (const std::string lost = lost_by_repair(before, session, mutation); !lost.empty()) {
    faults.push_back("lost by repair: " + lost);
  }
  try {
    const SessionReport after = check_session(session, false);
    if (!refused && !after.fine()) faults.push_back("not mended: " + testing::PrintToString(after.problems));
    if (after.counts.step_count > 0) {
      export_session(session, session.parent_path() / "export", {.frames = "first,last"});
    }
  } catch (const Error& error) {
    if (!refused) faults.push_back(std::string("unreadable after repair: ") + error.what());
  }
  return faults;
}

class SessionMutation : public testing::Test {
 protected:
  void SetUp() override {
    write_all_parts(folder_ / "whole", 0);
    write_all_parts(folder_ / "other", 40);
    ASSERT_TRUE(check_session(folder_ / "whole", false).fine());
  }

  static int asked_for(int index, int usual) {
    const char* text = std::getenv("PELLUCIDA_MUTATIONS");
    int counts[2] = {usual, usual};
    if (text && std::sscanf(text, "%d,%d", &counts[0], &counts[1]) != 2)
      ADD_FAILURE() << "PELLUCIDA_MUTATIONS=" << text;
    return counts[index];
  }

  // In a process of its own that is ended where it hangs.
  template <class Mutate>
  void run(std::uint64_t seed, Mutate mutate_one) const {
    const fs::path place = folder_ / "one";
    fs::remove_all(place);
    fs::create_directories(place);
    fs::copy(folder_ / "whole", place / "s", fs::copy_options::recursive);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      alarm(kHang_s);
      Chance chance(seed);
      std::string text;
      try {
        const Mutation mutation = mutate_one(place / "s", chance);
        put(place / "what", mutation.what);
        for (const std::string& fault : examine(place / "s", folder_ / "whole", mutation)) text += fault + '\n';
      } catch (const std::exception& error) {
        text = std::string("thrown: ") + error.what();
      }
      put(place / "faults", text);
      std::_Exit(0);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0)
        << (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM ? "hangs" : "crashes");
    EXPECT_EQ(text_of(place / "faults"), "") << "seed " << seed << ", " << text_of(place / "what");
  }

  TemporaryFolder folder_;
};

TEST_F(SessionMutation, AnyFlippedBitIsNamedAndARepairLosesNothing) {
  for (int i = 0; i < asked_for(0, 40); ++i) {
    run(static_cast<std::uint64_t>(i), [](const fs::path& session, Chance& chance) { return flip(session, chance); });
  }
}

TEST_F(SessionMutation, AnyOtherMutationIsNamedAndARepairLosesNothing) {
  const fs::path other = folder_ / "other";
  for (int i = 0; i < asked_for(1, 40); ++i) {
    run(1000000 + static_cast<std::uint64_t>(i),
        [&](const fs::path& session, Chance& chance) { return mutate(session, other, chance); });
  }
}

}  // namespace
}  // namespace pellucida
