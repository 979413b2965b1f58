#pragma once
#include <memory>
#include <string_view>

#include "pellucida/acquisition/FrameSource.h"
#include "pellucida/simulation/Scenario.h"
#include "pellucida/simulation/Truth.h"

namespace pellucida {

/// A scenario as a source of frames: a script moves the needle, the specimen answers, the renderer draws.
/// Deterministic: the same scenario gives the same bytes. Used by one thread at a time.
class VirtualMicroscope : public FrameSource {
 public:
  /// Throws UsageError (values that don't go together, a depth beyond the reference), InputError (a broken resource).
  explicit VirtualMicroscope(const Scenario& scenario);
  ~VirtualMicroscope() override;

  const SourceInfo& info() const noexcept override;
  /// The next frame as fast as it goes; nothing after the last. `time_s` = index / frame rate.
  std::optional<Frame> next() override;
  /// Passes over the next frame without drawing it, as if it had been lost; false after the last.
  bool skip();

  /// Begins again with frame 0: the same frames once more. Always true.
  bool restart() override;
  /// What is true of the frame given last. Before the first frame: of frame 0's time, not drawn.
  const Truth& truth() const noexcept;
  const Scenario& scenario() const noexcept;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// The microscope of a shipped scenario or a JSON file; its `info().name` is "virtual:<scenario>".
/// Throws as load_scenario and the constructor.
std::unique_ptr<VirtualMicroscope> open_virtual(std::string_view scenario);

}  // namespace pellucida
