#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "pellucida/core/PersonHint.h"
#include "pellucida/visualization/PlanMarks.h"

namespace pellucida {

/// A hint as a mark on the image.
HintMark hint_mark(const PersonHint& hint);

/// The hints that a person has given about a recorded session, before it is measured again with them.
class HintDraft {
 public:
  /// Two hints of one kind about one frame are one: the later.
  void add(const PersonHint& hint);
  /// The one given last; false when there is none.
  bool take_back();
  void clear() { hints_.clear(); }

  bool empty() const noexcept { return hints_.empty(); }
  /// In the order of time.
  std::vector<PersonHint> hints() const;
  /// Those of the frame at `time_s`, for the image.
  std::vector<HintMark> marks_at(double time_s) const;
  /// "2 hints: tip at 3.20 s, cell at 5.00 s"; empty without any.
  std::string text() const;

 private:
  std::vector<PersonHint> hints_;  // in the order given
};

/// Where the session measured again goes: beside the recorded one, "NAME-corrected", with a number where that is taken.
std::filesystem::path corrected_folder(const std::filesystem::path& session);

}  // namespace pellucida
