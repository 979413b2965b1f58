#include "presenters/CellTable.h"

#include <algorithm>
#include <cmath>

#include "pellucida/batch/RecordingList.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/OutputFile.h"
#include "pellucida/core/Table.h"
#include "pellucida/core/Words.h"
#include "pellucida/report/PassportReport.h"
#include "pellucida/session/SessionSource.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

enum FixedColumn : std::size_t { kGroup, kSession, kCellNumber, kOutcome, kFixedCount };
static_assert(kFixedCount == CellTable::kPeakForce);
constexpr const char* kFixedTitles[] = {PELLUCIDA_WORDS("Group"), PELLUCIDA_WORDS("Session"), PELLUCIDA_WORDS("Cell"),
                                        PELLUCIDA_WORDS("Outcome")};
constexpr const char* kOutcomes[] = {PELLUCIDA_WORDS("punctured"), PELLUCIDA_WORDS("retracted"),
                                     PELLUCIDA_WORDS("lost"), PELLUCIDA_WORDS("unfinished"),
                                     PELLUCIDA_WORDS("untouched")};

struct NumberColumn {
  const char* name;  // of the quantity, as in cells.csv
  const char* title;
  double ContactPassport::*value;
  int decimals;
};
using C = ContactPassport;
constexpr NumberColumn kNumbers[] = {
    {"peak_force_uN", PELLUCIDA_WORDS("Peak force (µN)"), &C::peak_force_uN, 2},
    {"peak_force_lower_uN", PELLUCIDA_WORDS("95 % from (µN)"), &C::peak_force_lower_uN, 2},
    {"peak_force_upper_uN", PELLUCIDA_WORDS("95 % to (µN)"), &C::peak_force_upper_uN, 2},
    {"peak_force_depth_um", PELLUCIDA_WORDS("Depth at peak (µm)"), &C::peak_force_depth_um, 1},
    {"puncture_force_uN", PELLUCIDA_WORDS("Puncture force (µN)"), &C::puncture_force_uN, 2},
    {"puncture_depth_um", PELLUCIDA_WORDS("Puncture depth (µm)"), &C::puncture_depth_um, 1},
    {"puncture_work_pJ", PELLUCIDA_WORDS("Puncture work (pJ)"), &C::puncture_work_pJ, 1},
    {"work_pJ", PELLUCIDA_WORDS("Work to the largest depth (pJ)"), &C::work_pJ, 1},
    {"stiffness_10um_uN_per_um", PELLUCIDA_WORDS("Stiffness at 10 µm (µN/µm)"), &C::stiffness_10um_uN_per_um, 3},
    {"stiffness_20um_uN_per_um", PELLUCIDA_WORDS("Stiffness at 20 µm (µN/µm)"), &C::stiffness_20um_uN_per_um, 3},
    {"stiffness_30um_uN_per_um", PELLUCIDA_WORDS("Stiffness at 30 µm (µN/µm)"), &C::stiffness_30um_uN_per_um, 3},
    {"hysteresis_pJ", PELLUCIDA_WORDS("Hysteresis (pJ)"), &C::hysteresis_pJ, 1},
    {"dwell_s", PELLUCIDA_WORDS("Time in contact (s)"), &C::dwell_s, 2},
    {"confidence", PELLUCIDA_WORDS("Confidence"), &C::confidence, 2},
};

std::string outcome_words(const std::string& outcome) {
  const auto found = std::find(std::begin(kOutcomes), std::end(kOutcomes), outcome);
  return found == std::end(kOutcomes) ? outcome : say(*found);
}

std::filesystem::path same_place(const std::filesystem::path& folder) {
  std::error_code ignored;
  const auto place = std::filesystem::weakly_canonical(folder, ignored);
  return ignored ? folder : place;
}

}  // namespace

