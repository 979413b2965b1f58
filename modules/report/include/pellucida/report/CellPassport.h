#pragma once
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pellucida/core/Event.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/core/Measurement.h"
#include "pellucida/session/SessionCheck.h"
#include "pellucida/session/SessionReader.h"

namespace pellucida {

/// Rows of a session, as numbers from 0: `begin` up to, but without, `end`.
struct RowRange {
  std::size_t begin = 0;
  std::size_t end = 0;

  bool empty() const noexcept { return begin >= end; }
};

/// One contact of the needle with a cell: approach, touch, peak, and puncture or retraction. Every number is NaN where
/// it was not reached or not recorded, never 0 in its stead; `_lower_` and `_upper_` are the ends of the 95 % interval
/// of the number before them. Meaning and unit of each: `contact_fields`, printed in docs/file-format.md.
struct ContactPassport {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  int cell = 0;                       ///< from 1
  int contact = 0;                    ///< of this cell, from 1; 0 for a cell that was not touched
  std::string outcome = "untouched";  ///< `untouched`, `retracted`, `punctured`, `lost` or `unfinished`
  int frames = 0;
  int unmeasured_frames = 0;
  double confidence = kNone;
  double touch_s = kNone;
  double release_s = kNone;
  double dwell_s = kNone;
  double inside_s = kNone;
  double peak_force_uN = kNone, peak_force_lower_uN = kNone, peak_force_upper_uN = kNone;
  double peak_force_depth_um = kNone;
  double peak_force_s = kNone;
  double picture_sigma_percent = kNone, scale_sigma_percent = kNone;
  double largest_depth_um = kNone;
  double largest_pressure_Pa = kNone;
  double work_pJ = kNone, work_lower_pJ = kNone, work_upper_pJ = kNone;
  double puncture_s = kNone;
  double puncture_force_uN = kNone, puncture_force_lower_uN = kNone, puncture_force_upper_uN = kNone;
  double puncture_depth_um = kNone;
  double puncture_work_pJ = kNone, puncture_work_lower_pJ = kNone, puncture_work_upper_pJ = kNone;
  double drop_uN = kNone, drop_lower_uN = kNone, drop_upper_uN = kNone;
  double spring_back_um = kNone;
  double stiffness_5um_uN_per_um = kNone, stiffness_5um_lower_uN_per_um = kNone, stiffness_5um_upper_uN_per_um = kNone;
  double stiffness_10um_uN_per_um = kNone, stiffness_10um_lower_uN_per_um = kNone,
         stiffness_10um_upper_uN_per_um = kNone;
  double stiffness_20um_uN_per_um = kNone, stiffness_20um_lower_uN_per_um = kNone,
         stiffness_20um_upper_uN_per_um = kNone;
  double stiffness_30um_uN_per_um = kNone, stiffness_30um_lower_uN_per_um = kNone,
         stiffness_30um_upper_uN_per_um = kNone;
  double stiffness_40um_uN_per_um = kNone, stiffness_40um_lower_uN_per_um = kNone,
         stiffness_40um_upper_uN_per_um = kNone;
  double strain_stiffening = kNone, strain_stiffening_lower = kNone, strain_stiffening_upper = kNone;
  double hysteresis_pJ = kNone, hysteresis_lower_pJ = kNone, hysteresis_upper_pJ = kNone;
  double approach_speed_um_per_s = kNone;
  double insertion_speed_um_per_s = kNone;
  double removal_speed_um_per_s = kNone;
  double largest_area_strain_percent = kNone;
  double largest_mean_tension_uN_per_um = kNone;
  double largest_tension_uN_per_um = kNone;
  double deposit_s = kNone;
  double first_deposit_s = kNone;
  std::string doubts;     ///< `doubt_list` in one line
  std::string cell_name;  ///< as a note gives it (core/CellNameNote.h); empty without one

