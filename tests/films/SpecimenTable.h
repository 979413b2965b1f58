#pragma once
#include <vector>

#include "films/FilmRun.h"

namespace pellucida::test {

/// Prints what the films of specimens say of the force, together and by what the specimens are: sizes, shape, how they
/// are held, how deep they are pushed.
void print_by_specimen(const std::vector<FilmRun>& runs);

}  // namespace pellucida::test
