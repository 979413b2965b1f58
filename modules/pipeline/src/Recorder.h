#pragma once
#include <atomic>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <variant>

#include "pellucida/core/Clock.h"
#include "pellucida/core/Ring.h"
#include "pellucida/core/Stage.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/session/SessionWriter.h"

namespace pellucida {

/// Writes every frame of a live run, in order, on a thread of its own. A frame is announced when it arrives and settled
/// when its fate is known (measured, or replaced by a newer one before it could be): frames settle in any order and
/// from any thread, and are written in the order they arrived. A full queue drops whole frames, counted and reported as
/// events.
class Recorder {
 public:
  /// Throws OutputError or UsageError as SessionWriter does. `clock` must outlive the recorder.
  Recorder(const std::filesystem::path& folder, const SessionInfo& info, const Clock& clock);
  ~Recorder();

  /// A frame arrived; `scene` holds only its image.
  void announce(const Scene& scene);
  /// What became of an announced frame; others are ignored.
  void settle(const Scene& scene);
  void event(const Event& event);
  /// The next block of the recording of the hand; false when the queue is full: the block is for the caller to keep.
  bool hand(const Frozen<vtkPolyData>& block, double time_s);
  void plan(const std::string& plan_json);
  /// Frames still unsettled are written as not measured, then all is closed. Throws OutputError when the disk refused.
  void close();

  std::string folder() const { return folder_; }
  std::uint64_t written_count() const noexcept { return step_.written_count.load(); }
  std::uint64_t dropped_count() const noexcept { return dropped_count_.load(); }
  /// The reason the recording can't go on, when there is one.
  std::optional<std::string> fault() const;

 private:
  struct Pending {
    Scene scene;
    bool settled = false;
  };
  struct HapticPathBlock {
    Frozen<vtkPolyData> paths;
    double time_s = 0.0;
  };
  struct Plan {
    std::string json;
  };
  using Item = std::variant<Scene, Event, HapticPathBlock, Plan>;
  struct WriteStep {
    using Input = Item;
    using Output = bool;  // true for a frame
    expected<bool, StepFailure> process(const Item& item);
    SessionWriter& writer;
    std::atomic<std::uint64_t> written_count{0};
  };

  void flush();  // with mutex_ held

  static constexpr std::size_t kQueueCount = 128;
  std::string folder_;
  SessionWriter writer_;
  WriteStep step_{.writer = writer_};
  Ring<Item> queue_{kQueueCount};
  Stage<WriteStep, Ring<Item>> stage_;
  std::mutex mutex_;
  std::deque<Pending> pending_;
  std::deque<Event> owed_events_;  ///< of dropped frames, written as soon as there is room
  bool closed_ = false;
  std::atomic<std::uint64_t> dropped_count_{0};
};

}  // namespace pellucida