  std::vector<std::string> doubt_list;  ///< what speaks against these numbers, a sentence each
  RowRange rows;                        ///< from the touch to the last row before the release
  RowRange insertion;                   ///< the rows of it up to the largest depth, or to the puncture
};

/// How a contact ended, for people: "punctured", "retracted", "lost in contact", "still in contact", "not touched".
const char* outcome_words(const ContactPassport& contact) noexcept;

/// One cell of a session, from where it was found until it was lost for good, replaced, or the recording ended.
struct CellPassport {
  std::string session;  ///< name of the session's folder
  std::string profile;  ///< that the forces are for
  int cell = 0;         ///< from 1
  std::string name;     ///< as a note gives it (core/CellNameNote.h); empty without one
  double found_s = ContactPassport::kNone;
  double last_seen_s = ContactPassport::kNone;
  double named_until_s = ContactPassport::kNone;  ///< a name given later is the next cell's; >= last_seen_s
  double radius_um = ContactPassport::kNone;
  int losses = 0;
  int contacts = 0;
  std::string cell_doubts;  ///< `doubt_list` in one line

  std::vector<ContactPassport> contact_list;
  std::vector<std::string> doubt_list;  ///< what speaks against the cell as a whole
  std::vector<std::string> notes;       ///< the operator's words while it was there, with their times
  RowRange rows;

  /// The contact that a table of cells reports: the first with a puncture, else the one with the largest force; an
  /// empty one for a cell that was not touched.
  const ContactPassport& main_contact() const noexcept;
};

/// A member of a passport with its name for people; the ends of an interval have none, they stand with their number.
template <class S>
struct PassportField {
  Field<S> field;
  std::string_view label;
  std::string_view heading = {};  ///< of the group of numbers that begins with it, on the page
};
/// In the order of the columns of `cells.csv` (those of the cell, then those of its main contact but `cell`) and of
/// `contacts.csv`.
std::span<const PassportField<CellPassport>> cell_fields() noexcept;
std::span<const PassportField<ContactPassport>> contact_fields() noexcept;

/// What a surface says about the membrane in one frame; NaN where there is no surface, or no force on it.
struct MembraneState {
  double area_strain_percent = ContactPassport::kNone;  ///< of the outer membrane, against its sphere at rest
  double mean_tension_uN_per_um = ContactPassport::kNone;
  double largest_tension_uN_per_um = ContactPassport::kNone;
};

/// A stretch of time in which the hand deposited.
struct Deposit {
  double begin_s = 0.0;
  double end_s = 0.0;
};

/// What passports are made of. `rows` and `events` belong to somebody else, and must outlive this.
struct PassportInput {
  std::string session;
  std::string profile;
  std::span<const Measurement> rows;
  std::span<const Event> events;        ///< in the order of time
  std::vector<long> run_starts;         ///< frames at which the source began anew, ascending
  std::vector<MembraneState> membrane;  ///< one a row, or none at all
  bool is_hand_recorded = false;
  std::vector<Deposit> deposits;    ///< in the order of time
  std::vector<std::string> unread;  ///< what could not be read of the session, a sentence each
};

/// Reads all that a session holds of it. `progress` counts the surfaces read: those of frames in contact. A file that
/// can't be read is left out and named in `unread`. Throws InputError where `session.json` holds a wrong type.
PassportInput passport_input(const SessionReader& session, const SessionProgress& progress = {});

/// The cells of a session, in the order of time, each with its contacts.
///
/// A cell begins where one is first seen and ends with the recording, with a note that begins with `new cell`
/// (core/NewCellNote.h), where the source begins anew, or where it is lost for good: what is found again within 5 s at
/// most half a radius away, and of a size within 5 %, is the same cell. A contact goes from the first row in contact to
/// the next one that is free.
std::vector<CellPassport> cell_passports(const PassportInput& input);
std::vector<CellPassport> cell_passports(const SessionReader& session);

}  // namespace pellucida
