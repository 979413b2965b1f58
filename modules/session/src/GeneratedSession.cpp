#include "pellucida/session/GeneratedSession.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

#include "Checksum.h"
#include "DiskFile.h"
#include "PartPacker.h"
#include "SessionFolder.h"
#include "SessionIndex.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/session/SessionWriter.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

// File systems allow some 65,000 names of one file, some fewer.
constexpr long kNamesPerFile = 1000;

// Without the rename of a real one: nothing of it has to outlive a crash.
void put_file(const fs::path& file, std::string_view content) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644);
  const bool whole =
      descriptor >= 0 && ::write(descriptor, content.data(), content.size()) == static_cast<ssize_t>(content.size());
  const int reason = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!whole) throw disk_error(file, reason);
}

class Generator {
 public:
  Generator(const fs::path& folder, const GeneratedSession& wanted)
      : folder_(folder), wanted_(wanted), packer_(wanted.layout), stand_in_(empty_poly_file()) {}

  void add(const Scene& scene, long frame) {
    Measurement row = scene.measurement;
    row.frame = frame;
    row.time_s = static_cast<double>(frame) / wanted_.frame_rate_hz;
    SessionStep step{.frame_index = frame, .time_s = row.time_s};
    add_part(step, SessionPart::kSurface, scene.surface);
    add_part(step, SessionPart::kMembranes, scene.membranes);
    add_part(step, SessionPart::kTools, scene.tools);
    add_part(step, SessionPart::kFrame, scene.frame);
    rows_ += signed_row(to_csv(row)) + '\n';
    steps_.push_back(step);
  }

  // The tables that the writer began go on.
  void finish() const {
    for (const auto& [name, text] :
         {std::pair(session_name::kMeasurements, &rows_), std::pair(session_name::kChecksums, &checksums_)}) {
      replace_file(folder_ / name, read_whole_file(folder_ / name) + *text);
    }
    replace_file(folder_ / session_name::kPvd, make_pvd(steps_, true));
  }

 private:
  template <class T>
  void add_part(SessionStep& step, SessionPart part, const Frozen<T>& data) {
    if (!data) return;
    const DataName name = data_name(part, step.frame_index);
    const std::string* content = &stand_in_;
    std::string whole;
    if (step.frame_index % wanted_.whole_every == 0) {
      auto copy = data.shallow_copy();
      stamp(copy, step.time_s, step.frame_index);
      whole = packer_.pack(part, copy.Get(), Packing::kSmall);
      put_file(folder_ / data_file(name), whole);
      content = &whole;
    } else {
      put_stand_in(folder_ / data_file(name));
    }
    const FileChecksum checksum{.name = name, .byte_count = content->size(), .crc32 = crc32_of(*content)};
    checksums_ += signed_row(to_csv(checksum)) + '\n';
    step.present[static_cast<std::size_t>(part)] = true;
  }

  // Another name of one small file: a file each would cost the disk minutes, and a name is all that is looked at.
  void put_stand_in(const fs::path& file) {
    if (stand_in_count_++ % kNamesPerFile == 0) {
      put_file(file, stand_in_);
      stand_in_file_ = file;
    } else if (::link(stand_in_file_.c_str(), file.c_str()) != 0) {
      throw disk_error(file, errno);
    }
  }

  const fs::path folder_;
  const GeneratedSession wanted_;
  PartPacker packer_;
  fs::path stand_in_file_;
  long stand_in_count_ = 0;
  const std::string stand_in_;
  std::vector<SessionStep> steps_;
  std::string rows_;
  std::string checksums_;
};

}  // namespace

void generate_session(const fs::path& folder, const SessionInfo& info, const std::vector<Scene>& scenes,
                      const GeneratedSession& wanted) {
  if (scenes.empty()) throw std::invalid_argument("a generated session needs a scene");
  SessionWriter writer(folder, info, {.frames = true, .layout = wanted.layout, .rewritten = {}});
  writer.close();
  Generator generator(folder, wanted);
  for (long frame = 0; frame < wanted.step_count; ++frame) {
    generator.add(scenes[static_cast<std::size_t>(frame) % scenes.size()], frame);
  }
  generator.finish();
}

}  // namespace pellucida
