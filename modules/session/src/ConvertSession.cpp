#include "pellucida/session/ConvertSession.h"

#include <array>

#include "DiskFile.h"
#include "SessionFolder.h"
#include "SessionJson.h"
#include "pellucida/core/Error.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/session/SessionReader.h"
#include "pellucida/session/SessionWriter.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

// What a replay adds; a report is made anew in a moment.
constexpr std::array kTables{"differences.csv", "changes.csv"};

// Files that can't be read: the first is named, all are counted.
class Unread {
 public:
  template <class Read>
  void read(Read read) {
    try {
      read();
    } catch (const InputError& error) {
      if (count_++ == 0) first_ = error.what();
    }
  }
  void report(std::vector<std::string>& notes) const {
    if (count_ == 0) return;
    notes.push_back("warning: left out " + std::to_string(count_) + " file(s) that can't be read, the first " + first_);
  }

 private:
  std::size_t count_ = 0;
  std::string first_;
};

Scene load_what_is_whole(const SessionReader& session, std::size_t step, Unread& unread) {
  Scene scene;
  scene.arrival_s = session.steps()[step].time_s;
  scene.measurement = session.measurements()[step];
  unread.read([&] { scene.surface = session.load(step, SessionPart::kSurface); });
  unread.read([&] { scene.membranes = session.load(step, SessionPart::kMembranes); });
  unread.read([&] { scene.tools = session.load(step, SessionPart::kTools); });
  unread.read([&] {
    if (auto image = session.read_image(step)) scene.frame = Frozen<vtkImageData>(std::move(image));
  });
  return scene;
}

}  // namespace

ConvertReport convert_session(const fs::path& session, const fs::path& output, const SessionProgress& progress) {
  const SessionReader reader(session);
  const SessionHead head = read_session_json(session / session_name::kJson);
  if (!head.complete && !head.recovered) {
    throw InputError(session.string() + ": the recording was cut off, or still goes on; run pellucida check " +
                     session.string() + " --repair first");
  }
  ConvertReport report{.before = reader.stated_counts()};
  SessionOptions options{.frames = head.options.frames};
  options.rewritten = RewrittenSession{.created = head.created, .cut_off = !head.complete};
  SessionWriter writer(output, reader.info(), options);
  Unread unread;
  const std::size_t count = reader.steps().size();
  for (std::size_t step = 0; step < count; ++step) {
    writer.write(load_what_is_whole(reader, step, unread));
    if (progress && ((step + 1) % 16 == 0 || step + 1 == count)) progress(step + 1, count);
  }
  for (const Event& event : reader.events()) writer.event(event);
  for (std::size_t block = 0; block < reader.hand_block_count(); ++block) {
    unread.read([&] {
      const auto paths = reader.load_hand(block);
      writer.write_hand(paths, stamped_time_s(paths.get()));
    });
  }
  for (const char* table : kTables) {
    if (is_plain_file(session / table)) replace_file(output / table, read_whole_file(session / table));
  }
  writer.close();
  unread.report(report.notes);
  if (reader.skipped_row_count() > 0) {
    report.notes.push_back("warning: left out " + std::to_string(reader.skipped_row_count()) +
                           " row(s), which can't be read or were changed; run pellucida check on the old session");
  }
  if (reader.head_changed()) {
    report.notes.emplace_back("warning: session.json was changed after it was written; check calibration and profile");
  }
  report.after = writer.counts();
  return report;
}

}  // namespace pellucida
