#pragma once
#include <optional>
#include <string_view>

#include "pellucida/simulation/CellReference.h"

namespace pellucida {

/// The section's shape by depth and by the needle's offset from the cell's centre, in the frame and size of
/// CellReference. At the configuration's own offset it is the reference itself. Elsewhere the reference's
/// displacements, as they are, belong to the material about the place where the needle touches; beside a holder
/// opposite the needle they are blended between the needle through the centre and 10 um beside it.
class SectionField {
 public:
  /// Throws as CellReference::load.
  SectionField(std::string_view cell, int configuration);

  CellReference::Section at(double offset_um, double indentation_um) const;
  /// Rest angle of the material under the needle: what the points' angles are to be shifted to.
  double apex_angle_rad(double offset_um) const noexcept;
  const CellReference& reference() const noexcept { return reference_; }

 private:
  CellReference reference_;
  std::optional<CellReference> other_;  // of configurations 1 and 4 the other one
};

}  // namespace pellucida
