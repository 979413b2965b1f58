#include "pellucida/mechanics/ScaleMeasurement.h"

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"

namespace pellucida {
namespace {

using S = ScaleMeasurement;
/// Of an unknown that is known exactly.
constexpr double kLeastVariance = 1e-12;
constexpr FieldRange kGiven{0, 1e6}, kPercent = above(0, 100), kSigma_um{0, 1e3};
constexpr Field<S> kScaleFields[] = {
    {"known_force_uN", "uN", &S::known_force_uN, kGiven,
     "force measured independently in a small push, which scales all forces to this cell"},
    {"known_stiffness_uN_per_um", "uN/um", &S::known_stiffness_uN_per_um, kGiven,
     "instead of a force: the stiffness measured independently"},
    {"fibre_stiffness_uN_per_um", "uN/um", &S::fibre_stiffness_uN_per_um, kGiven,
     "stiffness of a bending microfibre or calibrated pipette that pushes the cell (1 uN/um = 1 N/m)"},
    {"fibre_deflection_um", "um", &S::fibre_deflection_um, kGiven, "its deflection in that push"},
    {"fibre_deflection_sigma_um", "um", &S::fibre_deflection_sigma_um, kSigma_um, "standard deviation of that"},
    {"at_indentation_um", "um", &S::at_indentation_um, kGiven, "the cell's indentation in that push"},
    {"at_indentation_sigma_um", "um", &S::at_indentation_sigma_um, kSigma_um, "standard deviation of that"},
    {"known_force_sigma_percent", "%", &S::known_force_sigma_percent, kPercent,
     "standard deviation of the known force, or of a stiffness, the fibre's too"},
    {"suction_kPa", "kPa", &S::suction_kPa, kGiven, "suction in the holding pipette, below the medium's pressure"},
    {"suction_sigma_percent", "%", &S::suction_sigma_percent, kPercent, "standard deviation of that"},
    {"tongue_um", "um", &S::tongue_um, kGiven,
     "how far the zona's tongue reaches into the pipette, from the plane of its mouth to the apex"},
    {"tongue_sigma_um", "um", &S::tongue_sigma_um, kSigma_um, "standard deviation of that"},
    {"mouth_radius_um", "um", &S::mouth_radius_um, kGiven, "inner radius of the pipette's mouth"},
    {"mouth_radius_sigma_um", "um", &S::mouth_radius_sigma_um, kSigma_um, "standard deviation of that"},
    {"zona_thickness_um", "um", &S::zona_thickness_um, kGiven, "the zona's thickness; 0: the profile's, known to 25 %"},
    {"zona_thickness_sigma_um", "um", &S::zona_thickness_sigma_um, kSigma_um, "standard deviation of that, if given"},
    {"modulus_kPa", "kPa", &S::modulus_kPa, {0, 1e7}, "Young's modulus that the aspiration gives, by finite elements"},
    {"modulus_sigma_percent", "%", &S::modulus_sigma_percent, {0, 1e3}, "standard deviation of that"},
    {"modulus_of_profile_ratio",
     "",
     &S::modulus_of_profile_ratio,
     {0, 1e3},
     "modulus of a solid zona that passes the profile's puncture point, over the profile's effective modulus"},
    {"since_s", "s", &S::since_s, {0, 1e9}, "session time from which on the measurement counts; 0: from the beginning"},
};

template <class... Numbers>
std::string text_of(const char* pattern, Numbers... numbers) {
  char text[192];
  std::snprintf(text, sizeof text, pattern, numbers...);
  return text;
}

void require(bool holds, const char* text) {
  if (!holds) throw UsageError(std::string("scale of the cell: ") + text);
}

}  // namespace

std::string to_string(ScaleWay way) {
  switch (way) {
    case ScaleWay::kForce:
      return "force";
    case ScaleWay::kStiffness:
      return "stiffness";
    case ScaleWay::kFibre:
      return "fibre";
    case ScaleWay::kAspiration:
      return "aspiration";
  }
  return "unknown";
}

FieldList fields_of(ScaleMeasurement& measurement) {
  return FieldList().add("", kScaleFields, measurement);
}

std::vector<ScaleMeasurement> separated(const ScaleMeasurement& given) {
  ScaleMeasurement copy = given;
  for (const FieldPlace& field : fields_of(copy)) {
    const double value = *std::get<double*>(field.value);
    if (!field.range.holds(value))
      throw UsageError("scale of the cell: " + field.key + ": allowed: " + to_string(field.range));
  }
  const bool force = given.known_force_uN > 0.0, stiffness = given.known_stiffness_uN_per_um > 0.0;
  const bool fibre = given.fibre_stiffness_uN_per_um > 0.0 || given.fibre_deflection_um > 0.0;
  const bool aspiration = given.suction_kPa > 0.0 || given.tongue_um > 0.0 || given.mouth_radius_um > 0.0;
  require(force + stiffness + fibre <= 1,
          "give one of known force, known stiffness and fibre for the push at that indentation");
  require((force || stiffness || fibre) == (given.at_indentation_um > 0.0),
          "a push needs its indentation, and a known force, a known stiffness, or a fibre's stiffness and deflection");
  require(!fibre || (given.fibre_stiffness_uN_per_um > 0.0 && given.fibre_deflection_um > 0.0),
          "a fibre needs its stiffness and its deflection");
  require(!aspiration || (given.suction_kPa > 0.0 && given.tongue_um > 0.0 && given.mouth_radius_um > 0.0),
          "an aspiration needs the suction, the tongue's length and the radius of the pipette's mouth");
  std::vector<ScaleMeasurement> all;
  const ScaleMeasurement none;
  if (force || stiffness || fibre) {
    all.push_back(given);
    ScaleMeasurement& push = all.back();
    push.suction_kPa = push.tongue_um = push.mouth_radius_um = push.zona_thickness_um = 0.0;
    push.suction_sigma_percent = none.suction_sigma_percent;
    push.tongue_sigma_um = none.tongue_sigma_um;
    push.mouth_radius_sigma_um = none.mouth_radius_sigma_um;
    push.zona_thickness_sigma_um = none.zona_thickness_sigma_um;
    push.modulus_kPa = push.modulus_sigma_percent = push.modulus_of_profile_ratio = 0.0;
  }
  if (aspiration) {
    all.push_back(given);
    ScaleMeasurement& drawn = all.back();
    drawn.known_force_uN = drawn.known_stiffness_uN_per_um = drawn.fibre_stiffness_uN_per_um = 0.0;
    drawn.fibre_deflection_um = drawn.at_indentation_um = 0.0;
    drawn.known_force_sigma_percent = none.known_force_sigma_percent;
    drawn.fibre_deflection_sigma_um = none.fibre_deflection_sigma_um;
    drawn.at_indentation_sigma_um = none.at_indentation_sigma_um;
  }
  return all;
}

ScaleWay way_of(const ScaleMeasurement& measurement) {
  require(separated(measurement).size() == 1, "give one measurement: a push or an aspiration");
  if (measurement.known_force_uN > 0.0) return ScaleWay::kForce;
  if (measurement.known_stiffness_uN_per_um > 0.0) return ScaleWay::kStiffness;
  return measurement.suction_kPa > 0.0 ? ScaleWay::kAspiration : ScaleWay::kFibre;
}

Palpation push_of(const ScaleMeasurement& m) {
  const ScaleWay way = way_of(m);
  require(way != ScaleWay::kAspiration, "an aspiration is no push");
  Palpation push;
  push.indentation_um = m.at_indentation_um;
  push.indentation_sigma_um = m.at_indentation_sigma_um;
  push.relative_sigma = 0.01 * m.known_force_sigma_percent;
  if (way == ScaleWay::kStiffness) {
    push.known_stiffness_uN_per_um = m.known_stiffness_uN_per_um;
  } else if (way == ScaleWay::kForce) {
    push.known_force_uN = m.known_force_uN;
  } else {
    push.known_force_uN = m.fibre_stiffness_uN_per_um * m.fibre_deflection_um;
    push.relative_sigma = std::hypot(push.relative_sigma, m.fibre_deflection_sigma_um / m.fibre_deflection_um);
  }
  return push;
}

std::string describe(const ScaleMeasurement& m) {
  const ScaleWay way = way_of(m);
  if (way == ScaleWay::kAspiration) {
    std::string text = text_of("a tongue of %.1f um under %.3g kPa in a mouth of %.1f um", m.tongue_um, m.suction_kPa,
                               m.mouth_radius_um);
    if (m.modulus_kPa > 0.0) text += text_of(": %.3g kPa, +- %.0f %%", m.modulus_kPa, m.modulus_sigma_percent);
    return text;
  }
  const Palpation push = push_of(m);
  const double percent = 100.0 * push.relative_sigma;
  if (way == ScaleWay::kStiffness) {
    return text_of("a stiffness of %.3g uN/um at %.1f um, +- %.0f %%", push.known_stiffness_uN_per_um,
                   push.indentation_um, percent);
  }
  return (way == ScaleWay::kFibre ? text_of("a fibre bent by %.1f um: ", m.fibre_deflection_um) : std::string()) +
         text_of("a push of %.3g uN at %.1f um, +- %.0f %%", push.known_force_uN, push.indentation_um, percent);
}

ScaleEstimate::ScaleEstimate(const CellScale& before, double geometry_sigma, double model_sigma) {
  const auto information = [](double sigma) { return 1.0 / std::max(sigma * sigma, kLeastVariance); };
  const double s = information(before.relative_sigma);
  // Rows of the lower triangle: ss, gs gg, ms mg mm.
  information_[0] = s;
  information_[1] = information_[3] = information_[4] = 0.0;
  information_[2] = information(geometry_sigma);
  information_[5] = information(model_sigma);
  vector_[0] = s * std::log(before.ratio);
  vector_[1] = vector_[2] = 0.0;
}

void ScaleEstimate::add_push(double ratio, double variance) {
  for (double& entry : information_) entry += 1.0 / variance;
  for (double& entry : vector_) entry += std::log(ratio) / variance;
  has_push_ = true;
}

void ScaleEstimate::add_modulus(double ratio, double variance) {
  information_[0] += 1.0 / variance;
  vector_[0] += std::log(ratio) / variance;
}

CellScale ScaleEstimate::result() const {
  Eigen::Matrix3d information;
  information << information_[0], information_[1], information_[3],  //
      information_[1], information_[2], information_[4],             //
      information_[3], information_[4], information_[5];
  const Eigen::Matrix3d covariance = information.inverse();
  const Eigen::Vector3d mean = covariance * Eigen::Vector3d(vector_[0], vector_[1], vector_[2]);
  const Eigen::Vector3d wanted(1.0, has_push_ ? 1.0 : 0.0, 0.0);
  return {std::exp(wanted.dot(mean)), std::sqrt(wanted.dot(covariance * wanted)), has_push_};
}

}  // namespace pellucida
