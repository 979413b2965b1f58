// A developer's tool, not installed and no test: runs the tracker over the grid of conditions (GridConditions.cpp) and
// prints a row a condition, then all of them together.
//   tracking_grid [--threads N] [--only TEXT] [--representative] [--csv FILE] [--frames FILE] [--draw PREFIX] [--list]
// --only: conditions whose name contains TEXT. --csv: the rows. --frames: a row a frame. --draw: the middle frame of
// each as PNG.
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <thread>

#include "pellucida/core_vtk/SceneData.h"
#include "tracking/GridRow.h"

namespace {

using namespace pellucida;
using test::GridCondition;
using test::GridRow;
using test::GridRun;

struct Choice {
  int threads = 1;
  bool representative = false, list = false;
  std::string only, csv, frames, draw;
};

void print_head() {
  std::printf("%-32s %6s | %-17s | %-17s | %-17s | %5s | %4s %4s %4s %4s %4s | %4s %4s %4s %4s %4s | %s\n", "", "",
              "outer px", "inner px", "tip px", "indent", "1-sigma coverage", "", "", "", "", "", "miss", "ing", "", "",
              "");
  std::printf(
      "%-32s %6s | %5s %5s %5s | %5s %5s %5s | %5s %5s %5s | %5s | %4s %4s %4s %4s %4s | %4s %4s %4s %4s %4s | %s\n",
      "condition", "frames", "med", "p95", "max", "med", "p95", "max", "med", "p95", "max", "um", "out", "in", "dimp",
      "tip", "dep", "bold", "in", "tip", "lost", "stat", "ms");
}

void print(const GridRow& r) {
  std::printf(
      "%-32s %6d | %5.2f %5.2f %5.2f | %5.2f %5.2f %5.2f | %5.2f %5.2f %5.2f | %5.2f | %4.2f %4.2f %4.2f %4.2f %4.2f | "
      "%4d "
      "%4d %4d %4d %4d | %.1f\n",
      r.name.c_str(), r.frames, r.outer_px.median, r.outer_px.p95, r.outer_px.largest, r.inner_px.median,
      r.inner_px.p95, r.inner_px.largest, r.tip_px.median, r.tip_px.p95, r.tip_px.largest, r.indentation_rms_um,
      r.outer_coverage.ratio(), r.inner_coverage.ratio(), r.dimple_coverage.ratio(), r.tip_coverage.ratio(),
      r.depth_coverage.ratio(), r.confident_and_wrong, r.inner_px.missing, r.tip_px.missing, r.lost, r.wrong_states,
      r.median_frame_ms);
}

void write_csv(std::ostream& out, const std::vector<GridRow>& rows) {
  out << "condition,frames,outer_median_px,outer_p95_px,outer_max_px,inner_median_px,inner_p95_px,inner_max_px,"
         "tip_median_px,tip_p95_px,tip_max_px,indentation_rms_um,outer_coverage_ratio,inner_coverage_ratio,"
         "dimple_coverage_ratio,tip_coverage_ratio,indentation_coverage_ratio,confident_and_wrong,outer_missing,"
         "inner_missing,tip_missing,lost,wrong_states,median_frame_ms\n";
  for (const GridRow& r : rows) {
    out << r.name << ',' << r.frames;
    for (const test::Spread* s : {&r.outer_px, &r.inner_px, &r.tip_px})
      out << ',' << s->median << ',' << s->p95 << ',' << s->largest;
    out << ',' << r.indentation_rms_um;
    for (const test::Coverage* c :
         {&r.outer_coverage, &r.inner_coverage, &r.dimple_coverage, &r.tip_coverage, &r.depth_coverage})
      out << ',' << c->ratio();
    out << ',' << r.confident_and_wrong << ',' << r.outer_px.missing << ',' << r.inner_px.missing << ','
        << r.tip_px.missing << ',' << r.lost << ',' << r.wrong_states << ',' << r.median_frame_ms << '\n';
  }
}

void write_frames(std::ostream& out, const std::vector<GridCondition>& conditions, const std::vector<GridRun>& runs) {
  out << "condition,frame,state,true_state,confidence,outer_px,outer_max_px,inner_px,oolemma_px,tip_px,center_px,"
         "indentation_error_um,true_indentation_um,rotation_error_deg,outer_coverage_ratio,inner_coverage_ratio\n";
  for (std::size_t k = 0; k < runs.size(); ++k)
    for (std::size_t i = 0; i < runs[k].errors.size(); ++i) {
      const test::FrameError& e = runs[k].errors[i];
      out << conditions[k].name << ',' << i * static_cast<std::size_t>(conditions[k].stride) << ','
          << to_string(e.state) << ',' << to_string(e.true_state) << ',' << e.confidence << ',' << e.outer_px << ','
          << e.outer_max_px << ',' << e.inner_px << ',' << e.oolemma_px << ',' << e.tip_px << ',' << e.center_px << ','
          << e.indentation_um << ',' << e.true_indentation_um << ',' << e.rotation_rad * 180.0 / M_PI << ','
          << e.outer_coverage.ratio() << ',' << e.inner_coverage.ratio() << '\n';
    }
}

// What the condition looks like half-way.
void draw(const GridCondition& condition, const std::string& prefix) {
  VirtualMicroscope microscope(condition.scenario);
  for (long k = 0; k < *microscope.info().frame_count * 2 / 3; ++k) microscope.skip();
  const std::optional<Frame> frame = microscope.next();
  const ImageView view = view_of(frame->image.get());
  const cv::Mat grey(view.height_px, view.width_px, view.format == PixelFormat::kGray16 ? CV_16U : CV_8U,
                     const_cast<void*>(view.data), static_cast<std::size_t>(view.row_bytes));
  std::string file = prefix + condition.name + ".png";
  for (char& c : file)
    if (c == ' ' || c == ',') c = '_';
  cv::imwrite(file, grey);
}

Choice read_arguments(int count, char** arguments) {
  Choice choice;
  for (int i = 1; i < count; ++i) {
    const std::string word = arguments[i];
    const auto value = [&]() -> std::string {
      if (i + 1 < count) return arguments[++i];
      std::fprintf(stderr, "tracking_grid: %s needs a value\n", word.c_str());
      std::exit(2);
    };
    if (word == "--threads") {
      choice.threads = std::max(1, std::atoi(value().c_str()));
    } else if (word == "--only") {
      choice.only = value();
    } else if (word == "--csv") {
      choice.csv = value();
    } else if (word == "--frames") {
      choice.frames = value();
    } else if (word == "--draw") {
      choice.draw = value();
    } else if (word == "--representative") {
      choice.representative = true;
    } else if (word == "--list") {
      choice.list = true;
    } else {
      std::fprintf(stderr, "tracking_grid: unknown argument %s; see the head of GridTool.cpp\n", word.c_str());
      std::exit(2);
    }
  }
  return choice;
}

}  // namespace

