#include "pellucida/session/SessionExport.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "DiskFile.h"
#include "SessionFolder.h"
#include "SessionIndex.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/OutputFile.h"
#include "pellucida/core/Table.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/session/Annotations.h"
#include "pellucida/session/SessionReader.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

std::vector<std::size_t> steps_with(const SessionReader& session, SessionPart part) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < session.steps().size(); ++i) {
    if (session.steps()[i].has(part)) found.push_back(i);
  }
  return found;
}

// "frame 12 (6.47 uN)"; a frame without a force has only its number.
std::string named(const SessionReader& session, std::size_t step) {
  const double force_uN = session.measurements()[step].contact_force_uN;
  return "frame " + std::to_string(session.steps()[step].frame_index) +
         (std::isnan(force_uN) ? "" : " (" + csv_number(force_uN) + " uN)");
}

// The step with the largest contact force of those that have a surface; the first of them where no force was measured.
// `notes` says which it is, and whether another frame without a surface had more force.
std::size_t peak_of(const SessionReader& session, const std::vector<std::size_t>& surfaces,
                    std::vector<std::string>& notes) {
  const auto force_uN = [&](std::size_t step) {
    const double value = session.measurements()[step].contact_force_uN;
    return std::isnan(value) ? -1.0 : value;
  };
  const auto less = [&](std::size_t left, std::size_t right) { return force_uN(left) < force_uN(right); };
  const std::size_t peak = *std::max_element(surfaces.begin(), surfaces.end(), less);
  std::vector<std::size_t> all(session.steps().size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::size_t greatest = *std::max_element(all.begin(), all.end(), less);
  if (force_uN(greatest) > force_uN(peak)) {
    notes.push_back("warning: " + named(session, greatest) +
                    " has the largest force but no surface; the peak in nodes.csv is " + named(session, peak) +
                    ", the largest of those with a surface");
  } else if (force_uN(peak) < 0.0) {
    notes.push_back("warning: no force was measured; the peak in nodes.csv is " + named(session, peak) +
                    ", the first with a surface");
  } else {
    notes.push_back("the peak in nodes.csv is " + named(session, peak));
  }
  return peak;
}

// Turns the user's list into steps, in its order, each once.
std::vector<std::size_t> chosen_steps(const SessionReader& session, const std::string& list,
                                      std::vector<std::string>& notes) {
  const auto surfaces = steps_with(session, SessionPart::kSurface);
  std::vector<std::size_t> chosen;
  for (const std::string& word : split_csv(list)) {
    std::optional<std::size_t> step;
    if (word == "first" || word == "last" || word == "peak") {
      if (surfaces.empty()) continue;
      step = word == "first" ? surfaces.front() : word == "last" ? surfaces.back() : peak_of(session, surfaces, notes);
    } else {
      long frame = -1;
      const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), frame);
      const auto& steps = session.steps();
      const auto found =
          std::find_if(steps.begin(), steps.end(), [&](const auto& one) { return one.frame_index == frame; });
      if (code != std::errc() || end != word.data() + word.size() || found == steps.end()) {
        const std::string range = steps.empty() ? "it has none"
                                                : "they go from " + std::to_string(steps.front().frame_index) + " to " +
                                                      std::to_string(steps.back().frame_index);
        throw UsageError("--frames \"" + word + "\": no frame of " + session.folder().string() +
                         "; give first, last, peak or frame numbers (" + range + ")");
      }
      step = static_cast<std::size_t>(found - steps.begin());
    }
    if (std::find(chosen.begin(), chosen.end(), *step) == chosen.end()) chosen.push_back(*step);
  }
  return chosen;
}

// The rows that could be read, as they stand; events in the order of time.
template <class Row>
void copy_table(const fs::path& target, std::string_view header, const SessionTable<Row>& table) {
  OutputFile file(target);
  file.add(table.header_right ? std::string_view(table.header) : header);
  for (const std::string_view line : table.lines) file.add(line);
  file.finish();
}

// Points in order round each closed contour; the closing repetition of the first point is left out.
std::size_t add_contours(OutputFile& file, long frame, vtkPolyData* membranes) {
  vtkDataArray* membrane = membranes->GetCellData()->GetArray(array_name::kMembrane);
  std::size_t count = 0;
  for (vtkIdType cell = 0; cell < membranes->GetNumberOfCells(); ++cell) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    membranes->GetCellPoints(cell, size, ids);
    if (size > 1 && ids[0] == ids[size - 1]) --size;
    const std::string head =
        std::to_string(frame) + ',' + csv_number(membrane ? membrane->GetComponent(cell, 0) : NAN) + ',';
    for (vtkIdType i = 0; i < size; ++i) {
      double point_um[3];
      membranes->GetPoint(ids[i], point_um);
      file.add(head + std::to_string(i) + ',' + csv_number(point_um[0]) + ',' + csv_number(point_um[1]));
    }
    count += static_cast<std::size_t>(size);
  }
  return count;
}

