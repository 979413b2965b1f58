#include "pellucida/mechanics/ForceEstimate.h"

#include "pellucida/core/Words.h"

namespace pellucida {
namespace {

void append(std::string& text, const char* separator, const std::string& part) {
  text += text.empty() ? "" : separator;
  text += part;
}

}  // namespace

std::string to_string(ForceWarning warnings) {
  std::string text;
  if (warnings & kShapeMismatch) append(text, "+", PELLUCIDA_WORDS("mismatch"));
  if (warnings & kNeedleSlip) append(text, "+", PELLUCIDA_WORDS("slip"));
  if (warnings & kNotOfRevolution) append(text, "+", PELLUCIDA_WORDS("asymmetry"));
  if (warnings & kSeldomBorne) append(text, "+", PELLUCIDA_WORDS("profile"));
  return text;
}

std::string describe(ForceWarning warnings, std::string_view profile_name) {
  std::string text;
  if (warnings & kSeldomBorne) {
    append(text, "; ",
           "few cells of profile " + std::string(profile_name) +
               " bear this force: check that the profile is this cell's");
  }
  if (warnings & kShapeMismatch) append(text, "; ", "the contour does not match the model's");
  if (warnings & kNeedleSlip) append(text, "; ", "the needle has slipped, or the membrane does not follow its tip");
  if (warnings & kNotOfRevolution) append(text, "; ", "the dimple is more lopsided than the model explains");
  return text;
}

}  // namespace pellucida
