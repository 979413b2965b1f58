#include "pellucida/mechanics_vtk/MechanicsStep.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <optional>
#include <string>

#include "ForceTransfer.h"
#include "WarningNews.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/mechanics/ContactModelBuilder.h"
#include "pellucida/mechanics/ForceObserver.h"

namespace pellucida {
namespace {

template <class... Numbers>
std::string format(const char* pattern, Numbers... numbers) {
  char text[192];
  std::snprintf(text, sizeof text, pattern, numbers...);
  return text;
}

constexpr const char* kRestDirection = "rest_direction";
/// The surface brings its directions with 32 bits: nearer than this they are the same.
constexpr double kSameDirection = 1e-6;

/// A point array of `values` (components x points).
vtkSmartPointer<vtkDoubleArray> make_array(const char* name, const Eigen::Ref<const Eigen::MatrixXd>& values) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.rows()));
  array->SetNumberOfTuples(values.cols());
  Eigen::Map<Eigen::MatrixXd>(array->GetPointer(0), values.rows(), values.cols()) = values;
  return array;
}

/// The model in its solved shape.
vtkSmartPointer<vtkPolyData> make_model(const ForceEstimate& e, double time_s, long frame_index) {
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  points->SetData(make_array("points", e.solved_um));
  vtkNew<vtkCellArray> cells;
  cells->AllocateEstimate(e.triangles.cols(), 3);
  for (Eigen::Index t = 0; t < e.triangles.cols(); ++t) {
    const vtkIdType nodes[3] = {e.triangles(0, t), e.triangles(1, t), e.triangles(2, t)};
    cells->InsertNextCell(3, nodes);
  }
  auto model = vtkSmartPointer<vtkPolyData>::New();
  model->SetPoints(points);
  model->SetPolys(cells);
  model->GetPointData()->AddArray(make_array(array_name::kForce, e.force_uN));
  model->GetPointData()->AddArray(make_array(array_name::kDisplacement, e.solved_um - e.rest_um));
  model->GetPointData()->AddArray(make_array(array_name::kTension, e.tension_uN_per_um.transpose()));
  model->GetPointData()->AddArray(make_array(array_name::kAreaStrain, e.area_strain_percent.transpose()));
  model->GetFieldData()->AddArray(make_array(array_name::kCenter, e.center_um));
  model->GetFieldData()->AddArray(make_array(array_name::kAxis, e.rotation_WC.col(2)));
  stamp(model, time_s, frame_index);
  return model;
}

/// Share of the unit sphere of each node of the outer membrane, from the surface's cells at rest; 0 on other membranes.
Eigen::VectorXd outer_areas(vtkPolyData* surface, vtkDataArray* membrane, const Eigen::Matrix3Xd& directions) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(directions.cols());
  const auto is_outer = [&](vtkIdType node) {
    return static_cast<int>(membrane->GetTuple1(node)) == static_cast<int>(Membrane::kOuter);
  };
  vtkCellArray* cells = surface->GetPolys();
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c) {
    vtkIdType count = 0;
    const vtkIdType* nodes = nullptr;
    cells->GetCellAtId(c, count, nodes);
    if (count < 3 || !is_outer(nodes[0])) continue;
    double area = 0.0;
    for (vtkIdType k = 1; k + 1 < count; ++k) {
      const Eigen::Vector3d a = directions.col(nodes[0]);
      area += 0.5 * (directions.col(nodes[k]) - a).cross(directions.col(nodes[k + 1]) - a).norm();
    }
    for (vtkIdType k = 0; k < count; ++k) areas[nodes[k]] += area / static_cast<double>(count);
  }
  return areas;
}

}  // namespace

class MechanicsStep::Impl {
 public:
  explicit Impl(CellProfile profile) : observer_(std::move(profile)) {}

  ForceObserver& observer() noexcept { return observer_; }

  void set_scale_measurements(std::vector<ScaleMeasurement> measurements) {
    for (const ScaleMeasurement& one : measurements) way_of(one);
    std::lock_guard lock(waiting_mutex_);
    waiting_ = std::move(measurements);
  }

