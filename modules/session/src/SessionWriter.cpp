#include "pellucida/session/SessionWriter.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <vector>

#include "Checksum.h"
#include "DiskFile.h"
#include "DiskSync.h"
#include "PartPacker.h"
#include "SessionFolder.h"
#include "SessionIndex.h"
#include "SessionJson.h"
#include "SessionProvenance.h"
#include "StepStamp.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

using Seconds = std::chrono::duration<double>;
using SteadyTime = std::chrono::steady_clock::time_point;

// The list of files grows with the session: it is rewritten so seldom that this share of the time is never exceeded.
constexpr double kPvdTimeShare = 0.02;
constexpr Seconds kHeadPeriod{1.0};
constexpr double kRowDigits_ratio = 1e-8;

std::string now_utc() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

// Refuses to touch a folder that holds a session, or any part of one.
std::filesystem::path new_session_folder(const std::filesystem::path& folder) {
  make_folder(folder);
  std::vector<std::string> own{session_name::kJson,     session_name::kPvd,     session_name::kMeasurements,
                               session_name::kEvents,   session_name::kHaptics, session_name::kEmpty,
                               session_name::kChecksums};
  for (const PartNames& names : kParts) own.emplace_back(names.folder);
  for (const std::string& name : own) {
    if (is_present(folder / name)) {
      throw UsageError(folder.string() + ": already holds a session (" + name +
                       "), which is never overwritten; choose another folder");
    }
  }
  return folder;
}

}  // namespace

class SessionWriter::Impl {
 public:
  Impl(const std::filesystem::path& folder, const SessionInfo& info, SessionOptions options)
      : folder_(new_session_folder(folder)),
        head_{.info = info, .options = options, .created = options.rewritten ? options.rewritten->created : now_utc()},
        packer_(options.layout),
        given_provenance_json_(info.provenance_json) {
    // The head comes first: from here on the folder is a session.
    write_head();
    for (const PartNames& names : kParts) {
      if (names.part != SessionPart::kFrame || options.frames) make_folder(folder_ / names.folder);
    }
    replace_file(folder_ / session_name::kEmpty, empty_poly_file());
    checksums_ = make_table(session_name::kChecksums, session_name::kChecksumsHeader);
    measurements_ = make_table(session_name::kMeasurements, measurement_header());
    measurements_->lock();
    events_ = make_table(session_name::kEvents, session_name::kEventsHeader);
    write_pvd();
    sync_ = std::make_unique<DiskSync>(folder_, options.sync);
  }

  void write(const Scene& scene, Packing packing, const StepParts& ready) {
    require_open();
    cost_ = {};
    const SteadyTime start = std::chrono::steady_clock::now();
    const Measurement& row = scene.measurement;
    if (!steps_.empty() && row.frame <= steps_.back().frame_index) {
      throw Error(ExitCode::kOurFault, folder_.string() + ": frame " + std::to_string(row.frame) + " after frame " +
                                           std::to_string(steps_.back().frame_index) + "; frame numbers must rise");
    }
    // Files first, then the row that speaks of them. A step that doesn't get that far leaves nothing behind.
    SessionStep step{.frame_index = row.frame, .time_s = row.time_s};
    SessionCounts counts = head_.counts;
    step_byte_count_ = 0;
    step_checksums_.clear();
    const std::uint64_t checksum_bytes = checksums_->byte_count();
    try {
      if (ready.surface) {
        write_surface(step, ready, counts);
      } else {
        write_part(step, SessionPart::kSurface, scene.surface, counts, packing);
      }
      if (ready.membranes) {
        put_part(step, SessionPart::kMembranes, *ready.membranes, counts);
      } else {
        write_part(step, SessionPart::kMembranes, scene.membranes, counts, packing);
      }
      if (ready.tools) {
        put_part(step, SessionPart::kTools, *ready.tools, counts);
      } else {
        write_part(step, SessionPart::kTools, scene.tools, counts, packing);
      }
      if (head_.options.frames) write_part(step, SessionPart::kFrame, scene.frame, counts, packing);
      if (!step_checksums_.empty()) checksums_->append(step_checksums_);
      measurements_->append(signed_row(to_csv(row)));
    } catch (...) {
      remove_files(step);
      if (checksums_->byte_count() != checksum_bytes) checksums_->shrink_to(checksum_bytes);
      throw;
    }
    steps_.push_back(step);
    if (!head_.options.rewritten) provenance_.add(scene);
    head_.counts = counts;
    ++head_.counts.step_count;
    if (!row.state) ++head_.counts.unmeasured_count;
    file_byte_count_ += step_byte_count_;
    for (const Event& event : scene.events) append_event(event);
    refresh();
    cost_.disk_s = Seconds(std::chrono::steady_clock::now() - start).count() - cost_.packing_s;
  }

