#include "OpticalScene.h"

#include <cmath>
#include <numbers>

namespace pellucida {
namespace {

constexpr double kAir_index = -0.33, kDebris_index = 0.04, kDroplet_index = -0.012;

ImageView format_of(const Scenario::Image& image) {
  ImageView view;
  view.format = image.bit_depth == 16 ? PixelFormat::kGray16 : PixelFormat::kGray8;
  view.width_px = image.width_px;
  view.height_px = image.height_px;
  view.pixel_size_um = image.pixel_size_um;
  return view;
}

// Particles on the glass: some clear, some dark.
std::vector<SceneBall> make_debris(const Scenario& scenario) {
  std::mt19937_64 engine(mix(scenario.seed ^ 0x646562726973ULL));
  std::vector<SceneBall> debris;
  for (int k = 0; k < scenario.debris.count; ++k) {
    const double x = uniform(engine) * scenario.image.width_px, y = uniform(engine) * scenario.image.height_px;
    const double radius_um = 0.5 + (scenario.debris.max_radius_um - 0.5) * uniform(engine);
    debris.push_back({scenario.image.pixel_size_um * Eigen::Vector2d(x, y), radius_um,
                      kDebris_index * (0.3 + uniform(engine)), 0.25 * std::pow(uniform(engine), 3)});
  }
  return debris;
}

// A second cell, whole and at rest, with grains; and an air bubble.
std::vector<SceneBall> make_bystanders(const Scenario& scenario, const Look& look, double zona_um) {
  const Scenario::Bystander& bystander = scenario.bystander;
  std::vector<SceneBall> balls;
  if (bystander.cell_radius_um > 0) {
    const Eigen::Vector2d center(bystander.cell_x_um, bystander.cell_y_um);
    const double inner = std::max(0.5 * bystander.cell_radius_um, bystander.cell_radius_um - zona_um);
    balls.push_back({center, bystander.cell_radius_um, look.cell.zona_index, 1e-3 * look.cell.zona_absorption_per_mm});
    balls.push_back(
        {center, inner, look.cell.ooplasm_index - look.cell.zona_index, 1e-3 * look.cell.ooplasm_absorption_per_mm});
    std::mt19937_64 engine(mix(scenario.seed ^ 0x627973746eULL));
    const int grain_count = look.cell.grain_ratio > 0 || look.cell.lipid_ratio > 0 ? 400 : 0;
    for (int k = 0; k < grain_count; ++k) {
      const double radius = 0.95 * inner * std::sqrt(uniform(engine)), angle = 2 * std::numbers::pi * uniform(engine);
      const bool lipid = uniform(engine) < look.cell.lipid_ratio;
      balls.push_back({center + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)), 0.6 + 1.2 * uniform(engine),
                       (lipid ? 0.08 : 0.012 * normal(engine)), lipid ? 0.035 : 0.0});
    }
  }
  if (bystander.bubble_radius_um > 0)
    balls.push_back({{bystander.bubble_x_um, bystander.bubble_y_um}, bystander.bubble_radius_um, kAir_index, 0.0});
  return balls;
}

}  // namespace

OpticalScene::OpticalScene(const Scenario& scenario, const Look& look, const VirtualSpecimen& specimen)
    : scenario_(scenario),
      look_(look),
      rest_pose_(specimen.pose()),
      material_angle_rad_(specimen.reference().angle_rad().array() -
                          specimen.reference().angle_rad()(specimen.reference().angle_rad().size() / 2)),
      lying_(make_debris(scenario)),
      bystander_(make_bystanders(scenario, look, specimen.outer_radius_um() - specimen.inner_radius_um())),
      touching_angle_rad_(
          make_touching_angles(scenario.debris.touching_count, specimen.reference().holder_angle_rad(), scenario.seed)),
      passing_(make_passing_particles(scenario.debris.passing_count, scenario.debris.max_radius_um, scenario.seed)),
      renderer_(look, format_of(scenario.image), specimen.outer_radius_um(), scenario.seed) {
  const Scenario::Tools& tools = scenario.tools;
  scene_.needle_shape = {tools.needle_tip_radius_um, tools.needle_taper_deg, tools.needle_shaft_radius_um, look.needle};
  const HolderRim rim = holder_rim(specimen);
  const double holder_radius = rim.ring_radius_um + rim.wall_radius_um;
  scene_.holder_shape = {holder_radius, look.holder.wall_ratio * holder_radius, 1e-3 * look.holder.bend_per_mm};
}

