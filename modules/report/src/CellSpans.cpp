#include "CellSpans.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "pellucida/core/NewCellNote.h"

namespace pellucida {
namespace {

/// What is found again within this time, place and size is the cell that was lost.
constexpr double kSameCell_s = 5.0;
constexpr double kSamePlace_ratio = 0.5;
constexpr double kSameSize_ratio = 0.05;

// Whether `now` may be the cell last seen in `before`; what was not measured speaks for neither.
bool may_be_same(const Measurement& before, const Measurement& now) {
  if (now.time_s - before.time_s > kSameCell_s) return false;
  const double radius_um = radius_um_of(before);
  const double away_um = std::hypot(now.cell_x_um - before.cell_x_um, now.cell_y_um - before.cell_y_um);
  const double growth = std::abs(radius_um_of(now) / radius_um - 1.0);
  return !(away_um > kSamePlace_ratio * radius_um) && !(growth > kSameSize_ratio);
}

class CellFinder {
 public:
  explicit CellFinder(const PassportInput& input) : input_(input) {}

  std::vector<CellSpan> run() {
    for (std::size_t i = 0; i < input_.rows.size(); ++i) take(i);
    close_contact(ContactEnd::kRecordingEnded);
    return std::move(cells_);
  }

 private:
  const Measurement& row(std::size_t i) const { return input_.rows[i]; }

  void take(std::size_t i) {
    const Measurement& now = row(i);
    if (is_new_beginning(i)) close_cell();
    if (!now.state) return;
    if (now.state == CellState::kNoCell) {
      close_cell();
    } else if (now.state == CellState::kLost) {
      if (open_ && !is_lost_) ++cells_.back().losses;
      is_lost_ = true;
    } else {
      see(i);
    }
  }

  // A note, a source that began anew, a clock that did.
  bool is_new_beginning(std::size_t i) {
    const double time_s = row(i).time_s;
    bool anew = i > 0 && time_s < row(i - 1).time_s;
    for (; next_event_ < input_.events.size() && input_.events[next_event_].time_s <= time_s; ++next_event_) {
      anew |= begins_new_cell(input_.events[next_event_]);
    }
    for (; next_start_ < input_.run_starts.size() && input_.run_starts[next_start_] <= row(i).frame; ++next_start_) {
      anew = true;
    }
    return anew;
  }

  void see(std::size_t i) {
    const Measurement& now = row(i);
    const bool was_lost = is_lost_;
    double away_s = 0.0;
    if (open_ && was_lost) {
      const Measurement& before = row(cells_.back().rows.end - 1);
      away_s = now.time_s - before.time_s;
      if (may_be_same(before, now)) {
        cells_.back().lost_s += away_s;
        away_s = 0.0;
      } else {
        close_cell();
      }
    }
    is_lost_ = false;
    if (!open_) {
      cells_.push_back({.rows = {i, i}, .away_s = away_s});
      open_ = true;
    }
    cells_.back().rows.end = i + 1;
    if (is_touching(now)) {
      touch(i);
    } else {
      is_free_seen_ = true;
      // After a loss nobody saw the release itself.
      close_contact(was_lost ? ContactEnd::kLost : ContactEnd::kReleased, now.time_s);
    }
  }

  void touch(std::size_t i) {
    auto& contacts = cells_.back().contacts;
    if (!in_contact_) contacts.push_back({.rows = {i, i}, .is_touch_seen = is_free_seen_});
    in_contact_ = true;
    contacts.back().rows.end = i + 1;
  }

  void close_contact(ContactEnd end, double release_s = ContactPassport::kNone) {
    if (!in_contact_) return;
    ContactSpan& contact = cells_.back().contacts.back();
    contact.end = end == ContactEnd::kRecordingEnded && is_lost_ ? ContactEnd::kLost : end;
    if (contact.end == ContactEnd::kReleased) contact.release_s = release_s;
    in_contact_ = false;
  }

  void close_cell() {
    close_contact(is_lost_ ? ContactEnd::kLost : ContactEnd::kRecordingEnded);
    open_ = false;
    is_lost_ = false;
    is_free_seen_ = false;
  }

  const PassportInput& input_;
  std::vector<CellSpan> cells_;
  std::size_t next_event_ = 0, next_start_ = 0;
  bool open_ = false, in_contact_ = false, is_lost_ = false, is_free_seen_ = false;
};

}  // namespace

double radius_um_of(const Measurement& row) noexcept {
  return std::cbrt(3.0 * row.volume_um3 / (4.0 * std::numbers::pi));
}

bool is_touching(const Measurement& row) noexcept {
  return row.state == CellState::kContact || row.state == CellState::kPunctured;
}

std::vector<CellSpan> find_cells(const PassportInput& input) {
  return CellFinder(input).run();
}

}  // namespace pellucida