  expected<Scene, StepFailure> process(const Scene& scene, const SolvedShape* known) {
    ForceEstimate e;
    auto measured = measure(scene, known, e);
    if (!measured) return unexpected<StepFailure>(std::move(measured.error()));
    Scene& out = measured->scene;
    if (e.rest_um.cols() == 0 || !e.converged) return std::move(out);

    // The model's own surface, and its forces on the surface that people look at.
    out.model = Frozen<vtkPolyData>(make_model(e, scene.observation->time_s, scene.observation->frame_index));
    const SurfaceForces& forces = measured->forces;
    if (forces.force_uN) {
      auto surface = scene.surface.shallow_copy();
      vtkPointData* data = surface->GetPointData();
      for (vtkDataArray* array : forces.arrays()) data->AddArray(array);
      out.surface = Frozen<vtkPolyData>(surface);
    }
    return std::move(out);
  }

  /// `e`: what it was made of.
  expected<MeasuredScene, StepFailure> measure(const Scene& scene, const SolvedShape* known, ForceEstimate& e) {
    if (!scene.observation) return unexpected<StepFailure>({"mechanics: the scene has no observation"});
    if (scene.run_index != run_index_) {
      run_index_ = scene.run_index;
      observer_.reset();
      said_.clear();
      warnings_.clear();
      reported_puncture_ = false;
      told_puncture_uN_ = 0.0;
    }
    take_measurements();
    MeasuredScene measured{.scene = scene, .forces = {}};
    Scene& out = measured.scene;
    e = observer_.process(*scene.observation, known);

    out.contact = contact_model(*scene.observation, e, scene.arrival_s);

    // The row: what is not measured stays empty.
    out.measurement.contact_force_uN = e.contact_force_uN;
    out.measurement.contact_force_lower_uN = e.contact_force_lower_uN;
    out.measurement.contact_force_upper_uN = e.contact_force_upper_uN;
    out.measurement.contact_force_picture_lower_uN = e.by_picture.lower_uN;
    out.measurement.contact_force_picture_upper_uN = e.by_picture.upper_uN;
    out.measurement.contact_force_scale_lower_uN = e.by_scale.lower_uN;
    out.measurement.contact_force_scale_upper_uN = e.by_scale.upper_uN;
    out.measurement.pressure_Pa = e.converged ? e.pressure_Pa : Measurement::kNotMeasured;
    if (std::isnan(out.measurement.volume_um3)) out.measurement.volume_um3 = e.volume_um3;
    out.measurement.lateral_force_uN = e.lateral_force_uN;
    out.measurement.stiffness_uN_per_um = e.stiffness_uN_per_um;
    out.measurement.shape_residual_um = e.shape.residual_rms_um;
    out.measurement.asymmetry_um = e.shape.asymmetry_um;
    out.measurement.model_spread_percent = e.opinions.spread_percent;
    out.measurement.puncture_probability = e.puncture_probability;
    if (e.expected_puncture.force_uN > 0.0) {
      out.measurement.expected_puncture_uN = e.expected_puncture.force_uN;
      out.measurement.expected_puncture_um = e.expected_puncture.depth_um;
    }
    add_events(e, *scene.observation, out);

    // Why there is no force: with every frame, and once as a note when the reason is new.
    const std::optional<CellState> state = out.measurement.state;
    const bool should_measure = state == CellState::kContact || state == CellState::kFree;
    out.remarks = {.reason = should_measure ? e.reason : std::string(),
                   .warning = describe(e.warnings, observer_.profile().name),
                   .point_load_uN = e.opinions.point_load_uN,
                   .table_uN = e.opinions.table_uN,
                   .scale_ratio = observer_.scale().ratio,
                   .scale_sigma_ratio = observer_.scale().relative_sigma,
                   .has_own_scale = observer_.has_own_scale()};
    if (should_measure && !e.reason.empty() && e.reason != said_) {
      out.events.push_back({scene.observation->time_s, event_kind::kNote, "no force: " + e.reason});
    }
    if (should_measure) said_ = e.reason;
    if (e.rest_um.cols() > 0 && e.converged && scene.surface) {
      // Only read; VTK's getters are not const.
      measured.forces = forces_on(e, const_cast<vtkPolyData*>(scene.surface.get()));
    }
    return measured;
  }

 private:
  void take_measurements() {
    std::lock_guard lock(waiting_mutex_);
    if (!waiting_) return;
    observer_.set_scale_measurements(std::move(*waiting_));
    waiting_.reset();
  }

