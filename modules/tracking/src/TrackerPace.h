#pragma once

namespace pellucida {

// A needle with no cell: how far it may go between two frames, and when it counts as gone.
inline constexpr double kNeedleReach_px = 34.0, kLeastNeedleConfidence = 0.1;
// While a cell has no needle: frames between two looks at the whole image; frames in which a cell is new, or its needle
// newly lost, and a third as many lie between them.
inline constexpr int kNeedleSearch_frames = 10, kNewCell_frames = 10;
// Of the way from where a needle without a cell was followed to, to where its tip is read.
inline constexpr double kLoneTipShare = 0.5;
// While a cell is followed by lines and has no needle: frames between two looks of the network.
inline constexpr int kConfirmation_frames = 30;
// While a cell is followed by lines: frames between two readings of where it is by the networks, and of these so many
// in a row that contradict the lines.
inline constexpr int kReread_frames = 8, kDisagreements = 2;
// Searches that find nothing until the cell that was lost is forgotten: what is found later may be another one.
inline constexpr int kRemembered_searches = 5;

/// When the whole image is searched for the needle of a cell that has none.
class NeedleSearch {
 public:
  /// For each frame once.
  bool is_due(bool has_needle, int frames_since_detection) noexcept {
    frames_without_ = has_needle ? 0 : frames_without_ + 1;
    const bool is_new = frames_since_detection < kNewCell_frames || frames_without_ < kNewCell_frames;
    return !has_needle && frames_without_ % (is_new ? kNeedleSearch_frames / 3 : kNeedleSearch_frames) == 1;
  }

 private:
  int frames_without_ = 0;
};

}  // namespace pellucida