// A surface's nodes with their forces; a cell stays empty where an array isn't there.
std::size_t add_nodes(OutputFile& file, long frame, vtkPolyData* surface) {
  vtkPointData* arrays = surface->GetPointData();
  const auto value = [&](const char* name, vtkIdType node, int component) {
    vtkDataArray* array = arrays->GetArray(name);
    return array ? array->GetComponent(node, component) : std::numeric_limits<double>::quiet_NaN();
  };
  for (vtkIdType node = 0; node < surface->GetNumberOfPoints(); ++node) {
    std::string row =
        std::to_string(frame) + ',' + std::to_string(node) + ',' + csv_number(value(array_name::kMembrane, node, 0));
    double point_um[3];
    surface->GetPoint(node, point_um);
    for (const double coordinate_um : point_um) row += ',' + csv_number(coordinate_um);
    for (int i = 0; i < 3; ++i) row += ',' + csv_number(value(array_name::kForce, node, i));
    file.add(row + ',' + csv_number(value(array_name::kForceSigma, node, 0)));
  }
  return static_cast<std::size_t>(surface->GetNumberOfPoints());
}

// Does `take` with a file of a session; one that can't be read is left out, and said once for all of its kind.
class Leniency {
 public:
  explicit Leniency(const char* what) : what_(what) {}

  template <class Take>
  void read(Take take) {
    try {
      take();
    } catch (const InputError& error) {
      if (++count_ == 1) first_ = error.what();
    }
  }

  void report(std::vector<std::string>& notes) const {
    if (count_ == 0) return;
    notes.push_back("warning: " + std::to_string(count_) + ' ' + what_ +
                    " left out, which can't be read, the first: " + first_ + "; run pellucida check on the session");
  }

 private:
  const char* what_;
  std::size_t count_ = 0;
  std::string first_;
};

void write_contours(const SessionReader& session, const fs::path& output, const ExportOptions& options,
                    ExportReport& report) {
  OutputFile file(output / "contours.csv");
  file.add("frame,membrane,point,x_um,y_um");
  const auto steps = steps_with(session, SessionPart::kMembranes);
  Leniency lenient("file(s) of contours");
  for (std::size_t i = 0; i < steps.size(); ++i) {
    lenient.read([&] {
      const auto membranes = session.load(steps[i], SessionPart::kMembranes);
      report.contour_point_count += add_contours(file, session.steps()[steps[i]].frame_index, membranes.shallow_copy());
    });
    if (options.progress) options.progress(i + 1, steps.size());
  }
  file.finish();
  lenient.report(report.notes);
  if (steps.empty()) report.notes.emplace_back("no membrane was found in any frame: contours.csv has only its header");
  report.files.push_back(output / "contours.csv");
}

void write_nodes(const SessionReader& session, const fs::path& output, const std::vector<std::size_t>& steps,
                 ExportReport& report) {
  OutputFile file(output / "nodes.csv");
  file.add("frame,node,membrane,x_um,y_um,z_um,fx_uN,fy_uN,fz_uN,force_sigma_uN");
  Leniency lenient("surface(s)");
  for (const std::size_t step : steps) {
    const long frame = session.steps()[step].frame_index;
    if (!session.steps()[step].has(SessionPart::kSurface)) {
      report.notes.push_back("frame " + std::to_string(frame) + " has no surface: it is not in nodes.csv");
      continue;
    }
    lenient.read([&] {
      const auto surface = session.load(step, SessionPart::kSurface);
      report.node_count += add_nodes(file, frame, surface.shallow_copy());
      report.node_frames.push_back(frame);
    });
  }
  file.finish();
  lenient.report(report.notes);
  if (steps.empty()) report.notes.emplace_back("no surface was made in any frame: nodes.csv has only its header");
  report.files.push_back(output / "nodes.csv");
}

// The columns of the hand's table: `path,x_um,y_um,z_um` and an array's components, `force_N_x,force_N_y,force_N_z`.
std::string hand_header(vtkPointData* arrays) {
  std::string header = "path,x_um,y_um,z_um";
  for (int a = 0; a < arrays->GetNumberOfArrays(); ++a) {
    vtkDataArray* array = arrays->GetArray(a);
    const int count = array->GetNumberOfComponents();
    for (int i = 0; i < count; ++i) {
      header += ',' + csv_cell(array->GetName()) + (count == 1 ? "" : std::string("_") + "xyz"[i % 3]);
    }
  }
  return header;
}

