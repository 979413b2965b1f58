#pragma once
#include <memory>
#include <optional>

#include "SceneDifference.h"
#include "pellucida/core/Clock.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/membrane/Indenter.h"
#include "pellucida/pipeline/Counterfactual.h"
#include "pellucida/session/SessionReader.h"

namespace pellucida {

/// One recorded frame, ready for the mechanics.
struct RecordedFrame {
  Scene recorded;                            ///< contours, surface and row as they were recorded
  Scene scene;                               ///< the same frame tracked anew, or as it was tracked, and revolved
  CommonFields common;                       ///< of all variants' files; empty where tables alone are wanted
  std::shared_ptr<const SolvedShape> shape;  ///< of the recorded profile, for variants of its modulus; may be empty
};

/// The frames of a session as they enter the mechanics: what does not depend on a cell profile, done once for all
/// variants. One thread at a time.
class RecordedFrames {
 public:
  /// Throws as `run_counterfactual`.
  RecordedFrames(const SessionReader& session, const CounterfactualOptions& options);
  ~RecordedFrames();

  /// How many `next` will give, as far as is known beforehand.
  long expected_count() const noexcept;
  std::optional<RecordedFrame> next();

  /// Frames that were skipped, or kept without numbers, because what they were to be measured from is not there.
  long absent_count() const noexcept;
  /// And why the first of them; empty for none.
  std::string first_absence() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