  const WriteCost& last_cost() const noexcept { return cost_; }

  void write_hand(const Frozen<vtkPolyData>& block, double time_s) {
    require_open();
    if (!block) return;
    const auto number = static_cast<long>(head_.counts.hand_block_count);
    if (number == 0) make_folder(folder_ / session_name::kHaptics);
    auto copy = block.shallow_copy();
    stamp(copy, time_s, number);
    const std::string content = packer_.pack_hand(copy.Get());
    replace_file(folder_ / hand_file(number), content);
    checksums_->append(checksum_row({kHandKind, number}, content.size(), crc32_of(content)));
    ++head_.counts.hand_block_count;
    file_byte_count_ += content.size();
    refresh();
  }

  void event(const Event& event) {
    require_open();
    append_event(event);
    refresh();
  }

  void close() {
    if (closed_) return;
    if (!events_in_order_) sort_events(folder_ / session_name::kEvents);
    write_pvd();
    head_.complete = !was_cut_off();
    head_.recovered = was_cut_off();
    try {
      write_head();
      sync_->mark();
      sync_->finish();
    } catch (...) {
      head_.complete = false;
      head_.recovered = false;
      throw;
    }
    measurements_->unlock();
    closed_ = true;
  }

  const SessionCounts& counts() const noexcept { return head_.counts; }
  const std::filesystem::path& folder() const noexcept { return folder_; }

  void set_plan(std::string plan_json) { head_.info.plan_json = std::move(plan_json); }
  void set_clocks(std::string clocks_json) { head_.info.clocks_json = std::move(clocks_json); }
  void set_palpation(std::string palpation_json) { head_.info.palpation_json = std::move(palpation_json); }
  void set_provenance(std::string provenance_json) { given_provenance_json_ = std::move(provenance_json); }

 private:
  void require_open() const {
    if (closed_) throw Error(ExitCode::kOurFault, folder_.string() + ": the session is closed; nothing can be added");
    sync_->rethrow();
  }

  // Every table's rows end with their checksums.
  std::unique_ptr<AppendFile> make_table(const char* name, std::string_view header) const {
    return std::make_unique<AppendFile>(folder_ / name, std::string(header) + ',' + kRowChecksum);
  }

  static std::string checksum_row(const DataName& name, std::uint64_t byte_count, std::uint32_t crc32) {
    return signed_row(to_csv(FileChecksum{.name = name, .byte_count = byte_count, .crc32 = crc32}));
  }

  template <class T>
  void write_part(SessionStep& step, SessionPart part, const Frozen<T>& data, SessionCounts& counts, Packing packing) {
    if (!data) return;
    auto copy = data.shallow_copy();
    // The row is what counts: a part that says otherwise (or nothing) is stamped like it.
    // Read from a session's rows, times have nine digits; the stamps of its files have all.
    const double tolerance_s = head_.options.rewritten ? kRowDigits_ratio * (1.0 + std::abs(step.time_s)) : 0.0;
    stamp_as(copy, step.time_s, step.frame_index, tolerance_s);
    pack_and_put(step, part, counts, [&] { return packer_.pack(part, copy.Get(), packing); });
  }

  // A surface that is narrowed already, parts of it packed.
  void write_surface(SessionStep& step, const StepParts& ready, SessionCounts& counts) {
    stamp_as(ready.surface, step.time_s, step.frame_index, 0.0);
    pack_and_put(step, SessionPart::kSurface, counts,
                 [&] { return packer_.pack_narrowed(ready.surface, ready.surface_arrays.get()); });
  }

  template <class Pack>
  void pack_and_put(SessionStep& step, SessionPart part, SessionCounts& counts, Pack pack) {
    const SteadyTime start = std::chrono::steady_clock::now();
    PackedPart packed{.content = pack(), .crc32 = 0};
    packed.crc32 = crc32_of(packed.content);
    cost_.packing_s += Seconds(std::chrono::steady_clock::now() - start).count();
    put_part(step, part, packed, counts);
  }

