#include "presenters/CellLog.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

#include "pellucida/core/CellNameNote.h"
#include "pellucida/core/NewCellNote.h"
#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

constexpr std::array<std::string_view, 8> kTellingKinds{
    event_kind::kContact, event_kind::kRelease, event_kind::kPuncture, event_kind::kRevoked,
    event_kind::kLost,    event_kind::kFound,   event_kind::kStarted,  event_kind::kResumed};

// In the words of report/CellPassport, for lupdate.
[[maybe_unused]] constexpr const char* kOutcomes[] = {
    PELLUCIDA_WORDS("punctured"), PELLUCIDA_WORDS("retracted"), PELLUCIDA_WORDS("lost in contact"),
    PELLUCIDA_WORDS("still in contact"), PELLUCIDA_WORDS("not touched")};

bool tells_of_cells(const Event& event) {
  return begins_new_cell(event) || named_cell(event) ||
         std::find(kTellingKinds.begin(), kTellingKinds.end(), event.kind) != kTellingKinds.end();
}

}  // namespace

CellRow cell_row(const CellPassport& cell) {
  const ContactPassport& contact = cell.main_contact();
  CellRow row;
  row.name = cell.name.empty() ? std::to_string(cell.cell) : cell.name;
  row.outcome = say(outcome_words(contact));
  row.is_punctured = contact.outcome == "punctured";
  row.force = readout::number(row.is_punctured ? contact.puncture_force_uN : contact.peak_force_uN, 2);
  row.depth = readout::number(row.is_punctured ? contact.puncture_depth_um : contact.peak_force_depth_um, 1);
  row.work = readout::number(row.is_punctured ? contact.puncture_work_pJ : contact.work_pJ, 1);
  row.time = readout::number(row.is_punctured ? contact.puncture_s : contact.peak_force_s, 1);
  return row;
}

std::string next_cell_name(const std::string& name) {
  if (name.empty()) return "A-1";
  std::size_t begin = name.size();
  while (begin > 0 && std::isdigit(static_cast<unsigned char>(name[begin - 1])) != 0) --begin;
  constexpr std::size_t kMostDigits = 9;
  const std::size_t width = name.size() - begin;
  if (width == 0 || width > kMostDigits) return name + "-2";
  std::string number = std::to_string(std::stol(name.substr(begin)) + 1);
  if (number.size() < width) number.insert(0, width - number.size(), '0');
  return name.substr(0, begin) + number;
}

bool CellLog::take(std::span<const Measurement> rows, std::span<const Event> events) {
  pending_.rows.insert(pending_.rows.end(), rows.begin(), rows.end());
  bool is_new = false;
  for (const Event& event : events) {
    if (!tells_of_cells(event)) continue;
    is_new = true;
    pending_.events.push_back(event);
    if (begins_new_cell(event)) name_.clear();
    if (const auto name = named_cell(event)) name_ = last_name_ = *name;
  }
  return is_new;
}

void CellLog::begin_anew(long frame) {
  pending_.run_starts.push_back(frame);
}

std::vector<CellPassport> CellLog::evaluate(Pending pending) {
  // A note has the time at which it was written, an event of a frame the frame's.
  std::stable_sort(pending.events.begin(), pending.events.end(),
                   [](const Event& a, const Event& b) { return a.time_s < b.time_s; });
  PassportInput input;
  input.profile = pending.profile;
  input.rows = pending.rows;
  input.events = pending.events;
  input.run_starts = pending.run_starts;
  return cell_passports(input);
}

void CellLog::settle(std::vector<CellPassport> cells) {
  cells_.resize(settled_count_);
  // By their times: rows may have come since.
  const double settled_until_s = cells.size() > 1 ? cells[cells.size() - 2].named_until_s : -HUGE_VAL;
  for (CellPassport& cell : cells) {
    cell.cell = static_cast<int>(cells_.size()) + 1;
    for (ContactPassport& contact : cell.contact_list) contact.cell = cell.cell;
    cells_.push_back(std::move(cell));
  }
  if (cells.size() < 2) return;
  settled_count_ += cells.size() - 1;
  std::erase_if(pending_.rows, [&](const Measurement& row) { return row.time_s <= settled_until_s; });
  std::erase_if(pending_.events, [&](const Event& event) { return event.time_s <= settled_until_s; });
}

}  // namespace pellucida
