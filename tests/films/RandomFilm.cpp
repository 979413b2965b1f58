#include "films/RandomFilm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldJson.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/microscopy/SeededNumbers.h"
#include "pellucida/simulation/CellReference.h"
#include "pellucida/simulation/NeedleScript.h"
#include "pellucida/simulation/VirtualMicroscope.h"

namespace pellucida::test {
namespace {

using Json = nlohmann::ordered_json;

const Json& families_file() {
  static const Json file = read_json_object(PELLUCIDA_SOURCE_DIR "/tests/films/families.json");
  return file;
}

// By their place in Split.
constexpr std::array<const char*, 4> kSplitNames{"tuning", "validation", "wide", "unseen"};
// Between the dice of a seed of the first two and of the last two.
constexpr std::uint64_t kFurtherSeeds = 1ULL << 40;

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(mix(seed)) {}
  double between(double low, double high) { return low + (high - low) * uniform(engine_); }
  double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  bool chance(double share) { return uniform(engine_) < share; }
  std::size_t index(std::size_t count) {
    return static_cast<std::size_t>(uniform(engine_) * static_cast<double>(count));
  }
  template <class Value>
  const Value& one_of(const std::vector<Value>& values) {
    return values[index(values.size())];
  }

 private:
  std::mt19937_64 engine_;
};

// Sets one key of a look or a scenario by what the file says of it.
void draw_key(const std::string& key, const Json& choice, const FieldList& look, const FieldList& scenario,
              Dice& dice) {
  const bool in_look = key.starts_with("look.");
  const FieldPlace* place = in_look ? look.find(key.substr(5)) : scenario.find(key.substr(key.find('.') + 1));
  if (!place || !choice.is_array() || choice.empty()) throw InputError("families.json: " + key + " can't be drawn");
  if (choice[0].is_number()) {
    const double low = choice[0], high = choice[1];
    const double value = choice.size() > 2 ? dice.log_between(low, high) : dice.between(low, high);
    if (auto* const* number = std::get_if<double*>(&place->value))
      **number = value;
    else
      **std::get_if<int*>(&place->value) = static_cast<int>(std::lround(value));
    return;
  }
  const Json& one = choice[dice.index(choice.size())];
  if (one.is_boolean())
    **std::get_if<bool*>(&place->value) = one;
  else
    **std::get_if<std::string*>(&place->value) = one;
}

struct Size {
  int width_px, height_px;
};

// The picture, and in it the cell: as large as the camera and the pixel allow, whole in view.
void draw_picture(Scenario& s, double radius_um, int widest_px, Dice& dice) {
  std::vector<Size> sizes{{640, 480}, {728, 486}, {800, 600}, {1024, 768}, {1280, 960}, {1600, 1200}, {2048, 1536}};
  std::erase_if(sizes, [&](const Size& size) { return size.width_px > widest_px; });
  // Small pictures are more frequent: the place of a size is the smaller one of two draws.
  const Size size = sizes[std::min(dice.index(sizes.size()), dice.index(sizes.size()))];
  s.image.width_px = size.width_px;
  s.image.height_px = size.height_px;
  const double largest_px = std::min({500.0, 0.55 * size.height_px, 2 * radius_um / 0.2});
  const double diameter_px = dice.log_between(std::max(60.0, 2 * radius_um / 2.0), largest_px);
  s.image.pixel_size_um = 2 * radius_um / diameter_px;
  const double free_x = std::max(0.0, size.width_px - 1.6 * diameter_px),
               free_y = std::max(0.0, size.height_px - 1.6 * diameter_px);
  s.cell.center_x_um = s.image.pixel_size_um * (0.5 * size.width_px + 0.35 * free_x * dice.between(-1, 1));
  s.cell.center_y_um = s.image.pixel_size_um * (0.5 * size.height_px + 0.35 * free_y * dice.between(-1, 1));
  // Bystanders beside the cell, not on it.
  const double angle = dice.between(0, 2 * std::numbers::pi), away_um = (2.2 + dice.between(0, 0.8)) * radius_um + 15;
  s.bystander.cell_x_um = s.cell.center_x_um + away_um * std::cos(angle);
  s.bystander.cell_y_um = s.cell.center_y_um + away_um * std::sin(angle);
  s.bystander.bubble_x_um = s.image.pixel_size_um * size.width_px * dice.between(0.1, 0.9);
  s.bystander.bubble_y_um = s.image.pixel_size_um * size.height_px * dice.between(0.1, 0.9);
}

// What the needle does, at speeds of up to 5 px a frame.
void draw_motion(Scenario& s, Dice& dice) {
  const double scale = s.cell.size_scale, pixel_um = s.image.pixel_size_um;
  const int frame_count = 30 + static_cast<int>(dice.index(31));
  const double budget_um = frame_count * dice.between(2.0, 5.0) * pixel_um;
  const double deepest_um =
      scale * 0.98 * CellReference::load(s.cell.reference, s.tools.configuration).max_indentation_um();
  Scenario::Motion& motion = s.motion;
  const bool stays_free = dice.chance(0.12);
  motion.gap_um = std::min(dice.between(2.0, 20.0), (stays_free ? 0.9 : 0.35) * budget_um);
  motion.smoothing_s = 0.1;
  motion.hold_s = dice.between(0.1, 0.5);
  const double left_um = std::max(1.0, budget_um - motion.gap_um);
  motion.indentation_um =
      stays_free ? 0.0 : std::min(deepest_um * dice.between(0.25, 1.0), left_um * dice.between(0.5, 1.0));
  const bool punctures = !stays_free && dice.chance(0.25);
  if (punctures) {
    s.puncture.enabled = true;
    s.puncture.indentation_um = std::max(1.0, motion.indentation_um * dice.between(0.5, 0.85));
    s.puncture.residual_um = dice.between(0, 3);
  }
  const bool retracts = dice.chance(0.5);
  const double way_um =
      motion.gap_um + motion.indentation_um + (retracts ? motion.gap_um + motion.indentation_um : 0.0);
  const double moving_s = frame_count / 30.0 * 0.85, speed = std::clamp(way_um / moving_s, 1.0, 200.0);
  motion.approach_speed_um_per_s = motion.indentation_speed_um_per_s = speed;
  motion.retraction_speed_um_per_s = retracts ? speed : 0.0;
  // A needle at rest now and then moves in depth.
  if (!retracts && dice.chance(0.2)) {
    motion.out_of_plane_um = dice.between(5, 30) * (dice.chance(0.5) ? 1 : -1);
    motion.hold_s = 0.6;
    motion.out_of_plane_time_s = NeedleScript(motion).duration_s() - 0.5;
  }
  const double duration_s = NeedleScript(motion).duration_s();
  s.image.frame_rate_hz = std::clamp(frame_count / duration_s, 1.0, 1000.0);
  s.image.duration_s = (frame_count - 0.5) / s.image.frame_rate_hz;
  if (dice.chance(0.3)) {
    s.drift.x_um_per_s = std::clamp(dice.between(-0.5, 0.5) * pixel_um * s.image.frame_rate_hz, -50.0, 50.0);
    s.drift.y_um_per_s = std::clamp(dice.between(-0.5, 0.5) * pixel_um * s.image.frame_rate_hz, -50.0, 50.0);
  }
}

}  // namespace