std::vector<GroupedSession> sessions_in(const std::filesystem::path& folder) {
  std::vector<GroupedSession> sessions;
  for (const Recording& recording : find_recordings({folder.string()}, {}).recordings) {
    if (is_session(recording.input)) sessions.push_back({recording.input, recording.group});
  }
  if (sessions.empty()) {
    throw InputError(folder.string() + ": no session found; choose a session, or a folder that holds some");
  }
  return sessions;
}

std::vector<SessionCell> cells_of(const GroupedSession& session, const SessionProgress& progress) {
  const SessionReader reader(session.folder);
  std::vector<SessionCell> cells;
  for (CellPassport& passport : cell_passports(passport_input(reader, progress))) {
    cells.push_back({session, std::move(passport)});
  }
  return cells;
}

std::size_t CellTable::column_count() noexcept {
  return kFixedCount + std::size(kNumbers);
}

std::string CellTable::column_title(std::size_t column) {
  return say(column < kFixedCount ? kFixedTitles[column] : kNumbers[column - kFixedCount].title);
}

bool CellTable::is_quantity(std::size_t column) noexcept {
  return column >= kFixedCount && column < column_count();
}

void CellTable::add(const std::vector<SessionCell>& cells) {
  for (const SessionCell& cell : cells) {
    const auto place = same_place(cell.session.folder);
    const auto same = std::find_if(rows_.begin(), rows_.end(), [&](const SessionCell& row) {
      return row.passport.cell == cell.passport.cell && same_place(row.session.folder) == place;
    });
    if (same == rows_.end()) {
      rows_.push_back(cell);
    } else {
      *same = cell;
    }
  }
}

void CellTable::remove(std::size_t row) {
  if (row < rows_.size()) rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(row));
}

CellTable::Entry CellTable::entry(std::size_t row, std::size_t column) const {
  const SessionCell& cell = rows_.at(row);
  const ContactPassport& contact = cell.passport.main_contact();
  switch (column) {
    case kGroup:
      return {cell.session.group, kNone};
    case kSession:
      return {cell.passport.session, kNone};
    case kCellNumber:
      return {std::to_string(cell.passport.cell), static_cast<double>(cell.passport.cell)};
    case kOutcome:
      return {outcome_words(contact.outcome), kNone};
    default:
      break;
  }
  const NumberColumn& number = kNumbers[column - kFixedCount];
  const double value = contact.*number.value;
  return {readout::number(value, number.decimals), value};
}

std::vector<GroupRow> CellTable::groups(std::size_t column) const {
  if (!is_quantity(column)) return {};
  const NumberColumn& number = kNumbers[column - kFixedCount];
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;
  for (const SessionCell& row : rows_) {
    auto place = std::find(names.begin(), names.end(), row.session.group);
    if (place == names.end()) {
      names.push_back(row.session.group);
      values.emplace_back();
      place = names.end() - 1;
    }
    const double value = row.passport.main_contact().*number.value;
    if (!std::isnan(value)) values[static_cast<std::size_t>(place - names.begin())].push_back(value);
  }
  return compare_groups(number.name, names, std::move(values));
}

void CellTable::write(const std::filesystem::path& file) const {
  OutputFile output(file);
  for (const SessionCell& row : rows_) {
    const std::string text = cells_csv({&row.passport, 1});
    const std::size_t end_of_header = text.find('\n');
    if (&row == &rows_.front()) output.add("group," + text.substr(0, end_of_header));
    output.write(csv_cell(row.session.group) + ',' + text.substr(end_of_header + 1));
  }
  if (rows_.empty()) output.add("group," + cells_csv({}).substr(0, cells_csv({}).find('\n')));
  output.finish();
}

std::string group_words(const GroupRow& group) {
  if (group.count == 0) return say("no number");
  const auto number = [](double value) { return readout::plain(std::round(value * 1e3) / 1e3); };
  return number(group.median) + " (" + number(group.lower_quartile) + say(" to ") + number(group.upper_quartile) +
         "), " + std::to_string(group.count) + (group.count == 1 ? say(" cell") : say(" cells"));
}

}  // namespace pellucida