  void put_part(SessionStep& step, SessionPart part, const PackedPart& packed, SessionCounts& counts) {
    const std::string& content = packed.content;
    replace_file(folder_ / part_file(part, step.frame_index), content);
    if (!step_checksums_.empty()) step_checksums_ += '\n';
    step_checksums_ += checksum_row(data_name(part, step.frame_index), content.size(), packed.crc32);
    step.present[static_cast<std::size_t>(part)] = true;
    ++counts.file_count[static_cast<std::size_t>(part)];
    step_byte_count_ += content.size();
  }

  void remove_files(const SessionStep& step) const {
    for (const PartNames& names : kParts) {
      std::error_code ignored;
      if (step.has(names.part)) std::filesystem::remove(folder_ / part_file(names.part, step.frame_index), ignored);
    }
  }

  void append_event(const Event& event) {
    events_->append(signed_row(csv_number(event.time_s) + ',' + csv_cell(event.kind) + ',' + csv_cell(event.detail)));
    ++head_.counts.event_count;
    count_left_out(event, head_.counts);
    events_in_order_ = events_in_order_ && event.time_s >= last_event_s_;
    last_event_s_ = event.time_s;
  }

  // After each write: the head about once a second, the list of files at intervals that grow with what it costs.
  void refresh() {
    head_.counts.byte_count = file_byte_count_ + measurements_->byte_count() + events_->byte_count();
    sync_->mark();
    const SteadyTime now = std::chrono::steady_clock::now();
    if (now >= next_head_) write_head();
    if (now >= next_pvd_) write_pvd();
  }

  bool was_cut_off() const noexcept { return head_.options.rewritten && head_.options.rewritten->cut_off; }

  void write_head() {
    head_.info.provenance_json =
        head_.options.rewritten ? given_provenance_json_ : provenance_.merged_into(given_provenance_json_);
    replace_file(folder_ / session_name::kJson, to_json(head_));
    next_head_ = later(kHeadPeriod);
  }

  void write_pvd() {
    const SteadyTime start = std::chrono::steady_clock::now();
    replace_file(folder_ / session_name::kPvd, make_pvd(steps_, head_.options.frames));
    const Seconds cost = std::chrono::steady_clock::now() - start;
    next_pvd_ = later(std::max(kHeadPeriod, cost / kPvdTimeShare));
  }

  static SteadyTime later(Seconds delay) {
    return std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(delay);
  }

  std::filesystem::path folder_;
  SessionHead head_;
  PartPacker packer_;
  std::string given_provenance_json_;
  ProvenanceLog provenance_;
  std::vector<SessionStep> steps_;
  std::uint64_t file_byte_count_ = 0;
  std::uint64_t step_byte_count_ = 0;
  std::string step_checksums_;  // rows of one step, without the last line end
  std::unique_ptr<AppendFile> checksums_;
  std::unique_ptr<AppendFile> measurements_;
  std::unique_ptr<AppendFile> events_;
  bool events_in_order_ = true;
  double last_event_s_ = -std::numeric_limits<double>::infinity();
  WriteCost cost_;
  std::unique_ptr<DiskSync> sync_;
  SteadyTime next_head_;
  SteadyTime next_pvd_;
  bool closed_ = false;
};

SessionWriter::SessionWriter(const std::filesystem::path& folder, const SessionInfo& info, SessionOptions options)
    : impl_(std::make_unique<Impl>(folder, info, options)) {}
SessionWriter::~SessionWriter() = default;

void SessionWriter::write(const Scene& scene, Packing packing) {
  impl_->write(scene, packing, {});
}
void SessionWriter::write(const Scene& scene, const StepParts& ready) {
  impl_->write(scene, Packing::kSmall, ready);
}
const WriteCost& SessionWriter::last_cost() const noexcept {
  return impl_->last_cost();
}
void SessionWriter::event(const Event& event) {
  impl_->event(event);
}
void SessionWriter::write_hand(const Frozen<vtkPolyData>& block, double time_s) {
  impl_->write_hand(block, time_s);
}
void SessionWriter::set_plan(std::string plan_json) {
  impl_->set_plan(std::move(plan_json));
}
void SessionWriter::set_clocks(std::string clocks_json) {
  impl_->set_clocks(std::move(clocks_json));
}
void SessionWriter::set_palpation(std::string palpation_json) {
  impl_->set_palpation(std::move(palpation_json));
}
void SessionWriter::set_provenance(std::string provenance_json) {
  impl_->set_provenance(std::move(provenance_json));
}
void SessionWriter::close() {
  impl_->close();
}
const SessionCounts& SessionWriter::counts() const noexcept {
  return impl_->counts();
}
const std::filesystem::path& SessionWriter::folder() const noexcept {
  return impl_->folder();
}

}  // namespace pellucida
