#pragma once
#include "pellucida/report/CellPassport.h"

class vtkPolyData;

namespace pellucida {

/// The strain of the outer membrane on one surface, and its tension where the surface carries one. The strain is its
/// area against that of the same mesh on the sphere at rest (points less `displacement_um`); the mean tension is
/// weighted by area. Everything NaN for a surface without cells of the outer membrane or without displacements.
MembraneState membrane_state(vtkPolyData* surface);

/// One entry a row: of the rows in contact that have a surface. A surface that can't be read is left out and counted in
/// `unread`, a sentence for all of them.
std::vector<MembraneState> membrane_history(const SessionReader& session, const SessionProgress& progress,
                                            std::vector<std::string>& unread);

}  // namespace pellucida