Split split_of(const std::string& word) {
  for (std::size_t i = 0; i < kSplitNames.size(); ++i)
    if (word == kSplitNames[i]) return static_cast<Split>(i);
  throw UsageError("families are 'tuning', 'validation', 'wide' or 'unseen', not '" + word + "'");
}

std::vector<std::string> specimens_in(const std::string& folder) {
  constexpr std::string_view kEnding = "-geometry.json";
  std::vector<std::string> specimens;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string file = entry.path().string();
    if (file.ends_with(kEnding)) specimens.push_back(file.substr(0, file.size() - kEnding.size()));
  }
  if (specimens.empty()) throw UsageError(folder + " holds no finite-element tables (*-geometry.json)");
  std::sort(specimens.begin(), specimens.end());
  return specimens;
}

RandomFilm draw_film(Split split, std::uint64_t seed, int widest_px, const std::vector<std::string>& specimens) {
  const auto which = static_cast<std::size_t>(split);
  const bool is_further = split == Split::kWide || split == Split::kUnseen;
  Dice dice(seed * 2 + which % 2 + (is_further ? kFurtherSeeds : 0));
  RandomFilm film;
  film.seed = seed;
  const Json& families = families_file()[kSplitNames[which]];
  int weight_sum = 0;
  for (const Json& family : families) weight_sum += family["weight"].get<int>();
  auto place = static_cast<int>(dice.index(static_cast<std::size_t>(weight_sum)));
  const Json* chosen = nullptr;
  for (const Json& family : families) {
    chosen = &family;
    place -= family["weight"].get<int>();
    if (place < 0) break;
  }
  film.family = (*chosen)["name"];
  film.contrast = (*chosen)["contrast"];

  const FieldList look = fields_of(film.look), scenario = fields_of(film.scenario);
  std::vector<const Json*> draws{&families_file()["common"], &(*chosen)["draw"]};
  if (is_further) draws.insert(draws.begin() + 1, &families_file()["further"]);
  for (const Json* some : draws)
    for (const auto& [key, choice] : some->items()) draw_key(key, choice, look, scenario, dice);

  Scenario& s = film.scenario;
  s.name = film.look.name = film.family + '-' + std::to_string(seed);
  s.seed = seed;
  s.cell.reference = dice.one_of(reference_cells());
  s.tools.configuration = 1 + static_cast<int>(dice.index(4));
  s.tools.holder_angle_deg = dice.between(0, 360);
  s.tools.mirrored = dice.chance(0.5);
  if (!specimens.empty()) {
    s.cell.reference = specimens[dice.index(specimens.size())];
    s.tools.configuration = 1;
    s.tools.needle_tip_radius_um = 0.0;  // as the mechanics has it
  }
  s.tools.needle_shaft_radius_um = std::max(s.tools.needle_shaft_radius_um, s.tools.needle_tip_radius_um + 0.5);
  const double radius_um = dice.between(35, 65);
  s.cell.size_scale = radius_um / CellReference::load(s.cell.reference, s.tools.configuration).outer_radius_um();
  if (film.look.cell.polar_body_radius_um < 2) film.look.cell.polar_body_radius_um = 0;
  draw_picture(s, radius_um, widest_px, dice);
  draw_motion(s, dice);
  return film;
}

long first_frame_in(const RandomFilm& film, CellState state) {
  VirtualMicroscope microscope(film.scenario);
  const long frames = *microscope.info().frame_count;
  for (long k = 0; k < frames; ++k) {
    microscope.skip();
    if (microscope.truth().observation.state == state) return k;
  }
  return frames;
}

}  // namespace pellucida::test
