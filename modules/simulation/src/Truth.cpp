#include "pellucida/simulation/Truth.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"
#include "pellucida/microscopy/MicroscopeScene.h"

namespace pellucida {
namespace {

// A section's contour in the image, turned so that its signed area is positive.
MembraneContour place(Membrane membrane, const Contour_um& section, const SpecimenPose& pose) {
  MembraneContour contour;
  contour.membrane = membrane;
  const Eigen::Index n = section.cols();
  contour.points_um.resize(2, n);
  // The section runs clockwise in (across, axis): its area has the sign of minus their handedness.
  const bool reverse = pose.across.x() * pose.axis.y() - pose.across.y() * pose.axis.x() > 0;
  for (Eigen::Index i = 0; i < n; ++i) contour.points_um.col(i) = pose.to_image(section.col(reverse ? (n - i) % n : i));
  contour.confidence = Eigen::VectorXd::Ones(n);
  return contour;
}

// Direction in degrees; what rounding leaves of a right angle is taken away.
double degrees(const Eigen::Vector2d& direction) {
  const double angle = std::atan2(direction.y(), direction.x()) * 180 / std::numbers::pi;
  return std::round(angle * 1e9) / 1e9 + 0.0;
}

// A column of the file of truth.
struct TruthColumn {
  std::string_view name;
  double (*value)(const Truth& truth);
};

constexpr TruthColumn kTruthColumns[] = {
    {"frame", [](const Truth& truth) { return static_cast<double>(truth.observation.frame_index); }},
    {"time_s", [](const Truth& truth) { return truth.observation.time_s; }},
    {"state", [](const Truth& truth) { return static_cast<double>(truth.observation.state); }},
    {"cell_x_um", [](const Truth& truth) { return truth.observation.center_um.x(); }},
    {"cell_y_um", [](const Truth& truth) { return truth.observation.center_um.y(); }},
    {"axis_deg", [](const Truth& truth) { return degrees(truth.observation.axis); }},
    {"tip_x_um", [](const Truth& truth) { return truth.observation.needle->tip_um.x(); }},
    {"tip_y_um", [](const Truth& truth) { return truth.observation.needle->tip_um.y(); }},
    {"indentation_um", [](const Truth& truth) { return truth.observation.indentation_um; }},
    {"dimple_radius_um", [](const Truth& truth) { return truth.observation.dimple_radius_um; }},
    {"contact_force_uN", [](const Truth& truth) { return truth.contact_force_uN; }},
    {"pressure_Pa", [](const Truth& truth) { return truth.pressure_Pa; }},
    {"volume_um3", [](const Truth& truth) { return truth.volume_um3; }},
    {"rotation_deg", [](const Truth& truth) { return truth.observation.rotation_rad * 180 / std::numbers::pi; }},
    {"lateral_force_uN", [](const Truth& truth) { return truth.lateral_force_uN; }},
    {"deposited_pL", [](const Truth& truth) { return truth.deposited_pL; }},
};

NeedlePose place_needle(const Scenario::Tools& tools, const SpecimenPose& pose, double tip_x_um, double tip_z_um,
                        double length_um) {
  NeedlePose needle;
  needle.tip_um = pose.to_image({tip_x_um, tip_z_um});
  needle.direction = -pose.axis;
  needle.tip_radius_um = tools.needle_tip_radius_um;
  needle.confidence = 1.0;

  // Tip, down one side, and back along the other. Fine steps round the tip, coarse ones along the shaft.
  std::vector<double> back_um;
  for (double back = 0.1; back < length_um; back += back < 2 * tools.needle_tip_radius_um ? 0.25 : 5.0)
    back_um.push_back(back);
  const auto count = static_cast<Eigen::Index>(back_um.size());
  needle.outline_um.resize(2, 2 * count + 1);
  needle.outline_um.col(0) = needle.tip_um;
  for (Eigen::Index i = 0; i < count; ++i) {
    const double back = back_um[static_cast<std::size_t>(i)], width = needle_half_width_um(tools, back);
    needle.outline_um.col(1 + i) = pose.to_image({tip_x_um + width, tip_z_um + back});
    needle.outline_um.col(2 * count - i) = pose.to_image({tip_x_um - width, tip_z_um + back});
  }
  return needle;
}

HolderPose place_holder(const VirtualSpecimen& specimen, const Eigen::Vector2d& center_um,
                        const Eigen::Vector2d& direction, double length_um) {
  const HolderRim rim = holder_rim(specimen);
  HolderPose holder;
  holder.direction = direction;
  holder.mouth_um = center_um + (rim.distance_um - rim.wall_radius_um) * holder.direction;
  holder.outer_radius_um = rim.ring_radius_um + rim.wall_radius_um;
  holder.confidence = 1.0;

  // One outer side, round both rims and the mouth between them, and back along the other side.
  const Eigen::Vector2d side(-holder.direction.y(), holder.direction.x());
  std::vector<Eigen::Vector2d> points;
  auto add = [&](double across, double along) {
    points.push_back(center_um + across * side + along * holder.direction);
  };
  add(holder.outer_radius_um, rim.distance_um + length_um);
  for (int sign : {1, -1})
    for (int k = 0; k <= 12; ++k) {
      // Each wall's end is a half circle towards the cell: from outside to inside, then from inside to outside.
      const double angle = std::numbers::pi * k / 12, across = rim.wall_radius_um * std::cos(angle);
      add(sign * rim.ring_radius_um + across, rim.distance_um - rim.wall_radius_um * std::sin(angle));
    }
  add(-holder.outer_radius_um, rim.distance_um + length_um);
  holder.outline_um.resize(2, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) holder.outline_um.col(static_cast<Eigen::Index>(i)) = points[i];
  return holder;
}

// Tools alone: nothing to touch.
Truth without_cell(const Truth& truth) {
  Truth empty;
  const Observation& seen = truth.observation;
  empty.observation.time_s = seen.time_s;
  empty.observation.frame_index = seen.frame_index;
  empty.observation.confidence = 1.0;
  empty.observation.needle = seen.needle;
  empty.observation.holder = seen.holder;
  empty.observation.center_um = seen.center_um;
  empty.observation.rotation_rad = seen.rotation_rad;
  empty.observation.axis = seen.axis;
  empty.tip_um = truth.tip_um;
  return empty;
}

}  // namespace

Scenario with_tools_drawn(const Scenario& scenario) {
  Scenario drawn = scenario;
  if (drawn.tools.needle_tip_radius_um > 0.0) return drawn;
  const double tip_um = scenario.cell.size_scale * load_reference_geometry(scenario.cell.reference).tip_radius_um;
  drawn.tools.needle_tip_radius_um = tip_um;
  drawn.tools.needle_shaft_radius_um = std::max(drawn.tools.needle_shaft_radius_um, 1.2 * tip_um);
  return drawn;
}

double needle_half_width_um(const Scenario::Tools& tools, double back_um) noexcept {
  const double r = tools.needle_tip_radius_um;
  if (back_um < r) return std::sqrt(std::max(0.0, r * r - (r - back_um) * (r - back_um)));
  // A cone at first, then ever closer to the shaft's width.
  const double widening = tools.needle_shaft_radius_um - r,
               slope = std::tan(tools.needle_taper_deg * std::numbers::pi / 180);
  return widening <= 0 ? r : r + widening * -std::expm1(-(back_um - r) * slope / widening);
}

HolderRim holder_rim(const VirtualSpecimen& specimen) noexcept {
  // The glass is as wide as the ring that holds the cell in the finite elements (12.5 to 22.5 um on the mouse oocyte).
  const double scale = specimen.size_scale();
  const ReferenceGeometry& geometry = specimen.reference().geometry();
  HolderRim rim;
  rim.wall_radius_um = scale * geometry.holder_half_width_um;
  rim.ring_radius_um = scale * geometry.holder_ring_um;
  const double sine = geometry.holder_ring_um / (geometry.outer_radius_um() + geometry.holder_half_width_um);
  const double reach = scale * geometry.outer_radius_um(std::asin(std::min(1.0, sine))) + rim.wall_radius_um;
  rim.distance_um = std::sqrt(reach * reach - rim.ring_radius_um * rim.ring_radius_um);
  return rim;
}

Truth make_truth(const Scenario& scenario, const VirtualSpecimen& specimen, const SpecimenState& state,
                 const StagePose& stage, double time_s, long frame_index) {
  const SpecimenPose pose = stage.place(specimen.pose());

  Truth truth;
  Observation& seen = truth.observation;
  seen.time_s = time_s;
  seen.frame_index = frame_index;
  seen.state = state.state;
  seen.confidence = 1.0;
  seen.outer = place(Membrane::kOuter, state.section.outer_um, pose);
  seen.inner = place(Membrane::kInner, state.section.inner_um, pose);
  if (scenario.cell.perivitelline_gap_um > 0)
    seen.oolemma =
        place(Membrane::kOolemma, offset_contour(state.section.inner_um, -scenario.cell.perivitelline_gap_um), pose);

  // The tip sits on the outer apex while the membrane is whole. Tools reach out of any picture.
  const double diagonal_um =
      scenario.image.pixel_size_um * std::hypot(scenario.image.width_px, scenario.image.height_px) + 100.0;
  const double tip_z_um =
      specimen.rest_z_um(std::hypot(state.tip_offset_um, state.tip_out_of_plane_um)) - state.tip_depth_um;
  seen.needle = place_needle(scenario.tools, pose, state.tip_offset_um, tip_z_um, diagonal_um);
  seen.holder = place_holder(specimen, pose.center_um, stage.turn(specimen.holder_direction()), diagonal_um);

  seen.center_um = pose.center_um;
  seen.rotation_rad = stage.rotation_rad;
  seen.rest_outer_radius_um = specimen.outer_radius_um();
  seen.rest_inner_radius_um = specimen.inner_radius_um();
  seen.rest_beyond_um =
      std::hypot(state.tip_offset_um, specimen.rest_z_um(state.tip_offset_um)) - seen.rest_outer_radius_um;
  seen.axis = pose.axis;
  seen.indentation_um = state.membrane_depth_um;
  seen.dimple_radius_um = state.membrane_depth_um > 0 ? dimple_radius_um(state.section.outer_um) : 0.0;

  truth.contact_force_uN = state.contact_force_uN;
  truth.lateral_force_uN = state.lateral_force_uN;
  truth.tip_um = {seen.needle->tip_um.x(), seen.needle->tip_um.y(), state.tip_out_of_plane_um};
  truth.tip_depth_um = state.tip_depth_um;
  truth.in_range = state.in_range;
  truth.deposited_pL = state.moment.deposited_pL;
  for (int k = 0; k < state.moment.droplet_count; ++k) {
    Droplet droplet = state.moment.droplets[static_cast<std::size_t>(k)];
    const Eigen::Vector2d place = stage.place({droplet.center_um.x, droplet.center_um.y});
    droplet.center_um = {place.x(), place.y(), droplet.center_um.z};
    truth.droplets.push_back(droplet);
  }
  truth.pressure_Pa = state.pressure_Pa;
  truth.volume_um3 = revolved_volume_um3(state.section.outer_um);
  return scenario.cell.in_view ? truth : without_cell(truth);
}

TruthWriter::TruthWriter(const std::filesystem::path& file) : file_(file), rows_(file), contours_(contour_file(file)) {
  const char* separator = "";
  for (const TruthColumn& column : kTruthColumns) rows_ << std::exchange(separator, ",") << column.name;
  rows_ << '\n';
  contours_ << "frame,membrane,point,x_um,y_um\n";
  check(rows_, file_);
  check(contours_, contour_file(file_));
}

void TruthWriter::write(const Truth& truth) {
  const char* separator = "";
  for (const TruthColumn& column : kTruthColumns)
    rows_ << std::exchange(separator, ",") << csv_number(column.value(truth));
  rows_ << '\n' << std::flush;

  const Observation& seen = truth.observation;
  for (const auto* contour : {&seen.outer, &seen.inner, &seen.oolemma}) {
    if (!*contour) continue;
    const auto& points = (*contour)->points_um;
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      contours_ << seen.frame_index << ',' << static_cast<int>((*contour)->membrane) << ',' << i << ','
                << csv_number(points(0, i)) << ',' << csv_number(points(1, i)) << '\n';
  }
  contours_ << std::flush;
  check(rows_, file_);
  check(contours_, contour_file(file_));
}

std::filesystem::path TruthWriter::contour_file(const std::filesystem::path& file) {
  auto beside = file;
  return beside.replace_filename(file.stem().string() + "_contours" + file.extension().string());
}

void TruthWriter::check(const std::ofstream& stream, const std::filesystem::path& file) const {
  if (!stream)
    throw OutputError("truth file '" + file.string() + "' can't be written; check folder, permission and free space");
}

}  // namespace pellucida
