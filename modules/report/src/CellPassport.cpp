#include "pellucida/report/CellPassport.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "CellSpans.h"
#include "ContactNumbers.h"
#include "PassportDoubts.h"
#include "pellucida/core/CellNameNote.h"
#include "pellucida/core/NewCellNote.h"

namespace pellucida {
namespace {

// The cell's size from the rows in which nothing touches it; from all of them where there are none.
double rest_radius_um(const PassportInput& input, const RowRange& range) {
  for (const bool free_only : {true, false}) {
    std::vector<double> radii_um;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const double radius_um = radius_um_of(input.rows[i]);
      if ((!free_only || input.rows[i].state == CellState::kFree) && std::isfinite(radius_um)) {
        radii_um.push_back(radius_um);
      }
    }
    if (radii_um.empty()) continue;
    const auto middle = radii_um.begin() + static_cast<std::ptrdiff_t>(radii_um.size() / 2);
    std::nth_element(radii_um.begin(), middle, radii_um.end());
    return *middle;
  }
  return ContactPassport::kNone;
}

// Up to when a name is that of the cell in `spans[index]`: its last row, or the note after it that begins another cell
// where no row lies between; a camera that was slow does not hand a name on.
double named_until_s(const PassportInput& input, const std::vector<CellSpan>& spans, std::size_t index) {
  const RowRange& rows = spans[index].rows;
  const double last_s = input.rows[rows.end - 1].time_s;
  if (index + 1 == spans.size() || spans[index + 1].rows.begin != rows.end) return last_s;
  const double next_s = input.rows[rows.end].time_s;
  for (const Event& event : input.events) {
    if (event.time_s <= last_s || event.time_s > next_s || !begins_new_cell(event)) continue;
    return std::nextafter(event.time_s, last_s);
  }
  return last_s;
}

// A note names the cell that is there, or the next one that comes; the last note counts.
std::string name_of_cell(const PassportInput& input, const std::vector<CellSpan>& spans, std::size_t index) {
  constexpr double kEver = std::numeric_limits<double>::infinity();
  const double after_s = index > 0 ? named_until_s(input, spans, index - 1) : -kEver;
  const double until_s = index + 1 < spans.size() ? named_until_s(input, spans, index) : kEver;
  std::string name;
  for (const Event& event : input.events) {
    if (event.time_s <= after_s || event.time_s > until_s) continue;
    if (auto given = named_cell(event)) name = std::move(*given);
  }
  return name;
}

CellPassport passport_of(const PassportInput& input, const std::vector<CellSpan>& spans, std::size_t index) {
  const CellSpan& span = spans[index];
  const int number = static_cast<int>(index) + 1;
  CellPassport cell;
  cell.name = name_of_cell(input, spans, index);
  cell.session = input.session;
  cell.profile = input.profile;
  cell.cell = number;
  cell.rows = span.rows;
  cell.found_s = input.rows[span.rows.begin].time_s;
  cell.last_seen_s = input.rows[span.rows.end - 1].time_s;
  cell.named_until_s = named_until_s(input, spans, index);
  cell.radius_um = rest_radius_um(input, span.rows);
  cell.losses = span.losses;
  for (const ContactSpan& one : span.contacts) {
    ContactPassport contact = contact_numbers(input, span, one);
    contact.cell = number;
    contact.cell_name = cell.name;
    contact.contact = ++cell.contacts;
    contact.doubt_list = contact_doubts(input, one, contact);
    contact.doubts = in_one_line(contact.doubt_list);
    cell.contact_list.push_back(std::move(contact));
  }
  cell.doubt_list = cell_doubts(span, cell);
  cell.cell_doubts = in_one_line(cell.doubt_list);
  cell.notes = notes_between(input, cell.found_s, cell.last_seen_s);
  return cell;
}

}  // namespace

const char* outcome_words(const ContactPassport& contact) noexcept {
  if (contact.outcome == "punctured") return PELLUCIDA_WORDS("punctured");
  if (contact.outcome == "retracted") return PELLUCIDA_WORDS("retracted");
  if (contact.outcome == "lost") return PELLUCIDA_WORDS("lost in contact");
  if (contact.outcome == "unfinished") return PELLUCIDA_WORDS("still in contact");
  return PELLUCIDA_WORDS("not touched");
}

const ContactPassport& CellPassport::main_contact() const noexcept {
  static const ContactPassport kUntouched;
  if (contact_list.empty()) return kUntouched;
  const auto force_uN = [](const ContactPassport& contact) {
    return std::isnan(contact.peak_force_uN) ? -1.0 : contact.peak_force_uN;
  };
  // Of several punctures the first: the cell was whole before it.
  const auto punctured = std::find_if(contact_list.begin(), contact_list.end(),
                                      [](const auto& contact) { return contact.outcome == "punctured"; });
  if (punctured != contact_list.end()) return *punctured;
  return *std::max_element(contact_list.begin(), contact_list.end(),
                           [&](const auto& a, const auto& b) { return force_uN(a) < force_uN(b); });
}

std::vector<CellPassport> cell_passports(const PassportInput& input) {
  std::vector<CellPassport> cells;
  const std::vector<CellSpan> spans = find_cells(input);
  for (std::size_t k = 0; k < spans.size(); ++k) cells.push_back(passport_of(input, spans, k));
  return cells;
}

}  // namespace pellucida
