#include "presenters/TouchModel.h"

#include <algorithm>
#include <cmath>

#include "pellucida/core/Error.h"
#include "pellucida/core/Words.h"
#include "pellucida/core_vtk/ObservationData.h"
#include "pellucida/mechanics/ModelCurve.h"
#include "pellucida/session/SessionReader.h"
#include "presenters/SessionCurves.h"

namespace pellucida {
namespace {

// The estimate follows a tool's width over so many frames.
constexpr std::size_t kFramesBefore = 50;
constexpr std::size_t kFramesInTouch = 3;
constexpr double kDepthStep_um = 1.0;

Curve curve_of(const ModelCurve& model) {
  Curve curve;
  for (std::size_t i = 0; i < model.force_uN.size(); ++i) curve.add(model.indentation_um[i], model.force_uN[i]);
  return curve;
}

std::vector<Observation> frames_before(const RecordedSession& session, std::size_t first,
                                       const std::function<bool()>& go_on) {
  const SessionReader reader(session.folder);
  std::vector<Observation> frames;
  const std::size_t begin = first > kFramesBefore ? first - kFramesBefore : 0;
  const std::size_t end = std::min(first + kFramesInTouch, reader.steps().size());
  for (std::size_t step = begin; step < end && go_on(); ++step) {
    try {
      const auto membranes = reader.load(step, SessionPart::kMembranes);
      const auto tools = reader.load(step, SessionPart::kTools);
      if (!membranes) continue;
      auto frame = read_observation(membranes.get(), tools ? tools.get() : nullptr);
      if (frame) frames.push_back(std::move(*frame));
    } catch (const InputError&) {
      // The frame itself names the damage once it is shown.
      continue;
    }
  }
  return frames;
}

std::string remark_of(const SeenCell& cell) {
  std::string remark;
  if (cell.thickness_assumed) remark = say("the zona's inner edge was not seen");
  if (cell.holder_assumed) {
    remark += (remark.empty() ? "" : "; ") + say("no holder seen: taken to be opposite the needle");
  }
  return remark;
}

}  // namespace

TouchModel touch_model(const RecordedSession& session, std::size_t touch, const std::function<bool()>& go_on) {
  TouchModel result;
  if (touch == 0 || !(session.profile.mid_radius_um > 0.0)) return result;
  const std::vector<std::size_t> touches = touches_of(session);
  const auto first = static_cast<std::size_t>(std::find(touches.begin(), touches.end(), touch) - touches.begin());
  double deepest_um = 0.0;
  for (std::size_t i = first; i < session.step_count() && touches[i] == touch; ++i) {
    const Measurement& row = session.rows[i];
    if (row.state == CellState::kContact) deepest_um = std::fmax(deepest_um, row.indentation_um);
  }
  if (!(deepest_um > 0.0)) return result;
  deepest_um = std::ceil(deepest_um);
  const auto seen = seen_cell(frames_before(session, first, go_on), session.profile);
  if (seen && go_on()) {
    const auto own = model_curve(session.profile, *seen, deepest_um, kDepthStep_um, session.scale_ratio, go_on);
    result.curves.push_back({say("Model, this cell's sizes"), curve_of(own), CurveRole::kReference});
    result.remark = remark_of(*seen);
  }
  if (go_on()) {
    const auto usual = model_curve(session.profile, deepest_um, kDepthStep_um, session.scale_ratio, go_on);
    result.curves.push_back({say("Model, profile's cell"), curve_of(usual), CurveRole::kFaintReference});
  }
  return result;
}

}  // namespace pellucida