  SurfaceForces forces_on(const ForceEstimate& e, vtkPolyData* surface) {
    vtkDataArray* direction = surface->GetPointData()->GetArray(kRestDirection);
    vtkDataArray* membrane = surface->GetPointData()->GetArray(array_name::kMembrane);
    const vtkIdType count = surface->GetNumberOfPoints();
    if (!direction || !membrane || count == 0 || direction->GetNumberOfComponents() != 3) return {};

    // Directions at rest, in the cell frame: there they hardly ever change.
    Eigen::Matrix3Xd directions(3, count);
    for (vtkIdType n = 0; n < count; ++n) direction->GetTuple(n, directions.col(n).data());
    directions = e.rotation_WC.transpose() * directions;
    directions.colwise().normalize();
    const bool known = transfer_ && directions_.cols() == count && nodes_ == e.rest_um.cols() &&
                       (directions_ - directions).cwiseAbs().maxCoeff() < kSameDirection;
    if (!known) {
      Eigen::Matrix3Xd model = e.rotation_WC.transpose() * (e.rest_um.colwise() - e.center_um);
      model.colwise().normalize();
      transfer_.emplace(model, e.triangles, directions, outer_areas(surface, membrane, directions));
      directions_ = directions;
      nodes_ = e.rest_um.cols();
    }

    // Forces keep their sum; tension and strain are read off.
    const auto handed = [&](const char* name, const Eigen::MatrixXd& of_nodes) {
      return make_array(name, (transfer_->extensive() * of_nodes.transpose()).transpose());
    };
    const auto read_off = [&](const char* name, const Eigen::VectorXd& of_nodes) {
      return make_array(name, (transfer_->intensive() * of_nodes).transpose());
    };
    return {.force_uN = handed(array_name::kForce, e.force_uN),
            .force_sigma_uN = handed(array_name::kForceSigma, e.force_sigma_uN.transpose()),
            .needle_force_uN = handed(array_name::kNeedleForce, e.needle_force_uN),
            .holder_force_uN = handed(array_name::kHolderForce, e.holder_force_uN),
            .tension_uN_per_um = read_off(array_name::kTension, e.tension_uN_per_um),
            .tension_sigma_uN_per_um = read_off(array_name::kTensionSigma, e.tension_sigma_uN_per_um),
            .area_strain_percent = read_off(array_name::kAreaStrain, e.area_strain_percent)};
  }

  /// Events of the contact: a puncture, once; a warning, when it is new; a palpation, when it counts.
  void add_events(const ForceEstimate& e, const Observation& o, Scene& out) {
    out.measurement.state = e.judged_state(o.state);
    // One event a puncture, with its force; none from the tracker, whose word may come late, or be doubted.
    if (e.puncture || e.puncture_doubted || (reported_puncture_ && e.punctured)) {
      std::erase_if(out.events, [](const Event& event) { return event.kind == event_kind::kPuncture; });
    }
    if (e.puncture) {
      const Puncture& p = *e.puncture;
      out.events.push_back({o.time_s, event_kind::kPuncture,
                            format("at %.2f uN and %.1f um, work %.1f uN um; membrane back at %.1f um", p.peak_force_uN,
                                   p.depth_um, p.work_uN_um, o.indentation_um)});
      reported_puncture_ = true;
    }
    if (e.puncture_revoked && reported_puncture_) {
      out.events.push_back(
          {o.time_s, event_kind::kRevoked, format("membrane and tip are together again at %.1f um", o.indentation_um)});
    }
    if (!e.punctured) reported_puncture_ = false;

    const unsigned fresh = warnings_.add(e.warnings, o.time_s);
    if (fresh != 0U) {
      std::string detail = to_string(static_cast<ForceWarning>(fresh));
      detail += format(": contour %.1f um from the model, left and right %.1f um apart beyond it",
                       e.shape.residual_rms_um, e.shape.unexplained_asymmetry_um);
      if (fresh & kNotOfRevolution) detail += format(", which may cost %.2f uN", e.asymmetry_force_uN);
      if (fresh & kSeldomBorne) detail += "; " + describe(kSeldomBorne, observer_.profile().name);
      out.events.push_back({o.time_s, event_kind::kWarning, std::move(detail)});
    }

    note_puncture(e, o, out);
    const CellScale scale = observer_.scale();
    // A model built anew changes it by a trifle.
    const bool is_news = std::abs(std::log(scale.ratio / reported_scale_.ratio)) > 0.01 ||
                         std::abs(scale.relative_sigma - reported_scale_.relative_sigma) > 0.005;
    if (observer_.has_own_scale() && is_news) {
      reported_scale_ = scale;
      out.events.push_back({o.time_s, event_kind::kPalpation,
                            format("this cell's forces are %.3f times the profile's, +- %.1f %%", scale.ratio,
                                   100.0 * scale.relative_sigma) +
                                far_from_kind(scale)});
    }
  }

