#include "pellucida/identification/RelaxationFit.h"

#include <ceres/dynamic_numeric_diff_cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "pellucida/core/Error.h"
#include "pellucida/membrane/Indenter.h"

namespace pellucida {
namespace {

/// Force above the baseline, in its standard deviations, that is taken for contact at first.
constexpr double kContactSigmas = 8.0;

/// The elastic curve under a ramp is straight over this, um.
constexpr double kCurveStep_um = 1.0;

/// Parameters: contact height, a1 a2 a3 over the force's peak, then for each arm the log of its fraction over the
/// spring's, and the log of its time. The spring's fraction is 1 / (1 + sum of exp), so that all stay positive.
constexpr int kFixed = 4;

struct Unpacked {
  double contact_height_um = 0.0;
  Eigen::Vector3d elastic_uN;
  std::vector<RelaxationArm> arms;
};

Unpacked unpack(const double* p, int arm_count, double peak_uN) {
  Unpacked model;
  model.contact_height_um = p[0];
  model.elastic_uN = peak_uN * Eigen::Vector3d(p[1], p[2], p[3]);
  double sum = 1.0;
  for (int k = 0; k < arm_count; ++k) sum += std::exp(p[kFixed + 2 * k]);
  for (int k = 0; k < arm_count; ++k) {
    model.arms.push_back({std::exp(p[kFixed + 2 * k]) / sum, std::exp(p[kFixed + 2 * k + 1])});
  }
  return model;
}

/// The force at the record's samples from the ramp on.
void predict(const RelaxationRecord& record, const Unpacked& model, Eigen::VectorXd& force_uN) {
  const double depth_range_um = model.contact_height_um - record.height_um.minCoeff();
  Relaxation relaxation(model.arms);
  relaxation.start(record.time_s[0], 0.0);
  force_uN.resize(record.time_s.size());
  for (Eigen::Index k = 0; k < record.time_s.size(); ++k) {
    const bool pressed = k >= record.ramp_begin && record.height_um[k] < model.contact_height_um;
    const double u = pressed ? (model.contact_height_um - record.height_um[k]) / depth_range_um : 0.0;
    const double elastic_uN = u * (model.elastic_uN[0] + u * (model.elastic_uN[1] + u * model.elastic_uN[2]));
    force_uN[k] = relaxation.advance(record.time_s[k], elastic_uN);
  }
}

class Residuals {
 public:
  Residuals(const RelaxationRecord& record, int arm_count, double peak_uN)
      : record_(record), arm_count_(arm_count), peak_uN_(peak_uN) {}

  bool operator()(double const* const* parameters, double* residuals) const {
    const Unpacked model = unpack(parameters[0], arm_count_, peak_uN_);
    const bool usable = std::all_of(model.arms.begin(), model.arms.end(), [](const RelaxationArm& arm) {
      return arm.fraction > 0.0 && arm.time_s > 0.0 && std::isfinite(arm.time_s);
    });
    if (!usable || !(model.contact_height_um > record_.height_um.minCoeff())) return false;
    Eigen::VectorXd force_uN;
    predict(record_, model, force_uN);
    const Eigen::Index count = record_.time_s.size(), ramp = record_.hold_begin - record_.ramp_begin,
                       hold = count - record_.hold_begin;
    Eigen::Map<Eigen::VectorXd> r(residuals, ramp + hold);
    r = (force_uN - record_.force_uN).tail(ramp + hold) / peak_uN_;
    r.head(ramp) /= std::sqrt(static_cast<double>(ramp));
    r.tail(hold) /= std::sqrt(static_cast<double>(hold));
    return r.allFinite();
  }

