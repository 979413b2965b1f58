#pragma once
#include <string>
#include <vector>

#include "pellucida/session/SessionReader.h"

namespace pellucida {

/// Which clock each stream of a session is stamped on, and how those clocks run against each other, in one line.
std::string clock_words(const SessionReader& session);

/// Frames that are not whole, in one line: lost by the source, damaged, without image or surface, not measured; with
/// how many of each. "none" where all are.
std::string incomplete_frame_words(const SessionReader& session);

/// What of that speaks against the numbers of the session, a sentence each.
std::vector<std::string> frame_doubts(const SessionReader& session);

}  // namespace pellucida
