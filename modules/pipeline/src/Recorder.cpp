#include "Recorder.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>

namespace pellucida {
namespace {

constexpr std::size_t kMostMemory_bytes = std::size_t{2} << 30U;
// Of the memory allowed: beyond it, quick packing counts for more than small files.
constexpr std::size_t kHurryShare = 8;
// Of the memory allowed, in eighths: what may be taken by frames with surfaces, and by frames with images. The last
// eighth is for rows, events, contours and the hand.
constexpr std::size_t kSurfaceEighths = 4;
constexpr std::size_t kImageEighths = 7;

template <class T>
std::size_t bytes_of(const Frozen<T>& part) {
  // VTK counts in KiB, and only what is not const.
  return part ? std::size_t{1024} * const_cast<T*>(part.get())->GetActualMemorySize() : 0;
}

std::size_t bytes_of(const Scene& scene) {
  return sizeof(Scene) + bytes_of(scene.frame) + bytes_of(scene.membranes) + bytes_of(scene.tools) +
         bytes_of(scene.surface);
}

// Takes the events of frames lost by the source out of a scene: how many frames they speak of.
long take_gaps(std::vector<Event>& events) {
  long gap_count = 0;
  std::erase_if(events, [&](const Event& event) {
    if (event.kind != event_kind::kGap) return false;
    long count = 1;
    std::from_chars(event.detail.data(), event.detail.data() + event.detail.size(), count);
    gap_count += count;
    return true;
  });
  return gap_count;
}

std::string frames_of(const FrameStretch& stretch) {
  if (stretch.frame_count == 1) return "1 frame (" + std::to_string(stretch.first_frame) + ")";
  return std::to_string(stretch.frame_count) + " frames (within " + std::to_string(stretch.first_frame) + " to " +
         std::to_string(stretch.last_frame) + ")";
}

}  // namespace

std::size_t recording_memory_bytes() {
  const auto pages = static_cast<std::size_t>(std::max(0L, sysconf(_SC_PHYS_PAGES)));
  const auto page_bytes = static_cast<std::size_t>(std::max(0L, sysconf(_SC_PAGESIZE)));
  return std::min(kMostMemory_bytes, pages * page_bytes / 4);
}

expected<bool, StepFailure> Recorder::WriteStep::process(const Item& item) {
  if (const auto* frame = std::get_if<RecordedFrame>(&item)) {
    write(*frame);
    return true;
  }
  if (const auto* event = std::get_if<Event>(&item)) writer.event(*event);
  if (const auto* block = std::get_if<HapticPathBlock>(&item)) writer.write_hand(block->paths, block->time_s);
  if (const auto* plan = std::get_if<Plan>(&item)) writer.set_plan(plan->json);
  if (const auto* scale = std::get_if<ScaleRecord>(&item)) writer.set_palpation(scale->json);
  if (const auto* clocks = std::get_if<ClockRecord>(&item)) writer.set_clocks(clocks->json);
  return false;
}

void Recorder::WriteStep::write(const RecordedFrame& frame) {
  if (before_write) before_write();
  writer.write(frame.scene, queue.load().byte_count() > hurry_bytes ? Packing::kQuick : Packing::kSmall);
  ++written_count;
  disk_bound = writer.last_cost().disk_s > writer.last_cost().packing_s;

  const Measurement& row = frame.scene.measurement;
  tell_unmeasured(unmeasured.add(row.frame, row.time_s, row.state ? 0 : 1));
  const bool is_dropped = !frame.dropped_because.empty();
  if (is_dropped) {
    ++dropped_count;
    dropped_because = frame.dropped_because;
  }
  tell_dropped(dropped.add(row.frame, row.time_s, is_dropped ? 1 : 0));
  const bool is_thinned = !frame.thinned_because.empty();
  if (is_thinned) {
    ++thinned_count;
    thinned_because = frame.thinned_because;
  }
  tell_thinned(thinned.add(row.frame, row.time_s, is_thinned ? 1 : 0));
  tell_gaps(gaps.add(row.frame, row.time_s, frame.gap_count));
}

void Recorder::WriteStep::tell_unmeasured(const std::optional<FrameStretch>& stretch) {
  if (!stretch) return;
  writer.event({stretch->begin_s, event_kind::kUnmeasured,
                frames_of(*stretch) + " kept without numbers: they came faster than the processor measures"});
}

void Recorder::WriteStep::tell_dropped(const std::optional<FrameStretch>& stretch) {
  if (!stretch) return;
  writer.event({stretch->begin_s, event_kind::kDropped,
                frames_of(*stretch) + " kept without their image: " + std::string(dropped_because)});
}

void Recorder::WriteStep::tell_thinned(const std::optional<FrameStretch>& stretch) {
  if (!stretch) return;
  writer.event({stretch->begin_s, event_kind::kThinned,
                frames_of(*stretch) + " kept without their surface: " + std::string(thinned_because)});
}

void Recorder::WriteStep::tell_gaps(const std::optional<FrameStretch>& stretch) {
  if (!stretch) return;
  const std::string first = std::to_string(stretch->first_frame), last = std::to_string(stretch->last_frame);
  std::string detail = stretch->frame_count == 1 ? "1 frame missing from the source before frame " + first
                                                 : std::to_string(stretch->frame_count) +
                                                       " frames missing from the source, the first before frame " +
                                                       first + ", the last before frame " + last;
  writer.event({stretch->begin_s, event_kind::kGap, std::move(detail)});
}

void Recorder::WriteStep::finish() {
  tell_unmeasured(unmeasured.finish());
  tell_dropped(dropped.finish());
  tell_thinned(thinned.finish());
  tell_gaps(gaps.finish());
}

Recorder::Recorder(const std::filesystem::path& folder, const SessionInfo& info, const Clock& clock,
                   std::size_t memory_bytes, std::function<void()> before_write)
    : folder_(folder.string()),
      memory_bytes_(memory_bytes),
      writer_(folder, info),
      step_{.writer = writer_,
            .queue = queue_,
            .hurry_bytes = memory_bytes / kHurryShare,
            .before_write = std::move(before_write)},
      stage_(
          step_, queue_, [](bool) {}, clock) {
  stage_.start();
}

Recorder::~Recorder() {
  stage_.stop();
}

std::pair<Recorder::RecordedFrame, std::size_t> Recorder::fit(const Scene& scene) const {
  // What no file holds need not wait for the disk.
  RecordedFrame frame{.scene = scene};
  frame.gap_count = take_gaps(frame.scene.events);
  frame.scene.model = {};
  frame.scene.observation.reset();
  const QueueLoad load = queue_.load();
  const auto has_room = [&](std::size_t eighths) {
    return load.byte_count() + bytes_of(frame.scene) <= memory_bytes_ / 8 * eighths;
  };
  if (frame.scene.surface && !has_room(kSurfaceEighths)) {
    frame.thinned_because = slow_part(load);
    frame.scene.surface = {};
  }
  if (!has_room(kImageEighths)) {
    frame.dropped_because = slow_part(load);
    frame.scene.frame = {};
  }
  if (!has_room(8)) {
    frame.scene.membranes = {};
    frame.scene.tools = {};
  }
  const std::size_t byte_count = bytes_of(frame.scene);
  return {std::move(frame), byte_count};
}

std::string_view Recorder::slow_part(const QueueLoad& load) const {
  if (load.unsettled_bytes > load.ready_bytes) return "measuring fell too far behind the camera";
  if (step_.disk_bound) return "the disk is slower than the camera";
  return "the processor is too busy to write as fast as the camera";
}

void Recorder::announce(const Scene& scene) {
  auto [frame, byte_count] = fit(scene);
  if (!queue_.announce(scene.measurement.frame, std::move(frame), byte_count)) ++lost_count_;
}

void Recorder::settle(const Scene& scene) {
  auto [frame, byte_count] = fit(scene);
  queue_.settle(scene.measurement.frame, std::move(frame), byte_count);
}

bool Recorder::event(const Event& event) {
  return queue_.push(event, sizeof(Event) + event.detail.size());
}

bool Recorder::hand(const Frozen<vtkPolyData>& block, double time_s) {
  const std::size_t byte_count = bytes_of(block);
  if (queue_.load().byte_count() + byte_count > memory_bytes_) return false;
  queue_.push(HapticPathBlock{block, time_s}, byte_count);
  return true;
}

void Recorder::plan(const std::string& plan_json) {
  queue_.push(Plan{plan_json}, plan_json.size());
}

void Recorder::palpation(const std::string& palpation_json) {
  queue_.push(ScaleRecord{palpation_json}, palpation_json.size());
}

void Recorder::clocks(const std::string& clocks_json) {
  queue_.push(ClockRecord{clocks_json}, clocks_json.size());
}

void Recorder::close() {
  queue_.close();
  stage_.join();
  // A fault left these behind.
  while (const auto item = queue_.wait({})) lost_count_ += std::holds_alternative<RecordedFrame>(*item) ? 1 : 0;
  stage_.rethrow();
  step_.finish();
  writer_.close();
}

std::optional<std::string> Recorder::fault() const {
  try {
    stage_.rethrow();
  } catch (const std::exception& error) {
    return error.what();
  }
  return std::nullopt;
}

}  // namespace pellucida
