#include "pellucida/mechanics/ForceEstimate.h"

namespace pellucida {

std::string to_string(ForceWarning warnings) {
  std::string text;
  const auto add = [&](ForceWarning one, const char* name) {
    if (!(warnings & one)) return;
    text += text.empty() ? "" : "+";
    text += name;
  };
  add(kShapeMismatch, "mismatch");
  add(kNeedleSlip, "slip");
  add(kNotOfRevolution, "asymmetry");
  return text;
}

}  // namespace pellucida
