#pragma once
#include "CellSpans.h"

namespace pellucida {

/// What speaks against the numbers of a contact, a sentence each: warnings, frames that were not measured or without a
/// force, low confidence, wide intervals, a touch or a release that nobody saw.
std::vector<std::string> contact_doubts(const PassportInput& input, const ContactSpan& span,
                                        const ContactPassport& contact);

/// What speaks against a cell as a whole: lost in between, another one lost before, several punctures.
std::vector<std::string> cell_doubts(const CellSpan& span, const CellPassport& cell);

/// The operator's notes from `begin_s` to `end_s`, each with its time.
std::vector<std::string> notes_between(const PassportInput& input, double begin_s, double end_s);

/// What speaks against a whole session: cut off, changed, partly unreadable.
std::vector<std::string> session_doubts(const SessionReader& session, const PassportInput& input);

/// The sentences in one line.
std::string in_one_line(const std::vector<std::string>& sentences);

}  // namespace pellucida