ImageView OpticalScene::render(const Truth& truth, const SpecimenState& state, const StagePose& stage) {
  const Observation& seen = truth.observation;
  scene_.frame_index = seen.frame_index;
  scene_.time_s = seen.time_s;
  scene_.lamp_ratio = lamp_ratio(scenario_.lamp, seen.time_s);
  scene_.balls = lying_;
  place_dish(truth, stage);
  scene_.cell.reset();
  if (seen.outer) place_cell(truth, state, stage);
  scene_.needle = {seen.needle->tip_um, -seen.needle->direction};
  scene_.needle_out_of_plane_um = truth.tip_um.z;
  scene_.holder.reset();
  if (seen.holder) scene_.holder = {seen.holder->mouth_um, seen.holder->direction};
  return renderer_.render(scene_);
}

void OpticalScene::place_cell(const Truth& truth, const SpecimenState& state, const StagePose& stage) {
  const SpecimenPose pose = stage.place(rest_pose_);
  MicroscopeCell& cell = scene_.cell.emplace();
  cell.outer_um = state.section.outer_um;
  cell.inner_um = state.section.inner_um;
  cell.ooplasm_um = offset_contour(cell.inner_um, -scenario_.cell.perivitelline_gap_um);
  cell.angle_rad = material_angle_rad_.array() + state.apex_angle_rad;
  cell.needle_offset_um = state.tip_offset_um;
  cell.center_um = pose.center_um;
  cell.axis = pose.axis;
  cell.across = pose.across;
  for (const double angle : touching_angle_rad_) {
    const double radius_um = scenario_.debris.touching_radius_um;
    const Eigen::Vector2d place = touching_place_um(cell.outer_um, cell.angle_rad, angle, radius_um);
    scene_.balls.push_back({pose.to_image(place), radius_um, kDebris_index, 0.02});
  }
  // What the needle left: watery drops in the ooplasm.
  for (const Droplet& droplet : truth.droplets)
    scene_.balls.push_back({{droplet.center_um.x, droplet.center_um.y}, droplet.radius_um(), kDroplet_index, 0.0});
}

void OpticalScene::place_dish(const Truth& truth, const StagePose& stage) {
  for (SceneBall ball : bystander_) {
    ball.center_um = stage.place(ball.center_um);
    scene_.balls.push_back(ball);
  }
  const double pixel_um = scenario_.image.pixel_size_um;
  for (const PassingParticle& particle : passing_) {
    const Eigen::Vector2d place = passing_place_px(particle, scenario_.debris, truth.observation.time_s,
                                                   {scenario_.image.width_px, scenario_.image.height_px}, pixel_um);
    scene_.balls.push_back({place * pixel_um, particle.particle.radius_um, kDebris_index, 0.05});
  }
}

void OpticalScene::shape_tools(Truth& truth) const {
  NeedlePose& needle = *truth.observation.needle;
  const Eigen::Vector2d back = -needle.direction, left(-back.y(), back.x());
  const double length_um =
      scenario_.image.pixel_size_um * std::hypot(scenario_.image.width_px, scenario_.image.height_px) + 100.0;

  // Tip, down one side, and back along the other. Fine steps about the end, coarse ones along the shaft.
  const double fine_um = 30.0;
  std::vector<double> places;
  for (double at = 0.0; at < length_um; at += at < fine_um ? 0.25 : 5.0) places.push_back(at);
  const auto count = static_cast<Eigen::Index>(places.size());
  needle.outline_um.resize(2, 2 * count + 1);
  needle.outline_um.col(0) = needle.tip_um;
  for (Eigen::Index i = 0; i < count; ++i) {
    const double at = places[static_cast<std::size_t>(i)];
    const auto [low, high] = scene_.needle_shape.span_um(at);
    needle.outline_um.col(1 + i) = needle.tip_um + at * back + high * left;
    needle.outline_um.col(2 * count - i) = needle.tip_um + at * back + low * left;
  }

  std::optional<HolderPose>& holder = truth.observation.holder;
  if (!look_.holder.in_view) holder.reset();
  if (!holder) return;
  const HolderShape& shape = scene_.holder_shape;
  const Eigen::Vector2d along = holder->direction, side(-along.y(), along.x());
  std::vector<Eigen::Vector2d> points;
  auto add = [&](double at, int sign) {
    points.push_back(holder->mouth_um + at * along +
                     (shape.middle_um(at) + sign * (shape.ring_radius_um() + shape.half_wall_um(at))) * side);
  };
  for (double at = length_um; at > 0; at -= at > fine_um ? 5.0 : 0.5) add(at, 1);
  points.push_back(holder->mouth_um + shape.ring_radius_um() * side);
  points.push_back(holder->mouth_um - shape.ring_radius_um() * side);
  for (double at = 0.25; at < length_um; at += at < fine_um ? 0.5 : 5.0) add(at, -1);
  holder->outline_um.resize(2, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) holder->outline_um.col(static_cast<Eigen::Index>(i)) = points[i];
}

}  // namespace pellucida
