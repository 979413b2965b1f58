#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pellucida/report/CellPassport.h"

namespace pellucida {

/// `cells.csv`: a header, then a row for each cell with the numbers of its main contact; an empty cell means "not
/// reached" or "not recorded".
std::string cells_csv(std::span<const CellPassport> cells);
/// `contacts.csv`: a header, then a row for each contact of each cell.
std::string contacts_csv(std::span<const CellPassport> cells);

/// The dose passport of a session: one HTML page that needs nothing else (style and drawings inside, no script), light
/// or dark as the reader's system is, printed on A4. Text from the session is escaped. `cells` are those of `input`.
std::string passport_page(const SessionReader& session, const PassportInput& input,
                          std::span<const CellPassport> cells);

/// What a report wrote.
struct PassportReport {
  std::vector<CellPassport> cells;
  std::vector<std::filesystem::path> files;  ///< in the order they were written
  std::vector<std::string> notes;            ///< what speaks against the session as a whole
};

/// Where a report goes without a folder of its own: in the session's, where `pellucida check` leaves it alone.
inline constexpr const char* kReportFolder = "report";

/// The files that `write_report` writes: the page, then the tables.
std::vector<std::filesystem::path> report_names(const std::filesystem::path& session,
                                                const std::filesystem::path& output);

/// Writes `report.html`, `cells.csv` and `contacts.csv` into the folder `output`; where `output` ends in `.html`, the
/// page under that name and the tables beside it (`NAME_cells.csv`, `NAME_contacts.csv`); where it is empty, into
/// `SESSION/report`. Each file replaces an older one at once. The session's own files are not touched.
///
/// Throws InputError when the session can't be read; UsageError when `output` lies in the session (anywhere but in
/// `report`), or a file would replace one of the session's; OutputError when a file can't be written.
PassportReport write_report(const std::filesystem::path& session, const std::filesystem::path& output,
                            const SessionProgress& progress = {});

}  // namespace pellucida
