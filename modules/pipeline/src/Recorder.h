#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "ArrivalQueue.h"
#include "FrameStretch.h"
#include "pellucida/core/Clock.h"
#include "pellucida/core/Stage.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/session/SessionWriter.h"

namespace pellucida {

/// How much may wait for the disk: a quarter of the computer's memory, at most 2 GiB.
std::size_t recording_memory_bytes();

/// Writes every frame of a live run, in order, on a thread of its own. A frame is announced when it arrives and settled
/// when its fate is known (measured, or overtaken by a newer one before it could be): frames settle in any order and
/// are written in the order they arrived. No call but the constructor and `close` waits for the disk; all may come from
/// any thread.
///
/// What the disk has no time for waits in memory, and is packed less to catch up. As the memory allowed fills, frames
/// are written without their surface first (from half of it on, event `thinned`), then without their image (from 7/8
/// on, event `dropped`), at last without contours and tools; rows, events, the plan and the recording of the hand are
/// always written. What happens to frame after frame (not measured, surface or image left out, lost by the source) is
/// one event for a stretch of frames.
class Recorder {
 public:
  /// Throws OutputError or UsageError as SessionWriter does. `clock` must outlive the recorder. `before_write` is
  /// called on the writer's thread before each frame is written: a test blocks there as a slow disk would.
  Recorder(const std::filesystem::path& folder, const SessionInfo& info, const Clock& clock,
           std::size_t memory_bytes = recording_memory_bytes(), std::function<void()> before_write = {});
  ~Recorder();

  /// A frame arrived; `scene` holds only its image.
  void announce(const Scene& scene);
  /// What became of an announced frame; others are ignored.
  void settle(const Scene& scene);
  /// False when a fault has ended the recording: the event is for the caller to keep.
  bool event(const Event& event);
  /// The next block of the recording of the hand; false when the memory is full: the block is for the caller to keep.
  bool hand(const Frozen<vtkPolyData>& block, double time_s);
  void plan(const std::string& plan_json);
  void palpation(const std::string& palpation_json);
  void clocks(const std::string& clocks_json);
  /// Frames still unsettled are written as not measured, then all is closed. Throws OutputError when the disk refused.
  void close();

  std::string folder() const { return folder_; }
  /// Frames written, each with its row.
  std::uint64_t written_count() const noexcept { return step_.written_count.load(); }
  /// Frames without an image, or, after a fault, not written at all.
  std::uint64_t dropped_count() const noexcept { return step_.dropped_count.load() + lost_count_.load(); }
  /// Frames written without the surface that they had.
  std::uint64_t thinned_count() const noexcept { return step_.thinned_count.load(); }
  /// Memory that what waits for the disk takes.
  std::size_t waiting_bytes() const { return queue_.load().byte_count(); }
  /// The reason the recording can't go on, when there is one.
  std::optional<std::string> fault() const;

 private:
  struct RecordedFrame {
    Scene scene;
    std::string_view dropped_because;  // why its image was left out; empty: it was not
    std::string_view thinned_because;  // the same of its surface
    long gap_count = 0;                // frames the source lost before it
  };
  struct HapticPathBlock {
    Frozen<vtkPolyData> paths;
    double time_s = 0.0;
  };
  struct Plan {
    std::string json;
  };
  struct ScaleRecord {
    std::string json;
  };
  struct ClockRecord {
    std::string json;
  };
  using Item = std::variant<RecordedFrame, Event, HapticPathBlock, Plan, ScaleRecord, ClockRecord>;
  using Queue = ArrivalQueue<Item>;

  // The writer's thread.
  struct WriteStep {
    using Input = Item;
    using Output = bool;  // true for a frame
    expected<bool, StepFailure> process(const Item& item);
    void write(const RecordedFrame& frame);
    void tell_unmeasured(const std::optional<FrameStretch>& stretch);
    void tell_dropped(const std::optional<FrameStretch>& stretch);
    void tell_thinned(const std::optional<FrameStretch>& stretch);
    void tell_gaps(const std::optional<FrameStretch>& stretch);
    void finish();

    SessionWriter& writer;
    const Queue& queue;
    const std::size_t hurry_bytes;  // with more than this waiting, frames are packed less
    std::atomic<std::uint64_t> written_count{0};
    std::atomic<std::uint64_t> dropped_count{0};
    std::atomic<std::uint64_t> thinned_count{0};
    std::atomic<bool> disk_bound{false};  // the last writes took longer on the disk than on the processor
    FrameStretchFinder unmeasured{};
    FrameStretchFinder dropped{};
    FrameStretchFinder thinned{};
    FrameStretchFinder gaps{};
    std::string_view dropped_because{};
    std::string_view thinned_because{};
    std::function<void()> before_write{};
  };

  // The frame as it is written, and its weight: whole where there is room for it, else without its heaviest parts.
  std::pair<RecordedFrame, std::size_t> fit(const Scene& scene) const;
  // What is too slow, in words.
  std::string_view slow_part(const QueueLoad& load) const;

  std::string folder_;
  const std::size_t memory_bytes_;
  SessionWriter writer_;
  Queue queue_;
  WriteStep step_;
  Stage<WriteStep, Queue> stage_;
  std::atomic<std::uint64_t> lost_count_{0};
};

}  // namespace pellucida
