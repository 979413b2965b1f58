// A developer's tool, not installed and no test: runs random films through tracker and force observer and prints what
// came of it, by contrast and together.
//   film_report --split tuning|validation|wide|unseen [--count N] [--first SEED] [--film SEED] [--jobs N] [--widest PX]
//               [--family NAME] [--punctures] [--specimens FOLDER] [--each-once] [--relaxing] [--drawing] [--commanded]
//               [--detection auto|lines|scene] [--quality live|high]
//               [--csv FILE] [--sights FILE] [--worst FOLDER] [--sheets FOLDER] [--frames]
// "found": frames of films with a cell in which one is reported; "clear": frames of films without one in which none is.
// Force: "tracking", what was seen held against what the true contours and tip give by the same model; "pushed", the
// same over the frames alone in which the needle pushes and a force is given: a puncture that is reported a frame late,
// or a frame without a force, is not in it; "whole", against the true force (which fits the picture with --specimens
// alone: finite-element tables, tests/specimens; a further line then says how the profile's own thickness, tip and
// holder would have done, and a table goes by what the specimens are). --each-once: with specimens, one film of each,
// in turn, of those in which the needle touches. --relaxing: the force relaxes by a law of three arms, under a profile
// of two.
// --commanded: the tracker receives the reports of a manipulator with errors of its own (`FilmManipulator`).
// --drawing: plain bright field. --film: that one film alone. --family: films of that family alone. --punctures: films
// whose membrane gives way alone, for how soon that is reported. --widest: no wider pictures. --csv:
// a row a film. "given": frames in contact with a force; "in 95 %": of these, those whose picture's interval holds the
// true force (with --specimens) or the one that the true contours and tip give. --sights: a row a frame, of what the
// verdict on a puncture saw and of the force. --worst: pictures of the ten worst films, truth green, found red.
// --sheets: nine pictures of each film. --frames: also a line a frame.
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <opencv2/core/utility.hpp>
#include <string>
#include <thread>

#include "films/FilmRun.h"
#include "films/SpecimenTable.h"
#include "pellucida/core/Error.h"