int main(int count, char** arguments) {
  const Choice choice = read_arguments(count, arguments);
  std::vector<GridCondition> conditions = test::grid_conditions();
  std::erase_if(conditions, [&](const GridCondition& c) {
    return c.name.find(choice.only) == std::string::npos || (choice.representative && !c.representative);
  });
  if (choice.list) {
    for (const GridCondition& c : conditions) std::printf("%s%s\n", c.name.c_str(), c.representative ? " *" : "");
    return 0;
  }
  if (!choice.draw.empty()) {
    for (const GridCondition& c : conditions) draw(c, choice.draw);
    return 0;
  }

  // Conditions are independent: each thread takes the next one. The tracker itself stays on one thread.
  cv::setNumThreads(1);
  std::vector<GridRun> runs(conditions.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t k = next++; k < conditions.size(); k = next++) runs[k] = test::run_condition(conditions[k]);
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < choice.threads; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();

  print_head();
  std::vector<GridRow> rows;
  GridRun all;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    rows.push_back(summarize_run(conditions[k].name, runs[k]));
    print(rows.back());
    all.errors.insert(all.errors.end(), runs[k].errors.begin(), runs[k].errors.end());
    all.frame_ms.insert(all.frame_ms.end(), runs[k].frame_ms.begin(), runs[k].frame_ms.end());
  }
  rows.push_back(summarize_run("ALL", all));
  print(rows.back());

  // How many conditions keep the promises.
  int contours = 0, tips = 0, covered = 0;
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    const GridRow& r = rows[k];
    contours += r.lost == 0 && r.outer_px.median <= 0.3 && r.outer_px.p95 <= 0.8 ? 1 : 0;
    tips += r.tip_px.missing < r.frames / 2 && r.tip_px.median <= 0.5 ? 1 : 0;
    covered += r.outer_coverage.ratio() >= 0.60 && r.outer_coverage.ratio() <= 0.76 ? 1 : 0;
  }
  std::printf(
      "of %zu conditions: outer median <= 0.3 and p95 <= 0.8 px, never lost: %d; tip median <= 0.5 px: %d; outer "
      "coverage in 0.60..0.76: %d; frames confident and wrong: %d\n",
      conditions.size(), contours, tips, covered, rows.back().confident_and_wrong);
  if (!choice.csv.empty()) {
    std::ofstream file(choice.csv);
    write_csv(file, rows);
    if (!file.flush()) return std::fprintf(stderr, "%s: can't be written\n", choice.csv.c_str()), 1;
  }
  if (!choice.frames.empty()) {
    std::ofstream file(choice.frames);
    write_frames(file, conditions, runs);
    if (!file.flush()) return std::fprintf(stderr, "%s: can't be written\n", choice.frames.c_str()), 1;
  }
  return 0;
}
