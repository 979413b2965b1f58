#include "pellucida/identification/ConstantsFit.h"

#include <ceres/cost_function.h>
#include <ceres/iteration_callback.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>
#include <cmath>

#include "CurveSensitivity.h"
#include "Workers.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr int kCount = 9;
/// Pull to the starting constants: what a factor of e off them costs, in units of error.
constexpr double kPull = 0.1;
/// Worst error, in units, below which pressing down the largest ones is no longer worth the time.
constexpr double kWellWithin = 0.7;

using Parameters = Eigen::Matrix<double, kCount, 1>;

/// log K2, K1/K2, log g by region.
Parameters to_parameters(const CellProfile& profile) {
  Parameters parameters;
  int at = 0;
  for (const RegionConstants* r : {&profile.tip, &profile.body, &profile.holder}) {
    parameters[at++] = std::log(r->k2_ratio);
    parameters[at++] = r->k1_over_k2;
    parameters[at++] = std::log(r->hinge_ratio);
  }
  return parameters;
}

ModelConstants to_constants(const Parameters& parameters) {
  ModelConstants constants;
  for (int r = 0; r < kCount; r += 3) {
    const double k2 = std::exp(parameters[r]);
    constants.segment<3>(r) << k2, k2 * parameters[r + 1], std::exp(parameters[r + 2]);
  }
  return constants;
}

/// Slopes by the constants to slopes by the parameters, row by row.
void to_parameter_slopes(const Parameters& parameters, Eigen::Matrix<double, Eigen::Dynamic, kCount>& slopes) {
  for (int r = 0; r < kCount; r += 3) {
    const double k2 = std::exp(parameters[r]);
    const Eigen::VectorXd by_k2 = slopes.col(r), by_k1 = slopes.col(r + 1);
    slopes.col(r) = k2 * (by_k2 + parameters[r + 1] * by_k1);
    slopes.col(r + 1) = k2 * by_k1;
    slopes.col(r + 2) *= std::exp(parameters[r + 2]);
  }
}

/// All curves at given parameters, in units of error. Keeps the last evaluation, since Ceres asks for the residuals of
/// a step before it asks for their Jacobian.
class Evaluation {
 public:
  Evaluation(const CellProfile& profile, const std::vector<ReferenceCurve>& curves, const FitOptions& options,
             const std::function<void(int, double)>& progress, const std::stop_token& cancel)
      : curves_(curves), options_(options), progress_(progress), cancel_(cancel) {
    for (const ReferenceCurve& curve : curves) {
      models_.emplace_back(profile, setup_for_needle(profile, curve.holder_angle_rad, curve.offset_um));
      rows_ += curve.depth_um.size();
    }
    (curves.front().depth_um.array() - options.anchor_um).abs().minCoeff(&anchor_);
    units_.resize(rows_);
    Eigen::Index row = 0;
    for (const ReferenceCurve& curve : curves) {
      Eigen::Index last = curve.depth_um.size() - 1;
      if (options.anchor_um > 0.0) (curve.depth_um.array() - options.anchor_um).abs().minCoeff(&last);
      const double peak_uN = curve.force_uN[last];
      for (Eigen::Index k = 0; k < curve.depth_um.size(); ++k) {
        const double share = (curve.depth_um[k] < options.from_um ? 2.0 : 1.0) * options.force_tolerance_ratio;
        const double unit =
            std::min(share * curve.force_uN[k], options.peak_tolerance_ratio * std::max(peak_uN, curve.force_uN[k]));
        units_[row++] = unit > 0.0 ? unit : options.peak_tolerance_ratio * peak_uN;  // at rest both are 0
      }
    }
  }

