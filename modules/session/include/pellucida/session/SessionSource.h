#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/core_vtk/FrameSource.h"
#include "pellucida/session/FramesUsed.h"
#include "pellucida/session/SessionReader.h"

namespace pellucida {

/// Which frames of a recording are played, and in which order.
struct PlaybackOptions {
  std::optional<double> from_s;         ///< first time played, of the recording (default: its beginning)
  std::optional<double> to_s;           ///< last time played (default: its end)
  int every = 1;                        ///< each so many-th frame, >= 1
  int loop_count = 1;                   ///< how often, >= 0; 0: without an end
  bool backwards = false;               ///< from the last frame to the first
  std::optional<double> pixel_size_um;  ///< instead of the recorded one, 0.001..100
  bool all_frames =
      false;  ///< every frame goes through the whole chain, also where the recorded run had no time for it

  /// Nothing but the frames as they were recorded, once.
  bool plain() const noexcept {
    return !from_s && !to_s && every == 1 && loop_count == 1 && !backwards && !pixel_size_um;
  }
};

/// True for a folder that holds a session.
bool is_session(const std::filesystem::path& folder) noexcept;

/// A recorded session as a source of frames: the images with the times, numbers and pixel size they were recorded with,
/// to the bit. `Frame::use` says how far the recorded run took each frame, so that a batch over a live recording
/// repeats exactly what was measured then.
///
/// A frame whose image was not recorded, or can't be read, is skipped and counted; it counts as a gap, and no other
/// frame's time changes. In the first pass forwards, frames keep their numbers and times. In later passes numbers and
/// times go on rising, a frame period after the last, and `run_index` rises. Backwards, times are mirrored: a film run
/// in reverse. `restart` begins with the first pass.
class SessionSource : public FrameSource {
 public:
  /// Throws InputError when the folder holds no readable session, none of its images, or no pixel size; UsageError for
  /// an option out of its range, or a range of time without a frame.
  explicit SessionSource(const std::filesystem::path& folder, const PlaybackOptions& options = {});
  ~SessionSource() override;

  const SourceInfo& info() const noexcept override;
  std::optional<Frame> next() override;
  bool restart() override;

  const SessionReader& session() const noexcept;
  /// Frames chosen, with or without an image, in one pass.
  long chosen_count() const noexcept;
  /// Of those passed so far, in all passes: without an image.
  long absent_count() const noexcept;
  /// With an image that can't be read, and why the first of them can't; empty for none.
  long damaged_count() const noexcept;
  const std::string& first_damage() const noexcept;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// The steps of one pass, in their order: those between `from_s` and `to_s`, every so many-th, turned round where
/// asked. Throws InputError for a session without a step, UsageError for an option out of its range, or where nothing
/// is left.
std::vector<std::size_t> chosen_steps(const SessionReader& session, const PlaybackOptions& options);

/// How far the recorded run took a step. `used`: what the session says of it (`frames_used_of`); without it the step's
/// numbers tell.
FrameUse recorded_use(const SessionReader& session, const std::optional<FramesUsed>& used, std::size_t step);

}  // namespace pellucida
