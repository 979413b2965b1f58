#include "presenters/HintDraft.h"

#include <algorithm>
#include <cmath>

#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

// Times of one frame are equal but for the digits of a table.
constexpr double kSameFrame_s = 5e-4;

std::string words_of(PersonHint::Kind kind) {
  switch (kind) {
    case PersonHint::Kind::kCell:
      return say("cell");
    case PersonHint::Kind::kNeedleTip:
      return say("tip");
    case PersonHint::Kind::kNoCell:
      return say("no cell");
    case PersonHint::Kind::kHolder:
      return say("holding pipette");
    case PersonHint::Kind::kCellOutline:
      return say("cell's outline");
    case PersonHint::Kind::kTakeBack:
      break;
  }
  return say("taken back");
}

bool same_frame(double one_s, double other_s) {
  return std::abs(one_s - other_s) < kSameFrame_s;
}

}  // namespace

HintMark hint_mark(const PersonHint& hint) {
  HintMark mark{{hint.x_um, hint.y_um}, words_of(hint.kind), {}};
  if (hint.outline_um.empty()) return mark;
  mark.place_um = {hint.outline_um.front()[0], hint.outline_um.front()[1]};
  for (std::size_t k = 1; k <= hint.outline_um.size(); ++k) {
    const PersonHint::Place_um& place = hint.outline_um[k % hint.outline_um.size()];
    mark.further_um.emplace_back(place[0], place[1]);
  }
  return mark;
}

void HintDraft::add(const PersonHint& hint) {
  std::erase_if(hints_, [&](const PersonHint& other) {
    return other.kind == hint.kind && same_frame(other.since_s, hint.since_s);
  });
  hints_.push_back(as_stored(hint));
}

bool HintDraft::take_back() {
  if (hints_.empty()) return false;
  hints_.pop_back();
  return true;
}

std::vector<PersonHint> HintDraft::hints() const {
  std::vector<PersonHint> sorted = hints_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const PersonHint& one, const PersonHint& other) { return one.since_s < other.since_s; });
  return sorted;
}

std::vector<HintMark> HintDraft::marks_at(double time_s) const {
  std::vector<HintMark> marks;
  for (const PersonHint& hint : hints_) {
    if (same_frame(hint.since_s, time_s)) marks.push_back(hint_mark(hint));
  }
  return marks;
}

std::string HintDraft::text() const {
  if (hints_.empty()) return {};
  std::string text = std::to_string(hints_.size()) + (hints_.size() == 1 ? say(" hint") : say(" hints"));
  const char* separator = ": ";
  for (const PersonHint& hint : hints()) {
    text += separator + words_of(hint.kind) + say(" at ") + readout::time(hint.since_s);
    separator = ", ";
  }
  return text;
}

std::filesystem::path corrected_folder(const std::filesystem::path& session) {
  std::filesystem::path whole = std::filesystem::absolute(session).lexically_normal();
  if (whole.filename().empty()) whole = whole.parent_path();
  const std::string name = whole.filename().string() + "-corrected";
  std::filesystem::path folder = whole.parent_path() / name;
  for (int number = 2; std::filesystem::exists(folder); ++number) {
    folder = whole.parent_path() / (name + "-" + std::to_string(number));
  }
  return folder;
}

}  // namespace pellucida
