#pragma once
#include <vector>

#include "pellucida/report/CellPassport.h"

namespace pellucida {

/// How a contact ended.
enum class ContactEnd { kReleased, kLost, kRecordingEnded };

/// The rows of a contact: those in contact or punctured, and what lies between them.
struct ContactSpan {
  RowRange rows;
  ContactEnd end = ContactEnd::kRecordingEnded;
  bool is_touch_seen = false;  ///< the cell was seen free before
  double release_s = ContactPassport::kNone;
};

/// The rows of a cell, with its contacts.
struct CellSpan {
  RowRange rows;
  int losses = 0;
  double lost_s = 0.0;  ///< for how long in all
  double away_s = 0.0;  ///< how long no cell had been seen before, where another one had been lost; else 0
  std::vector<ContactSpan> contacts;
};

/// A session's rows by cell and contact; the rules are those of `cell_passports`.
std::vector<CellSpan> find_cells(const PassportInput& input);

/// Radius of a sphere of the volume enclosed by the outer membrane; NaN where it was not measured.
double radius_um_of(const Measurement& row) noexcept;

/// Whether a row is in contact, or through the membrane.
bool is_touching(const Measurement& row) noexcept;

}  // namespace pellucida