// A row for each tick and path (hand, tip), with all arrays of its points.
std::size_t add_hand(OutputFile& file, vtkPolyData* paths) {
  vtkDataArray* kind = paths->GetCellData()->GetArray(array_name::kPath);
  vtkPointData* arrays = paths->GetPointData();
  std::size_t row_count = 0;
  for (vtkIdType line = 0; line < paths->GetNumberOfCells(); ++line) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    paths->GetCellPoints(line, size, ids);
    const std::string head = kind && kind->GetComponent(line, 0) == 0.0 ? "hand" : "tip";
    for (vtkIdType i = 0; i < size; ++i) {
      double point_um[3];
      paths->GetPoint(ids[i], point_um);
      std::string row = head;
      for (const double coordinate_um : point_um) row += ',' + csv_number(coordinate_um);
      for (int a = 0; a < arrays->GetNumberOfArrays(); ++a) {
        vtkDataArray* array = arrays->GetArray(a);
        for (int c = 0; c < array->GetNumberOfComponents(); ++c)
          row += ',' + csv_number(array->GetComponent(ids[i], c));
      }
      file.add(row);
      ++row_count;
    }
  }
  return row_count;
}

void write_hand(const SessionReader& session, const fs::path& output, ExportReport& report) {
  std::optional<OutputFile> file;
  std::string header;
  Leniency lenient("block(s) of the hand");
  for (std::size_t block = 0; block < session.hand_block_count(); ++block) {
    lenient.read([&] {
      const auto paths = session.load_hand(block).shallow_copy();
      const std::string columns = hand_header(paths->GetPointData());
      if (!file) {
        header = columns;
        file.emplace(output / "haptics.csv");
        file->add(header);
      }
      if (columns != header) throw InputError("block " + std::to_string(block) + " has other arrays than the first");
      report.hand_row_count += add_hand(*file, paths);
    });
  }
  lenient.report(report.notes);
  if (!file) return;
  file->finish();
  report.files.push_back(output / "haptics.csv");
}

}  // namespace

std::vector<fs::path> export_names(const fs::path& output) {
  std::vector<fs::path> files;
  for (const char* name : {session_name::kMeasurements, session_name::kEvents, "contours.csv", "nodes.csv",
                           kAnnotationsFile, "haptics.csv"}) {
    files.push_back(output / name);
  }
  return files;
}

ExportReport export_session(const fs::path& session_folder, const fs::path& output, const ExportOptions& options) {
  const SessionReader session(session_folder);
  ExportReport report;
  const auto chosen = chosen_steps(session, options.frames, report.notes);
  make_folder(output);
  if (fs::equivalent(session_folder, output)) {
    throw UsageError(output.string() +
                     ": is the session itself, whose tables would be overwritten; choose another --output");
  }

  const bool checked = is_plain_file(session_folder / session_name::kChecksums);
  copy_table(output / session_name::kMeasurements, measurement_header(),
             read_measurements(session_folder / session_name::kMeasurements, checked));
  report.files.push_back(output / session_name::kMeasurements);
  copy_table(output / session_name::kEvents, session_name::kEventsHeader,
             read_events(session_folder / session_name::kEvents, checked));
  report.files.push_back(output / session_name::kEvents);
  Leniency lenient("file of annotations");
  lenient.read([&] {
    const std::vector<Annotation> annotations = read_annotations(session_folder);
    write_annotations(output, annotations);
    if (!annotations.empty()) report.files.push_back(output / kAnnotationsFile);
  });
  lenient.report(report.notes);
  write_contours(session, output, options, report);
  write_nodes(session, output, chosen, report);
  write_hand(session, output, report);
  if (session.hand_block_count() == 0) {
    report.notes.emplace_back("the session has no recording of the hand: no haptics.csv");
  }
  if (session.head_changed()) {
    report.notes.emplace_back("warning: session.json was changed after it was written; check calibration and profile");
  }
  if (session.skipped_row_count() > 0) {
    report.notes.push_back("warning: " + std::to_string(session.skipped_row_count()) +
                           " row(s) left out, which can't be read or were changed; run pellucida check on the session");
  }
  if (!session.complete()) report.notes.emplace_back("the session was cut off: what it holds up to there was exported");
  return report;
}

std::size_t telling_step(const SessionReader& session) {
  const auto score = [](const Measurement& m) {
    if (m.contact_force_uN > 0.0) return 1.0 + m.contact_force_uN;
    return std::isnan(m.confidence) ? -1.0 : m.confidence;
  };
  const std::vector<Measurement>& rows = session.measurements();
  const auto best =
      std::max_element(rows.begin(), rows.end(), [&](const auto& a, const auto& b) { return score(a) < score(b); });
  return static_cast<std::size_t>(best - rows.begin());
}

}  // namespace pellucida