  /// Points of all curves, and the scale.
  Eigen::Index rows() const noexcept { return rows_ + 1; }
  int count() const noexcept { return count_; }
  double worst_unit() const { return errors_.head(rows_).cwiseAbs().maxCoeff(); }
  bool cancelled() const { return cancel_.stop_requested(); }
  const Eigen::VectorXd& errors() const noexcept { return errors_; }
  const Eigen::Matrix<double, Eigen::Dynamic, kCount>& slopes() const noexcept { return slopes_; }

  /// False when the model finds no equilibrium somewhere, or on a cancellation.
  bool at(const Parameters& parameters) {
    if (valid_ && parameters == parameters_) return true;
    if (cancelled() || !parameters.allFinite()) return false;
    valid_ = false;
    parameters_ = parameters;
    std::vector<CurveWithSlopes> found(curves_.size());
    run_jobs(static_cast<int>(curves_.size()), options_.threads, [&](int k) {
      const auto c = static_cast<std::size_t>(k);
      found[c] = models_[c].solve(to_constants(parameters), curves_[c].depth_um);
    });
    ++count_;
    for (const CurveWithSlopes& curve : found) {
      if (!curve.complete) return false;
    }

    // Scaled to the anchor: f = s F, s = Fref_a / F_a, df = s (dF - F / F_a dF_a).
    const double force_a_uN = found[0].force_uN[anchor_], reference_a_uN = curves_[0].force_uN[anchor_];
    if (!(force_a_uN > 0.0)) return false;
    const double scale = reference_a_uN / force_a_uN;
    for (CurveWithSlopes& curve : found) to_parameter_slopes(parameters, curve.slopes_uN);
    const Eigen::Matrix<double, 1, kCount> slope_a = found[0].slopes_uN.row(anchor_) / force_a_uN;
    errors_.resize(rows_ + 1);
    slopes_.resize(rows_ + 1, kCount);
    Eigen::Index row = 0;
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      const Eigen::Index size = curves_[c].depth_um.size();
      const auto units = units_.segment(row, size);
      errors_.segment(row, size) = (scale * found[c].force_uN - curves_[c].force_uN).cwiseQuotient(units);
      slopes_.middleRows(row, size) =
          units.cwiseInverse().asDiagonal() * (scale * (found[c].slopes_uN - found[c].force_uN * slope_a)).eval();
      row += size;
    }
    errors_[rows_] = -std::log(scale) / options_.scale_tolerance_ratio;
    slopes_.row(rows_) = slope_a / options_.scale_tolerance_ratio;
    valid_ = true;
    best_unit_ = count_ == 1 ? worst_unit() : std::min(best_unit_, worst_unit());
    if (progress_) progress_(count_, best_unit_);
    return true;
  }

 private:
  const std::vector<ReferenceCurve>& curves_;
  const FitOptions& options_;
  const std::function<void(int, double)>& progress_;
  const std::stop_token& cancel_;
  std::vector<CurveSensitivity> models_;
  Eigen::VectorXd units_;
  Eigen::Index rows_ = 0;
  Eigen::Index anchor_ = 0;  // of the first curve's points
  Parameters parameters_ = Parameters::Zero();
  bool valid_ = false;
  int count_ = 0;
  double best_unit_ = 0.0;
  Eigen::VectorXd errors_;
  Eigen::Matrix<double, Eigen::Dynamic, kCount> slopes_;
};

/// Half the sum of |e|^(2 power), and the pull.
class Cost final : public ceres::CostFunction {
 public:
  Cost(Evaluation& evaluation, const Parameters& start, int power)
      : evaluation_(evaluation), start_(start), power_(power) {
    mutable_parameter_block_sizes()->push_back(kCount);
    set_num_residuals(static_cast<int>(evaluation.rows()) + kCount);
  }

  bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override {
    const Parameters parameters = Eigen::Map<const Parameters>(blocks[0]);
    if (!evaluation_.at(parameters)) return false;
    const Eigen::Index rows = evaluation_.rows();
    const Eigen::ArrayXd errors = evaluation_.errors().array();
    const Eigen::ArrayXd less = errors.abs().pow(power_ - 1);
    Eigen::Map<Eigen::VectorXd> r(residuals, rows + kCount);
    r.head(rows) = (errors * less).matrix();
    r.tail<kCount>() = kPull * (parameters - start_);
    if (jacobians && jacobians[0]) {
      Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, kCount, Eigen::RowMajor>> j(jacobians[0], rows + kCount, kCount);
      j.topRows(rows) = (power_ * less).matrix().asDiagonal() * evaluation_.slopes();
      j.bottomRows<kCount>() = kPull * Eigen::Matrix<double, kCount, kCount>::Identity();
    }
    return true;
  }

 private:
  Evaluation& evaluation_;
  Parameters start_;
  int power_;
};

class StopWhenCancelled final : public ceres::IterationCallback {
 public:
  explicit StopWhenCancelled(const Evaluation& evaluation) : evaluation_(evaluation) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return evaluation_.cancelled() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

 private:
  const Evaluation& evaluation_;
};

}  // namespace

void set_starting_constants(CellProfile& profile) {
  // Springs as stiff as an isotropic membrane of nu = 1/2 is on regular triangles, plates as the law of the hinges has
  // them; a little softer towards the tools, where the strains are large.
  profile.tip = {2.6, -0.3, 0.7};
  profile.body = {3.2, 0.0, 1.2};
  profile.holder = {2.6, -0.1, 0.7};
}

FitReport fit_constants(CellProfile& profile, const std::vector<ReferenceCurve>& curves, const FitOptions& options,
                        const std::function<void(int evaluations, double worst_unit)>& progress,
                        const std::stop_token& cancel) {
  if (curves.empty()) throw UsageError("fit: there is no curve to fit to");
  for (const ReferenceCurve& curve : curves) {
    if (curve.depth_um.size() < 2) throw UsageError("fit: a curve has no point beyond rest; give a smaller step");
  }
  Evaluation evaluation(profile, curves, options, progress, cancel);
  Parameters parameters = to_parameters(profile);
  const double softest = -1.0 / (3.0 * options.largest_strain * options.largest_strain);
  for (int r = 1; r < kCount; r += 3) parameters[r] = std::max(parameters[r], softest);
  const Parameters start = parameters;
  if (!evaluation.at(parameters)) {
    if (cancel.stop_requested()) return {};
    throw UsageError("fit: the model finds no equilibrium with the starting constants; give a smaller largest depth");
  }

  FitReport report;
  report.complete = true;
  for (const int power : {1, 2, 4}) {
    if (power > 1 && evaluation.at(parameters) && evaluation.worst_unit() < kWellWithin) break;
    ceres::Problem problem;
    problem.AddResidualBlock(new Cost(evaluation, start, power), nullptr, parameters.data());
    for (int r = 0; r < kCount; r += 3) {
      problem.SetParameterLowerBound(parameters.data(), r + 1, softest);
      problem.SetParameterUpperBound(parameters.data(), r + 1, 10.0);
    }
    ceres::Solver::Options solver;
    solver.linear_solver_type = ceres::DENSE_QR;
    solver.max_num_iterations = options.max_iterations;
    solver.function_tolerance = 1e-2;
    solver.parameter_tolerance = 1e-5;
    solver.initial_trust_region_radius = 10.0;
    solver.logging_type = ceres::SILENT;
    solver.num_threads = 1;
    StopWhenCancelled callback(evaluation);
    solver.callbacks.push_back(&callback);
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    report.complete = report.complete && summary.IsSolutionUsable();
    if (cancel.stop_requested()) break;
  }
  report.complete = report.complete && !cancel.stop_requested() && evaluation.at(parameters);
  report.evaluations = evaluation.count();
  if (report.complete) {
    report.worst_unit = evaluation.worst_unit();
    set_constants(profile, to_constants(parameters));
  }
  return report;
}

}  // namespace pellucida
