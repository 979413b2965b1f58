#include "CurveSensitivity.h"

#include <array>
#include <cmath>
#include <vector>

#include "pellucida/core/Error.h"
#include "pellucida/membrane/Indenter.h"

namespace pellucida {
namespace {

constexpr int kRegions = 3;

RegionConstants& region(CellProfile& profile, int r) {
  return r == 0 ? profile.tip : r == 1 ? profile.body : profile.holder;
}
const RegionConstants& region(const CellProfile& profile, int r) {
  return r == 0 ? profile.tip : r == 1 ? profile.body : profile.holder;
}

}  // namespace

ModelConstants constants_of(const CellProfile& profile) {
  ModelConstants constants;
  for (int r = 0; r < kRegions; ++r) {
    const RegionConstants& one = region(profile, r);
    constants.segment<3>(3 * r) << one.k2_ratio, one.k1_over_k2 * one.k2_ratio, one.hinge_ratio;
  }
  return constants;
}

void set_constants(CellProfile& profile, const ModelConstants& constants) {
  for (int r = 0; r < kRegions; ++r) {
    const double k2 = constants[3 * r];
    region(profile, r) = {k2, constants[3 * r + 1] / k2, constants[3 * r + 2]};
  }
}

class CurveSensitivity::Impl {
 public:
  Impl(CellProfile profile, const MembraneSetup& setup) : profile_(std::move(profile)), setup_(setup) {
    // One part of the energy for each constant, the constant being 1.
    const MembraneModel model(profile_, setup_);
    const TriangleMesh& rest = model.rest();
    const auto pairs = triangle_pairs(rest.triangles);
    const RegionShares shares = region_shares(rest, profile_, setup_.holder);
    const double membrane = model.force_scale_uN_per_um();
    const double e = 1e-3 * profile_.effective_young_modulus_kPa;
    const double plate =
        e * std::pow(setup_.thickness_um, 3) / (12.0 * (1.0 - profile_.poisson_ratio * profile_.poisson_ratio));
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(rest.points_um.cols());
    for (const Eigen::VectorXd* share : {&shares.tip, &shares.body, &shares.holder}) {
      const Eigen::VectorXd stiffness = membrane * *share;
      springs_.emplace_back(rest, pairs, SpringConstants{stiffness, none});
      springs_.emplace_back(rest, pairs, SpringConstants{none, stiffness});
      hinges_.emplace_back(rest, pairs, Eigen::VectorXd(plate * *share));
    }
  }

  CurveWithSlopes solve(const ModelConstants& constants, const Eigen::VectorXd& depths_um) const {
    CellProfile profile = profile_;
    set_constants(profile, constants);
    Indenter indenter(profile, setup_);
    CurveWithSlopes curve;
    curve.force_uN.resize(depths_um.size());
    curve.slopes_uN.resize(depths_um.size(), 9);
    double last_um = 0.0;
    for (Eigen::Index k = 0; k < depths_um.size(); ++k) {
      if (!(depths_um[k] >= last_um)) throw UsageError("curve: depths must rise from 0");
      last_um = depths_um[k];
      const IndentationState state = indenter.advance_to(depths_um[k]);
      if (state.report.status != SolveStatus::kConverged) {
        curve.force_uN.conservativeResize(k);
        curve.slopes_uN.conservativeResize(k, 9);
        return curve;
      }
      curve.force_uN[k] = state.push_force_uN;
      curve.slopes_uN.row(k) = slopes(indenter.positions_um(), indenter.depth_tangent());
    }
    curve.complete = true;
    return curve;
  }

 private:
  Eigen::Matrix<double, 1, 9> slopes(const Eigen::Matrix3Xd& x_um, const Eigen::Matrix3Xd& tangent) const {
    Eigen::Matrix<double, 1, 9> row;
    Eigen::Matrix3Xd gradient(3, x_um.cols());
    const auto along = [&](const EnergyTerm& term) {
      gradient.setZero();
      term.add(x_um, &gradient, nullptr);
      return gradient.cwiseProduct(tangent).sum();
    };
    for (std::size_t r = 0; r < kRegions; ++r) {
      const auto at = static_cast<Eigen::Index>(3 * r);
      row[at] = along(springs_[2 * r]);
      row[at + 1] = along(springs_[2 * r + 1]);
      row[at + 2] = along(hinges_[r]);
    }
    return row;
  }

  CellProfile profile_;
  MembraneSetup setup_;
  std::vector<SpringTerm> springs_;  // K2 and K1 of each region
  std::vector<HingeTerm> hinges_;
};

CurveSensitivity::CurveSensitivity(CellProfile profile, const MembraneSetup& setup)
    : impl_(std::make_unique<Impl>(std::move(profile), setup)) {}
CurveSensitivity::~CurveSensitivity() = default;
CurveSensitivity::CurveSensitivity(CurveSensitivity&&) noexcept = default;
CurveSensitivity& CurveSensitivity::operator=(CurveSensitivity&&) noexcept = default;

CurveWithSlopes CurveSensitivity::solve(const ModelConstants& constants, const Eigen::VectorXd& depths_um) const {
  return impl_->solve(constants, depths_um);
}

}  // namespace pellucida