 private:
  const RelaxationRecord& record_;
  int arm_count_;
  double peak_uN_;
};

double rms(const Eigen::VectorXd& values) {
  return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

}  // namespace

RelaxationFit fit_relaxation(const RelaxationRecord& record, int arm_count) {
  if (arm_count < 1 || arm_count > 3) throw UsageError("relaxation: give 1, 2 or 3 arms");
  const double peak_uN = record.force_uN.maxCoeff();
  const double noise_uN = std::max(record.baseline_sigma_uN, 1e-12);
  if (!(peak_uN > 2.0 * kContactSigmas * noise_uN)) {
    throw NothingMeasuredError("relaxation: the force never rises above the noise before the ramp");
  }

  // A first contact point: the last ramp sample that isn't above the noise.
  Eigen::Index contact = record.hold_begin - 1;
  while (contact > record.ramp_begin && record.force_uN[contact] > kContactSigmas * noise_uN) --contact;
  const double lowest_um = record.height_um.minCoeff();
  const double contact_um = record.height_um[contact];
  if (!(contact_um - lowest_um > 0.05 * (record.height_um.maxCoeff() - lowest_um))) {
    throw NothingMeasuredError("relaxation: the height doesn't fall in the ramp");
  }
  const double hold_s = record.time_s[record.time_s.size() - 1] - record.time_s[record.hold_begin];

  RelaxationFit best;
  double least_cost = std::numeric_limits<double>::infinity();
  const Eigen::Index used = record.time_s.size() - record.ramp_begin;
  for (const double quickest_share : {0.01, 0.04}) {
    Eigen::VectorXd p(kFixed + 2 * arm_count);
    p.head<kFixed>() << contact_um, 0.5, 0.5, 0.5;
    for (int k = 0; k < arm_count; ++k) {
      p[kFixed + 2 * k] = 0.0;
      p[kFixed + 2 * k + 1] = std::log(hold_s * quickest_share * std::pow(6.0, k));
    }
    auto* cost =
        new ceres::DynamicNumericDiffCostFunction<Residuals, ceres::CENTRAL>(new Residuals(record, arm_count, peak_uN));
    cost->AddParameterBlock(static_cast<int>(p.size()));
    cost->SetNumResiduals(static_cast<int>(used));
    ceres::Problem problem;
    problem.AddResidualBlock(cost, nullptr, p.data());
    // The contact lies in the ramp; times between a sample and many holds.
    problem.SetParameterLowerBound(p.data(), 0, lowest_um + 1e-3 * (contact_um - lowest_um));
    problem.SetParameterUpperBound(p.data(), 0, record.height_um[record.ramp_begin]);
    for (int k = 0; k < arm_count; ++k) {
      problem.SetParameterLowerBound(p.data(), kFixed + 2 * k, -12.0);
      problem.SetParameterUpperBound(p.data(), kFixed + 2 * k, 12.0);
      problem.SetParameterLowerBound(p.data(), kFixed + 2 * k + 1, std::log(1e-4 * hold_s));
      problem.SetParameterUpperBound(p.data(), kFixed + 2 * k + 1, std::log(30.0 * hold_s));
    }
    ceres::Solver::Options solver;
    solver.linear_solver_type = ceres::DENSE_QR;
    solver.max_num_iterations = 200;
    solver.function_tolerance = 1e-9;
    solver.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    if (!summary.IsSolutionUsable() || !(summary.final_cost < least_cost)) continue;
    least_cost = summary.final_cost;
    const Unpacked model = unpack(p.data(), arm_count, peak_uN);
    best.arms = model.arms;
    best.contact_height_um = model.contact_height_um;
    best.elastic_uN = model.elastic_uN;
    predict(record, model, best.force_uN);
  }
  if (!std::isfinite(least_cost)) throw NothingMeasuredError("relaxation: no arms describe this record");

  std::sort(best.arms.begin(), best.arms.end(), [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
  const Eigen::VectorXd off = record.force_uN - best.force_uN;
  best.hold_rms_uN = rms(off.tail(off.size() - record.hold_begin));
  best.ramp_rms_uN = rms(off.segment(record.ramp_begin, record.hold_begin - record.ramp_begin));
  best.ramp_and_hold_rms_uN = rms(off.tail(used));
  return best;
}

double ramp_speed_um_per_s(const RelaxationRecord& record) {
  const double way_um = record.height_um[record.ramp_begin] - record.height_um[record.hold_begin];
  return way_um / (record.time_s[record.hold_begin] - record.time_s[record.ramp_begin]);
}

void apply_relaxation(const std::vector<RelaxationArm>& arms, double anchor_ramp_s, CellProfile& profile) {
  if (!(anchor_ramp_s >= 0.0 && std::isfinite(anchor_ramp_s))) {
    throw UsageError("relaxation: the time of the measured push must be 0 s or above");
  }
  Relaxation relaxation(arms);
  double ratio = 1.0;
  if (!arms.empty() && anchor_ramp_s > 0.0) {
    relaxation.start(0.0);
    double elastic_uN = 0.0;
    for (const IndentationState& state : force_curve(profile, 1, profile.puncture_indentation_um, kCurveStep_um)) {
      if (state.report.status != SolveStatus::kConverged) {
        throw UsageError("relaxation: the model finds no equilibrium at the puncture indentation");
      }
      elastic_uN = state.push_force_uN;
      relaxation.advance(anchor_ramp_s * state.depth_um / profile.puncture_indentation_um, elastic_uN);
    }
    ratio = elastic_uN / relaxation.force_uN();
  }
  profile.relaxation_arms = arms;
  profile.relaxation_elastic_ratio = ratio;
  profile.relaxation_anchor_ramp_s = arms.empty() ? 0.0 : anchor_ramp_s;
}

}  // namespace pellucida