namespace {

using namespace pellucida;
using test::FilmRun;
using test::FrameError;

struct Choice {
  test::Split split = test::Split::kTuning;
  std::uint64_t first = 1, count = 60;
  int jobs = 1, widest_px = 2048;
  std::string csv, sights, worst, sheets, family;
  std::vector<std::string> specimens;
  bool frames = false, drawing = false, each_once = false, relaxing = false, punctures = false, commanded = false;
  TrackerOptions tracker;
};

Choice read_arguments(int count, char** arguments) {
  Choice choice;
  bool has_split = false;
  for (int i = 1; i < count; ++i) {
    const std::string word = arguments[i];
    const auto value = [&]() -> std::string {
      if (i + 1 < count) return arguments[++i];
      throw UsageError(word + " needs a value");
    };
    if (word == "--split") {
      choice.split = test::split_of(value());
      has_split = true;
    } else if (word == "--count") {
      choice.count = std::stoull(value());
    } else if (word == "--first") {
      choice.first = std::stoull(value());
    } else if (word == "--film") {
      choice.first = std::stoull(value());
      choice.count = 1;
    } else if (word == "--jobs") {
      choice.jobs = std::max(1, std::stoi(value()));
    } else if (word == "--widest") {
      choice.widest_px = std::stoi(value());
    } else if (word == "--csv") {
      choice.csv = value();
    } else if (word == "--sights") {
      choice.sights = value();
    } else if (word == "--family") {
      choice.family = value();
    } else if (word == "--specimens") {
      choice.specimens = test::specimens_in(value());
    } else if (word == "--worst") {
      choice.worst = value();
    } else if (word == "--sheets") {
      choice.sheets = value();
    } else if (word == "--detection") {
      const std::string detection = value();
      const auto known = detection_from_string(detection);
      if (!known) throw UsageError("--detection is auto, lines or scene");
      choice.tracker.detection = *known;
    } else if (word == "--quality") {
      const std::string quality = value();
      if (quality != "live" && quality != "high") throw UsageError("--quality is live or high");
      if (quality == "high") choice.tracker.quality = TrackerOptions::Quality::kHigh;
    } else if (word == "--each-once") {
      choice.each_once = true;
    } else if (word == "--relaxing") {
      choice.relaxing = true;
    } else if (word == "--punctures") {
      choice.punctures = true;
    } else if (word == "--commanded") {
      choice.commanded = true;
    } else if (word == "--drawing") {
      choice.drawing = true;
    } else if (word == "--frames") {
      choice.frames = true;
    } else {
      throw UsageError("unknown argument " + word);
    }
  }
  if (choice.each_once && choice.specimens.empty()) throw UsageError("--each-once needs --specimens");
  if (!has_split) throw UsageError("--split is missing: tuning, validation, wide or unseen");
  return choice;
}

// The values of one error that were measured.
void collect(const std::vector<FrameError>& errors, double FrameError::*member, std::vector<double>& values) {
  for (const FrameError& error : errors)
    if (error.*member >= 0) values.push_back(error.*member);
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return -1.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

std::string percent(double part, double whole) {
  char text[16];
  std::snprintf(text, sizeof text, whole > 0 ? "%.1f" : "-", 100.0 * part / std::max(whole, 1.0));
  return text;
}

// The same as text; nothing measured is no number.
std::string quantile_text(const std::vector<double>& values, double share, int decimals) {
  char text[16];
  std::snprintf(text, sizeof text, "%.*f", decimals, quantile(values, share));
  return values.empty() ? "-" : text;
}

void print_head() {
  std::printf(
      "%-13s %5s %6s %6s %6s | %6s %6s %6s | %6s %6s | %6s %7s %7s | %8s %8s %8s | %8s %6s %6s %6s %6s %6s %6s %5s | "
      "%5s\n",
      "", "", "", "found", "clear", "outer", "px", "", "inner", "px", "tip", "px", "", "sure and", "false p.", "punct.",
      "force: %", "RMS,", "pushed", "", "whole", "", "given", "in", "ms");
  std::printf(
      "%-13s %5s %6s %6s %6s | %6s %6s %6s | %6s %6s | %6s %7s %7s | %8s %8s %8s | %8s %6s %6s %6s %6s %6s %6s %5s | "
      "%5s\n",
      "contrast", "films", "frames", "% cell", "% none", "median", "95 %", "99 %", "median", "95 %", "found%", "median",
      "95 %", "wrong/1e3", "/1e4", "seen", "tracking", "95 %", "median", "95 %", "median", "95 %", "%", "95%", "frame");
}

void print_row(const std::string& name, const std::vector<const FilmRun*>& runs) {
  std::vector<double> outer, inner, tip, tracking, pushed, force, frame_ms;
  double frames = 0, cell_frames = 0, found = 0, none_frames = 0, none_found = 0, bold = 0, contact = 0,
         false_count = 0, measured = 0, covered = 0;
  int punctures = 0, seen = 0;
  for (const FilmRun* run : runs) {
    const auto count = static_cast<double>(run->errors.size());
    frames += count;
    (run->has_cell ? cell_frames : none_frames) += count;
    (run->has_cell ? found : none_found) += run->found_count;
    bold += run->confident_and_wrong_count;
    contact += run->contact_count;
    false_count += run->false_puncture_count;
    measured += run->measured_count;
    covered += run->covered_count;
    punctures += run->punctures ? 1 : 0;
    seen += run->puncture_delay && *run->puncture_delay <= 2 ? 1 : 0;
    frame_ms.push_back(run->median_frame_ms);
    if (!run->has_cell) continue;
    collect(run->errors, &FrameError::outer_px, outer);
    collect(run->errors, &FrameError::inner_px, inner);
    collect(run->errors, &FrameError::tip_px, tip);
    if (run->force_rms_percent >= 0) force.push_back(run->force_rms_percent);
    if (run->tracking_force_rms_percent >= 0) tracking.push_back(run->tracking_force_rms_percent);
    if (run->pushed_force_rms_percent >= 0) pushed.push_back(run->pushed_force_rms_percent);
  }
  std::printf(
      "%-13s %5zu %6.0f %6s %6s | %6s %6s %6s | %6s %6s | %6s %7s %7s | %8.1f %8.0f %4d/%-3d | %8s %6s "
      "%6s %6s %6s %6s %6s %5s | %5.1f\n",
      name.c_str(), runs.size(), frames, percent(found, cell_frames).c_str(),
      percent(none_frames - none_found, none_frames).c_str(), quantile_text(outer, 0.5, 2).c_str(),
      quantile_text(outer, 0.95, 2).c_str(), quantile_text(outer, 0.99, 2).c_str(),
      quantile_text(inner, 0.5, 2).c_str(), quantile_text(inner, 0.95, 2).c_str(),
      percent(static_cast<double>(tip.size()), cell_frames).c_str(), quantile_text(tip, 0.5, 2).c_str(),
      quantile_text(tip, 0.95, 2).c_str(), 1e3 * bold / std::max(frames, 1.0),
      1e4 * false_count / std::max(contact, 1.0), seen, punctures, quantile_text(tracking, 0.5, 1).c_str(),
      quantile_text(tracking, 0.95, 1).c_str(), quantile_text(pushed, 0.5, 1).c_str(),
      quantile_text(pushed, 0.95, 1).c_str(), quantile_text(force, 0.5, 1).c_str(),
      quantile_text(force, 0.95, 1).c_str(), percent(measured, contact).c_str(), percent(covered, measured).c_str(),
      quantile(frame_ms, 0.5));
}

// Whole force of the geometry that was seen, beside that of the profile's own.
void print_by_profile(const std::vector<FilmRun>& runs) {
  std::vector<double> seen, own;
  for (const FilmRun& run : runs) {
    if (run.profile_force_rms_percent < 0) continue;
    seen.push_back(run.force_rms_percent);
    own.push_back(run.profile_force_rms_percent);
  }
  std::printf(
      "force RMS, %% of peak, %zu films: by the geometry seen %.1f (95 %%: %.1f), by the profile's own %.1f (%.1f)\n",
      seen.size(), quantile(seen, 0.5), quantile(seen, 0.95), quantile(own, 0.5), quantile(own, 0.95));
}

void write_csv(const std::string& file, const std::vector<FilmRun>& runs) {
  std::ofstream out(file);
  out << "seed,family,contrast,width_px,height_px,pixel_size_um,cell_diameter_px,frames,found,contact,false_punctures,"
         "punctures,puncture_delay,outer_median_px,outer_p95_px,inner_median_px,tip_found,tip_median_px,tip_p95_px,"
         "confident_and_wrong,tracking_force_rms_percent,pushed_force_rms_percent,force_rms_percent,measured,covered,"
         "median_frame_ms,worst_frame,"
         "badness,specimen,profile_force_rms_percent,radius_um,thickness_um,tip_radius_um,holder_radius_um,"
         "true_radius_um,true_thickness_um,true_tip_radius_um,true_holder_radius_um,given_percent,bias_percent,"
         "palpated_percent,in_whole,in_wide,true_sight_percent,deepest_ratio,aspect,suction_kPa,stiffening,angle_deg,"
         "offset_um,thickness_sigma_um\n";
  for (const FilmRun& run : runs) {
    std::vector<double> outer, inner, tip;
    collect(run.errors, &FrameError::outer_px, outer);
    collect(run.errors, &FrameError::inner_px, inner);
    collect(run.errors, &FrameError::tip_px, tip);
    const auto& image = run.film.scenario.image;
    out << run.film.seed << ',' << run.film.family << ',' << run.film.contrast << ',' << image.width_px << ','
        << image.height_px << ',' << image.pixel_size_um << ','
        << (2.0 * run.true_sizes.radius_um + run.true_sizes.thickness_um) / image.pixel_size_um << ','
        << run.errors.size() << ',' << run.found_count << ',' << run.contact_count << ',' << run.false_puncture_count
        << ',' << run.punctures << ',' << (run.puncture_delay ? std::to_string(*run.puncture_delay) : "") << ','
        << quantile(outer, 0.5) << ',' << quantile(outer, 0.95) << ',' << quantile(inner, 0.5) << ',' << tip.size()
        << ',' << quantile(tip, 0.5) << ',' << quantile(tip, 0.95) << ',' << run.confident_and_wrong_count << ','
        << run.tracking_force_rms_percent << ',' << run.pushed_force_rms_percent << ',' << run.force_rms_percent << ','
        << run.measured_count << ',' << run.covered_count << ',' << run.median_frame_ms << ',' << run.worst.frame_index
        << ',' << run.badness << ',' << std::filesystem::path(run.film.scenario.cell.reference).filename().string()
        << ',' << run.profile_force_rms_percent;
    for (const test::FilmSizes* sizes : {&run.seen_sizes, &run.true_sizes})
      out << ',' << sizes->radius_um << ',' << sizes->thickness_um << ',' << sizes->tip_radius_um << ','
          << sizes->holder_radius_um;
    const test::SpecimenResult r = run.specimen.value_or(test::SpecimenResult{});
    out << ',' << r.given_percent << ',' << r.bias_percent << ',' << r.palpated_percent << ',' << r.in_whole << ','
        << r.in_wide << ',' << run.true_sight_percent << ',' << r.deepest_ratio << ',' << r.specimen.aspect_ratio << ','
        << r.specimen.suction_kPa << ',' << r.specimen.stiffening << ',' << r.specimen.holder_angle_deg << ','
        << r.specimen.offset_um << ',' << run.seen_sizes.thickness_sigma_um;
    out << '\n';
  }
  if (!out.flush()) throw OutputError(file + " can't be written");
}

void write_sights(const std::string& file, const std::vector<FilmRun>& runs) {
  std::ofstream out(file);
  out << "seed,frame,truth,tracked,judged,is_doubted,confidence,has_needle,needle_confidence,tip_um,tip_sigma_um,"
         "membrane_um,membrane_sigma_um,depth_um,true_tip_um,true_membrane_um,residual_um,dimple_residual_um,noise_um,"
         "flank_um,side_um,rest_radius_um,outer_px,tip_px,pixel_size_um,force_uN,lower_uN,upper_uN,expected_uN,"
         "true_uN,stiffening_effect,stiffening_effect_sigma,sizes_ratio,center_ahead_um,outer_sigma_um,pierced\n";
  for (const FilmRun& run : runs) {
    for (std::size_t k = 0; k < run.sights.size(); ++k) {
      const test::FrameSight& s = run.sights[k];
      out << run.film.seed << ',' << k << ',' << to_string(s.truth) << ',' << to_string(s.tracked) << ','
          << to_string(s.judged) << ',' << s.is_doubted << ',' << s.confidence << ',' << s.has_needle << ','
          << s.needle_confidence << ',' << s.tip_um << ',' << s.tip_sigma_um << ',' << s.membrane_um << ','
          << s.membrane_sigma_um << ',' << s.depth_um << ',' << s.true_tip_um << ',' << s.true_membrane_um << ','
          << s.residual_um << ',' << s.dimple_residual_um << ',' << s.noise_um << ',' << s.flank_um << ',' << s.side_um
          << ',' << s.rest_radius_um << ',' << run.errors[k].outer_px << ',' << run.errors[k].tip_px << ','
          << run.film.scenario.image.pixel_size_um << ',' << s.force_uN << ',' << s.lower_uN << ',' << s.upper_uN << ','
          << s.expected_uN << ',' << s.true_uN << ',' << s.stiffening_effect << ',' << s.stiffening_effect_sigma << ','
          << s.sizes_ratio << ',' << s.center_ahead_um << ',' << s.outer_sigma_um << ',' << s.pierced_probability
          << '\n';
    }
  }
  if (!out.flush()) throw OutputError(file + " can't be written");
}

void print_frames(const FilmRun& run) {
  for (std::size_t k = 0; k < run.errors.size(); ++k) {
    const FrameError& e = run.errors[k];
    std::printf("%4llu %3zu %-9s true %-9s conf %.2f outer %6.2f inner %6.2f tip %7.2f px depth %+6.2f of %5.2f um%s\n",
                static_cast<unsigned long long>(run.film.seed), k, std::string(to_string(e.state)).c_str(),
                std::string(to_string(e.true_state)).c_str(), e.confidence, e.outer_px, e.inner_px, e.tip_px,
                e.indentation_um, e.true_indentation_um, run.is_confident_and_wrong(e) ? "  SURE AND WRONG" : "");
  }
}

void draw_worst_ten(const std::string& folder, const std::vector<FilmRun>& runs) {
  std::filesystem::create_directories(folder);
  std::vector<const FilmRun*> ranked;
  for (const FilmRun& run : runs) ranked.push_back(&run);
  std::sort(ranked.begin(), ranked.end(), [](const auto* a, const auto* b) { return a->badness > b->badness; });
  ranked.resize(std::min<std::size_t>(10, ranked.size()));
  for (std::size_t k = 0; k < ranked.size(); ++k) {
    char name[64];
    std::snprintf(name, sizeof name, "%02zu_film_%llu_frame_%ld.png", k + 1,
                  static_cast<unsigned long long>(ranked[k]->film.seed), ranked[k]->worst.frame_index);
    draw_worst(*ranked[k], folder + '/' + name);
    std::printf("worst %2zu: film %llu, %s, badness %.0f\n", k + 1,
                static_cast<unsigned long long>(ranked[k]->film.seed), ranked[k]->film.family.c_str(),
                ranked[k]->badness);
  }
}

void draw_sheets(const std::string& folder, const std::vector<FilmRun>& runs) {
  std::filesystem::create_directories(folder);
  for (const FilmRun& run : runs) draw_sheet(run, folder + "/film_" + std::to_string(run.film.seed) + ".png");
}

// The next so many seeds whose films are wanted.
std::vector<std::uint64_t> seeds_of(const Choice& choice) {
  constexpr std::uint64_t kMostPerFilm = 1000;  // no family is as rare as that
  std::vector<std::uint64_t> seeds;
  const std::size_t count =
      choice.each_once ? std::min<std::size_t>(choice.count, choice.specimens.size()) : choice.count;
  for (std::uint64_t seed = choice.first; seeds.size() < count; ++seed) {
    const std::vector<std::string> any = choice.each_once ? std::vector{choice.specimens.front()} : choice.specimens;
    const test::RandomFilm film = test::draw_film(choice.split, seed, choice.widest_px, any);
    const bool touches = film.scenario.cell.in_view && film.scenario.motion.indentation_um > 0.0;
    const bool punctures = touches && film.scenario.puncture.enabled;
    if ((choice.family.empty() || film.family == choice.family) && (touches || !choice.each_once) &&
        (punctures || !choice.punctures))
      seeds.push_back(seed);
    if (seed - choice.first > kMostPerFilm * choice.count)
      throw UsageError("--family, --punctures: this split has no such film of \"" + choice.family + '"');
  }
  return seeds;
}

void report(const Choice& choice) {
  const std::vector<std::uint64_t> seeds = seeds_of(choice);
  std::vector<FilmRun> runs(seeds.size());
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::atomic<bool> failed{false};
  const auto work = [&] {
    for (std::size_t k; !failed && (k = next++) < runs.size();) {
      try {
        const std::vector<std::string> specimens =
            choice.each_once ? std::vector{choice.specimens[k]} : choice.specimens;
        test::RandomFilm film = test::draw_film(choice.split, seeds[k], choice.widest_px, specimens);
        film.drawing = choice.drawing;
        film.relaxes = choice.relaxing;
        runs[k] = test::run_film(film, choice.tracker, choice.commanded);
      } catch (...) {
        if (!failed.exchange(true)) failure = std::current_exception();
      }
    }
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < choice.jobs; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);

  if (choice.frames)
    for (const FilmRun& run : runs) print_frames(run);
  std::map<std::string, std::vector<const FilmRun*>> by_contrast;
  std::vector<const FilmRun*> all;
  for (const FilmRun& run : runs) {
    by_contrast[run.film.contrast].push_back(&run);
    all.push_back(&run);
  }
  print_head();
  for (const auto& [contrast, some] : by_contrast) print_row(contrast, some);
  print_row("ALL", all);
  if (!choice.specimens.empty()) {
    print_by_profile(runs);
    test::print_by_specimen(runs);
  }
  if (!choice.csv.empty()) write_csv(choice.csv, runs);
  if (!choice.sights.empty()) write_sights(choice.sights, runs);
  if (!choice.worst.empty()) draw_worst_ten(choice.worst, runs);
  if (!choice.sheets.empty()) draw_sheets(choice.sheets, runs);
}

}  // namespace

int main(int count, char** arguments) {
  try {
    cv::setNumThreads(1);
    report(read_arguments(count, arguments));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "film_report: %s\n", error.what());
    return 1;
  }
  return 0;
}
