#include "Renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "DistanceField.h"
#include "Optics.h"
#include "pellucida/microscopy/Strip.h"

namespace pellucida {

Renderer::Renderer(const Scenario& scenario, const VirtualSpecimen& specimen)
    : scenario_(scenario),
      rim_(holder_rim(specimen)),
      rest_pose_(specimen.pose()),
      pose_(rest_pose_),
      material_angle_rad_(specimen.reference().angle_rad().array() -
                          specimen.reference().angle_rad()(specimen.reference().angle_rad().size() / 2)),
      section_angle_rad_(specimen.reference().angle_rad()),
      inner_radius_um_(specimen.inner_radius_um()),
      outer_edge_(make_outer_edge(scenario)),
      inner_edge_(make_inner_edge(scenario)),
      ooplasm_edge_(make_ooplasm_edge(scenario)),
      ooplasm_weight_(make_inside_weight()),
      holder_edge_(make_holder_edge(scenario)),
      needle_edge_(make_needle_edge(scenario)),
      bubble_edge_(make_bubble_edge(scenario, scenario.bystander.bubble_radius_um)),
      droplet_edge_(make_droplet_edge(scenario)),
      granules_(make_granules(specimen.inner_radius_um(), 0.6 * scenario.image.pixel_size_um, scenario.seed)),
      mottling_(1.05 * specimen.outer_radius_um(), scenario.seed),
      touching_angle_rad_(
          make_touching_angles(scenario.debris.touching_count, specimen.reference().holder_angle_rad(), scenario.seed)),
      passing_(make_passing_particles(scenario.debris.passing_count, scenario.debris.max_radius_um, scenario.seed)),
      noise_(scenario.seed),
      background_(make_field_of_light(scenario)),
      frame_(scenario.image.height_px, scenario.image.width_px, scenario.image.bit_depth == 16 ? CV_16U : CV_8U) {}

const cv::Mat& Renderer::render(const Truth& truth, const SpecimenState& state, const StagePose& stage) {
  pose_ = stage.place(rest_pose_);
  section_angle_rad_ = material_angle_rad_.array() + state.apex_angle_rad;
  background_.copyTo(light_);
  draw_bystanders(stage);
  if (truth.observation.outer) draw_cell(truth, state);
  draw_particles(state, truth.observation.time_s);
  draw_holder(*truth.observation.holder, truth.observation.center_um);
  draw_droplets(truth);
  draw_needle(*truth.observation.needle, truth.tip_um.z);
  if (scenario_.optics.defocus_um > 0)
    cv::GaussianBlur(light_, light_, {}, scenario_.optics.defocus_um / scenario_.image.pixel_size_um, 0,
                     cv::BORDER_REPLICATE);
  const auto lamp = static_cast<float>(lamp_ratio(scenario_.lamp, truth.observation.time_s));
  if (scenario_.image.bit_depth == 16)
    count_light<std::uint16_t>(truth.observation.frame_index, lamp);
  else
    count_light<std::uint8_t>(truth.observation.frame_index, lamp);
  return frame_;
}

void Renderer::draw_grain(const Eigen::Vector2d& map_center_um, const cv::Rect& window) {
  const double pixel_um = scenario_.image.pixel_size_um;
  const Eigen::Vector2f center = (map_center_um / pixel_um - Eigen::Vector2d(window.x, window.y)).cast<float>();
  const Eigen::Vector2f across = (pose_.across / pixel_um).cast<float>(), axis = (pose_.axis / pixel_um).cast<float>();
  grain_.create(window.size());
  grain_.setTo(0);
  for (const Granule& granule : granules_) {
    const Eigen::Vector2f place = flow_.place_of(granule.ratio, granule.angle);
    const Eigen::Vector2f pixel = center + place.x() * across + place.y() * axis;
    draw_granule(grain_, pixel.x(), pixel.y(), granule.sigma_um / static_cast<float>(pixel_um), granule.strength);
  }
}

void Renderer::draw_cell(const Truth& truth, const SpecimenState& state) {
  const Observation& seen = truth.observation;
  const double pixel_um = scenario_.image.pixel_size_um;

  // Only the window about the cell is drawn.
  const auto& outer = seen.outer->points_um;
  const Eigen::Vector2d low = (outer.rowwise().minCoeff().array() - kBand_um) / pixel_um;
  const Eigen::Vector2d high = (outer.rowwise().maxCoeff().array() + kBand_um) / pixel_um;
  const cv::Rect window =
      cv::Rect(cv::Point(static_cast<int>(std::floor(low.x())), static_cast<int>(std::floor(low.y()))),
               cv::Point(static_cast<int>(std::ceil(high.x())) + 1, static_cast<int>(std::ceil(high.y())) + 1)) &
      cv::Rect({}, light_.size());
  if (window.empty()) return;
  signed_distance(outer, pixel_um, window, kBand_um, outer_distance_um_);
  signed_distance(seen.inner->points_um, pixel_um, window, kBand_um, inner_distance_um_);
  if (seen.oolemma) signed_distance(seen.oolemma->points_um, pixel_um, window, kBand_um, ooplasm_distance_um_);
  flow_.update(state.section.inner_um, section_angle_rad_);

  // Pixel to section frame, relative to the map's centre.
  const Eigen::Vector2d across = pose_.across, axis = pose_.axis;
  const Eigen::Vector2d map_center = seen.center_um + flow_.center().x() * across + flow_.center().y() * axis;
  draw_grain(map_center, window);

  // The side the light seems to come from; fixed in the image.
  const Eigen::Vector2d lit(std::cos(-std::numbers::pi / 4), std::sin(-std::numbers::pi / 4));
  const auto lit_across = static_cast<float>(lit.dot(across)), lit_axis = static_cast<float>(lit.dot(axis));

  const auto contrast = static_cast<float>(scenario_.optics.contrast),
             relief = static_cast<float>(scenario_.optics.relief);
  const float grain_depth = 0.075f * contrast * static_cast<float>(scenario_.optics.granularity);
  const auto radius_um = static_cast<float>(inner_radius_um_);
  for (int y = 0; y < window.height; ++y) {
    float* light = light_[window.y + y] + window.x;
    const float *outer_d = outer_distance_um_[y], *inner_d = inner_distance_um_[y];
    const float* grain = grain_[y];
    const float* ooplasm_d = seen.oolemma ? ooplasm_distance_um_[y] : inner_d;
    for (int x = 0; x < window.width; ++x) {
      if (outer_d[x] >= static_cast<float>(kBand_um)) continue;

      // Which material lies here: its direction at rest and its part of the way from the centre.
      const double from_x = (window.x + x) * pixel_um - map_center.x(),
                   from_y = (window.y + y) * pixel_um - map_center.y();
      const auto u = static_cast<float>(from_x * across.x() + from_y * across.y());
      const auto v = static_cast<float>(from_x * axis.x() + from_y * axis.y());
      const auto rest = flow_.rest_of(u, v);
      const float sine = std::sin(rest.angle), cosine = std::cos(rest.angle);
      const float facing = sine * lit_across + cosine * lit_axis;

      // Edges: uneven along the membrane, fringes brighter on the lit side. Neither moves a dark line.
      const float uneven = 1.0f + 0.07f * mottling_.at(radius_um * sine, radius_um * cosine);
      const float fringe = uneven * (1.0f + 0.7f * relief * facing);
      auto shade = [&](float through) { return 1.0f + (through - 1.0f) * (through > 1.0f ? fringe : uneven); };
      float through = shade(outer_edge_(outer_d[x])) * shade(inner_edge_(inner_d[x]));
      if (seen.oolemma) through *= shade(ooplasm_edge_(ooplasm_d[x]));

      // Grain and one-sided shading of what lies inside.
      if (outer_d[x] < 0) {
        const float inside = ooplasm_weight_(ooplasm_d[x]);
        const float cloud = mottling_.at(rest.ratio * radius_um * sine, rest.ratio * radius_um * cosine);
        const float grained = inside * (grain[x] + 0.5f * cloud) + (1 - inside) * 0.2f * cloud;
        const float sloped = facing * rest.ratio * (0.07f + 0.15f * rest.ratio * rest.ratio * rest.ratio);
        through *= 1.0f + grain_depth * grained + contrast * relief * inside * sloped;
      }
      light[x] *= through;
    }
  }
}

// A second cell, round and at rest, and an air bubble; both lie in the dish and move with the stage.
void Renderer::draw_bystanders(const StagePose& stage) {
  const double pixel_um = scenario_.image.pixel_size_um;
  const auto& bystander = scenario_.bystander;
  const float grain_depth = static_cast<float>(0.15 * scenario_.optics.contrast * scenario_.optics.granularity);
  auto draw_disc = [&](const Eigen::Vector2d& center_um, double radius_um, double reach_um, auto&& transmittance) {
    if (radius_um <= 0) return;
    const Eigen::Vector2d center = stage.place(center_um) / pixel_um;
    const double reach = (radius_um + reach_um) / pixel_um;
    for (int y = std::max(0, static_cast<int>(center.y() - reach));
         y <= std::min(light_.rows - 1, static_cast<int>(center.y() + reach)); ++y)
      for (int x = std::max(0, static_cast<int>(center.x() - reach));
           x <= std::min(light_.cols - 1, static_cast<int>(center.x() + reach)); ++x) {
        const Eigen::Vector2d from = pixel_um * (Eigen::Vector2d(x, y) - center);
        light_(y, x) *= transmittance(from, static_cast<float>(from.norm() - radius_um));
      }
  };
  // Both membranes as thick as the specimen's own.
  const auto zona_um = static_cast<float>(rim_.wall_radius_um);
  draw_disc({bystander.cell_x_um, bystander.cell_y_um}, bystander.cell_radius_um, kBand_um,
            [&](const Eigen::Vector2d& from, float distance) {
              const float inner = distance + zona_um, inside = ooplasm_weight_(inner);
              const auto x = static_cast<float>(from.x()), y = static_cast<float>(from.y());
              return outer_edge_(distance) * inner_edge_(inner) * (1 + inside * grain_depth * mottling_.at(y, -x));
            });
  draw_disc({bystander.bubble_x_um, bystander.bubble_y_um}, bystander.bubble_radius_um,
            0.5 * bystander.bubble_radius_um + kBand_um,
            [&](const Eigen::Vector2d&, float distance) { return bubble_edge_(distance); });
}

// Particles on the membrane, in focus, and those that float across.
void Renderer::draw_particles(const SpecimenState& state, double time_s) {
  const double pixel_um = scenario_.image.pixel_size_um;
  const auto& debris = scenario_.debris;
  for (const double angle : touching_angle_rad_) {
    const Eigen::Vector2d place = pose_.to_image(touching_place_um(state.section.outer_um, section_angle_rad_, angle,
                                                                   debris.touching_radius_um)) /
                                  pixel_um;
    draw_particle(light_, place.x(), place.y(),
                  {debris.touching_radius_um, 0.30 * scenario_.optics.contrast,
                   std::max(0.3 * debris.touching_radius_um, 0.5 * pixel_um)},
                  pixel_um);
  }
  for (const PassingParticle& p : passing_) {
    const Eigen::Vector2d place = passing_place_px(p, debris, time_s, light_.size(), pixel_um);
    draw_particle(light_, place.x(), place.y(), p.particle, pixel_um);
  }
}

void Renderer::draw_holder(const HolderPose& holder, const Eigen::Vector2d& center_um) {
  const double pixel_um = scenario_.image.pixel_size_um;
  const Eigen::Vector2d along = holder.direction, across(-along.y(), along.x());
  Strip strip{(center_um + rim_.distance_um * along) / pixel_um, along, across,
              (rim_.ring_radius_um + rim_.wall_radius_um + kBand_um) / pixel_um,
              -(rim_.wall_radius_um + kBand_um) / pixel_um};
  const auto ring = static_cast<float>(rim_.ring_radius_um), wall = static_cast<float>(rim_.wall_radius_um);
  for (int y = 0, first, last; y < light_.rows; ++y) {
    if (!strip.columns(y, light_.cols, first, last)) continue;
    float* light = light_[y];
    for (int x = first; x <= last; ++x) {
      const Eigen::Vector2d from = pixel_um * (Eigen::Vector2d(x, y) - strip.origin);
      // Distance to the middle line of the nearer wall, which begins at the rim.
      const auto back = static_cast<float>(from.dot(along));
      const float side = std::abs(static_cast<float>(from.dot(across))) - ring;
      const float middle = back >= 0 ? std::abs(side) : std::sqrt(back * back + side * side);
      light[x] *= holder_edge_(middle - wall);
    }
  }
}

// What the needle left in the cell: clear spheres that refract, a dark rim about a bright middle.
void Renderer::draw_droplets(const Truth& truth) {
  const double pixel_um = scenario_.image.pixel_size_um;
  for (const Droplet& droplet : truth.droplets) {
    const double radius_um = droplet.radius_um(), reach = (radius_um + kBand_um) / pixel_um;
    const double at_x = droplet.center_um.x / pixel_um, at_y = droplet.center_um.y / pixel_um;
    for (int y = std::max(0, static_cast<int>(at_y - reach));
         y <= std::min(light_.rows - 1, static_cast<int>(at_y + reach)); ++y)
      for (int x = std::max(0, static_cast<int>(at_x - reach));
           x <= std::min(light_.cols - 1, static_cast<int>(at_x + reach)); ++x) {
        const double distance_um = pixel_um * std::hypot(x - at_x, y - at_y) - radius_um;
        light_(y, x) *= droplet_edge_(static_cast<float>(distance_um));
      }
  }
}

void Renderer::draw_needle(const NeedlePose& needle, double out_of_plane_um) {
  // Out of the plane it blurs as the objective's aperture says, about a quarter of the way.
  if (std::abs(out_of_plane_um - needle_edge_out_of_plane_um_) > 0.2) {
    Scenario blurred = scenario_;
    blurred.optics.needle_defocus_um = std::hypot(scenario_.optics.needle_defocus_um, 0.25 * out_of_plane_um);
    needle_edge_ = make_needle_edge(blurred);
    needle_edge_out_of_plane_um_ = out_of_plane_um;
  }
  const double pixel_um = scenario_.image.pixel_size_um;
  const Eigen::Vector2d along = -needle.direction, across(-along.y(), along.x());
  const auto& tools = scenario_.tools;
  Strip strip{needle.tip_um / pixel_um, along, across, (tools.needle_shaft_radius_um + kBand_um) / pixel_um,
              -kBand_um / pixel_um};
  const auto tip = static_cast<float>(tools.needle_tip_radius_um);
  const auto slope = static_cast<float>(std::tan(tools.needle_taper_deg * std::numbers::pi / 180));
  const float cosine = 1 / std::sqrt(1 + slope * slope);
  for (int y = 0, first, last; y < light_.rows; ++y) {
    if (!strip.columns(y, light_.cols, first, last)) continue;
    float* light = light_[y];
    for (int x = first; x <= last; ++x) {
      const Eigen::Vector2d from = pixel_um * (Eigen::Vector2d(x, y) - strip.origin);
      const float back = static_cast<float>(from.dot(along)) - tip,
                  side = std::abs(static_cast<float>(from.dot(across)));
      // The round tip, then the cone and the shaft.
      const float distance = back < 0 ? std::sqrt(back * back + side * side) - tip
                                      : cosine * (side - static_cast<float>(needle_half_width_um(tools, back + tip)));
      light[x] *= needle_edge_(distance);
    }
  }
}

template <class Pixel>
void Renderer::count_light(long frame_index, float lamp) {
  constexpr float kFull = std::numeric_limits<Pixel>::max();
  const auto& optics = scenario_.optics;
  const float shot = static_cast<float>(1 / optics.full_well_electrons);
  const auto read = static_cast<float>(std::pow(optics.read_noise_electrons / optics.full_well_electrons, 2));
  // Row by row: counted first, then turned into whole numbers, so that both loops use the machine's vectors.
  const int width = light_.cols;
  counted_.resize(static_cast<std::size_t>(width));
  float* const counted = counted_.data();
  for (int y = 0; y < light_.rows; ++y) {
    const float* light = light_[y];
    auto* pixel = frame_.ptr<Pixel>(y);
    if (optics.noise) {
      // Shot noise has the square root of the light, read noise is the same everywhere.
      const float* noise = noise_.row(frame_index, y);
      for (int x = 0; x < width; ++x) {
        const float lit = lamp * light[x], positive = lit > 0.0f ? lit : 0.0f;
        counted[x] = lit + noise[x] * std::sqrt(positive * shot + read);
      }
    } else {
      for (int x = 0; x < width; ++x) counted[x] = lamp * light[x];
    }
    for (int x = 0; x < width; ++x) {
      const float positive = counted[x] > 0.0f ? counted[x] : 0.0f, full = positive < 1.0f ? positive : 1.0f;
      pixel[x] = static_cast<Pixel>(static_cast<int>(full * kFull + 0.5f));
    }
  }
}

}  // namespace pellucida
