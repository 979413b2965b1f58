#pragma once
#include <Eigen/Core>
#include <memory>
#include <optional>

#include "pellucida/membrane/CellProfile.h"
#include "pellucida/membrane/Indenter.h"
#include "pellucida/membrane/MembraneGeometry.h"

namespace pellucida {

/// The equilibria of one cell under one needle, as a curve in the needle's depth: solved once, `kStep_um` apart, on a
/// thread of its own that runs ahead of the needle, and read in between by cubic Hermite interpolation (the solver
/// gives each equilibrium with its exact derivative by depth). Each is solved from the one before it, beginning at
/// rest, so what is read doesn't depend on the thread's pace: the same bits every time.
///
/// One thread at a time reads; allocates and waits, so not for the 1 kHz thread.
class EquilibriumPath {
 public:
  /// Distance of the solved depths.
  static constexpr double kStep_um = 1.0;
  /// How far the thread runs ahead of what was asked for.
  static constexpr double kAhead_um = 6.0;

  /// A cell of the profile's kind and of `geometry`, pushed and held as given (unit, frame C). Begins to solve at once.
  EquilibriumPath(const CellProfile& kind, const MembraneGeometry& geometry, const Eigen::Vector3d& push,
                  const Eigen::Vector3d& holder);
  ~EquilibriumPath();
  EquilibriumPath(const EquilibriumPath&) = delete;
  EquilibriumPath& operator=(const EquilibriumPath&) = delete;

  /// The equilibrium with the needle `depth_um` (>= 0) deep, for a model of the same mesh, setup and constants
  /// (`Indenter::adopt`); its report counts no iterations. Waits until the thread has been there. Nothing where an
  /// equilibrium on the way was not found.
  std::optional<SolvedShape> at(double depth_um);

  /// Where the path ends: the deepest equilibrium there is, its report saying why none was found farther on; nothing
  /// while it goes on.
  std::optional<SolvedShape> end() const;

  /// The deepest equilibrium that can be read without waiting, um.
  double solved_to_um() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
