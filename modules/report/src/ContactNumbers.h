#pragma once
#include <array>

#include "CellSpans.h"

namespace pellucida {

/// Depths at which the stiffness is given, um.
inline constexpr std::array kStiffnessDepths_um{5, 10, 20, 30, 40};

/// The numbers of one contact; `cell` and `contact` are left to the caller, and so are the doubts.
///
/// Force over depth is taken from the rows in contact that have both. The interval of a work is that of the integrals
/// of the lower and of the upper ends of the force's interval (their errors are common to all rows of a contact),
/// widened by the noise from row to row; that of a stiffness likewise, widened by the regression's own.
ContactPassport contact_numbers(const PassportInput& input, const CellSpan& cell, const ContactSpan& span);

}  // namespace pellucida