  /// Once a cell, as it is touched: that it is expected to give way elsewhere than its kind.
  void note_puncture(const ForceEstimate& e, const Observation& o, Scene& out) {
    const ExpectedPuncture& expected = e.expected_puncture;
    if (o.state != CellState::kContact || !(expected.force_uN > 0.0)) return;
    const CellProfile& kind = observer_.profile();
    constexpr double kNews = 0.2;
    const bool is_told = std::abs(std::log(expected.force_uN / told_puncture_uN_)) < kNews;
    const bool is_usual = std::abs(std::log(expected.force_uN / kind.puncture_force_uN)) < kNews;
    if (is_told || (is_usual && told_puncture_uN_ == 0.0)) return;
    told_puncture_uN_ = expected.force_uN;
    out.events.push_back(
        {o.time_s, event_kind::kNote,
         format("by its sizes and the needle's this cell is expected to give way at %.1f uN and %.0f "
                "um, its kind at %.1f uN and %.0f um",
                expected.force_uN, expected.depth_um, kind.puncture_force_uN, kind.puncture_indentation_um)});
  }

  /// A measured scale that hardly any cell of the kind has.
  std::string far_from_kind(const CellScale& scale) const {
    const double sigmas = std::abs(std::log(scale.ratio)) / scale_before(observer_.profile()).relative_sigma;
    constexpr double kFar = 2.0;
    if (sigmas < kFar) return {};
    return format("; %.1f standard deviations from the kind: check the measurement, and that profile ", sigmas) +
           observer_.profile().name + " is this cell's";
  }

  ForceObserver observer_;
  WarningNews warnings_;
  double told_puncture_uN_ = 0.0;   // the expected one of the last note; 0: none yet
  bool reported_puncture_ = false;  // the state has been punctured since
  CellScale reported_scale_;
  std::mutex waiting_mutex_;
  std::optional<std::vector<ScaleMeasurement>> waiting_;  // measurements for the next frame
  std::string said_;                                      // the last reason given
  long run_index_ = 0;
  std::optional<ForceTransfer> transfer_;
  Eigen::Matrix3Xd directions_;  // the surface's, as the transfer was made for
  Eigen::Index nodes_ = 0;       // the model's, likewise
};

MechanicsStep::MechanicsStep(CellProfile profile) : impl_(std::make_unique<Impl>(std::move(profile))) {}
MechanicsStep::~MechanicsStep() = default;
MechanicsStep::MechanicsStep(MechanicsStep&&) noexcept = default;
MechanicsStep& MechanicsStep::operator=(MechanicsStep&&) noexcept = default;

expected<Scene, StepFailure> MechanicsStep::process(const Scene& scene, const SolvedShape* known) {
  return impl_->process(scene, known);
}
expected<MeasuredScene, StepFailure> MechanicsStep::measure(const Scene& scene, const SolvedShape* known) {
  ForceEstimate estimate;
  return impl_->measure(scene, known, estimate);
}
std::shared_ptr<const SolvedShape> MechanicsStep::solved_shape() const {
  return impl_->observer().solved_shape();
}

void MechanicsStep::set_scale_measurements(std::vector<ScaleMeasurement> measurements) {
  impl_->set_scale_measurements(std::move(measurements));
}
CellScale MechanicsStep::scale() const noexcept {
  return impl_->observer().scale();
}
std::vector<PunctureRisk> MechanicsStep::puncture_risk(double step_um) {
  return impl_->observer().puncture_risk(step_um);
}

}  // namespace pellucida
