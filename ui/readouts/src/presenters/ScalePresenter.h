#pragma once
#include <string>
#include <vector>

#include "pellucida/core_vtk/Scene.h"
#include "pellucida/mechanics/ScaleMeasurement.h"
#include "pellucida/membrane/CellProfile.h"
#include "presenters/Phrase.h"

namespace pellucida {

/// What the gauge shows of the scale: the kind's spread, and this cell's place in it once it was measured.
struct ScaleTexts {
  Phrase text;  ///< "±46 %" of the kind, in grey; "±8 %" of this cell
  std::string tip;
  double kind_sigma = 0.0;  ///< of the logarithm
  double ratio = 1.0;       ///< this cell's stiffness over its kind's
  double sigma = 0.0;       ///< of its logarithm
  bool is_own = false;      ///< measured on this cell
};

/// `scene`: nullptr before the first measured one: the kind's.
ScaleTexts scale_texts(const Scene* scene, const CellProfile& profile);

/// One way of measuring a scale, as the dialog asks for it: keys of `ScaleMeasurement` with their labels, UTF-8.
struct ScaleForm {
  struct Row {
    std::string key;
    std::string label;
  };
  std::string title;
  std::string explanation;
  std::vector<Row> rows;
};
const std::vector<ScaleForm>& scale_forms();

/// What the picture knows already: the indentation in contact, the zona's thickness at rest. The rest keeps its
/// default.
ScaleMeasurement seen_for_scale(const Scene* scene);

}  // namespace pellucida
