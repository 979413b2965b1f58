#include "presenters/RecordedSession.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "pellucida/core/Error.h"
#include "pellucida/core/Statistics.h"
#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"
#include "presenters/SourcePresenter.h"

namespace pellucida {
namespace {

// A time read back from a table has nine digits.
constexpr double kTimeSlack_s = 1e-6;

CellProfile profile_of(const SessionInfo& info) {
  CellProfile unknown;
  unknown.name = info.profile_name.empty() ? say("unknown") : info.profile_name;
  unknown.description = say("The session does not hold this profile");
  if (info.profile_json.empty()) return unknown;
  try {
    return parse_profile(info.profile_json, "session.json");
  } catch (const Error& error) {
    unknown.description = say_message(error.what());
    return unknown;
  }
}

}  // namespace

std::size_t RecordedSession::step_at(double time_s) const noexcept {
  const auto later = std::upper_bound(times_s.begin(), times_s.end(), time_s + kTimeSlack_s);
  return later == times_s.begin() ? 0 : static_cast<std::size_t>(later - times_s.begin()) - 1;
}

std::optional<std::size_t> RecordedSession::image_step_at(double time_s) const noexcept {
  if (image_steps.empty()) return std::nullopt;
  const auto later = std::lower_bound(image_steps.begin(), image_steps.end(), time_s,
                                      [this](std::size_t step, double time) { return times_s[step] < time; });
  if (later == image_steps.begin()) return *later;
  if (later == image_steps.end()) return image_steps.back();
  const auto before = later - 1;
  return time_s - times_s[*before] <= times_s[*later] - time_s ? *before : *later;
}

std::optional<std::array<double, 4>> RecordedSession::cell_region_um() const {
  // Of the region, in radii of the cell.
  constexpr double kHalfWidth = 2.4, kHalfHeight = 1.6;
  std::vector<double> x_um, y_um, radius_um;
  for (const Measurement& row : rows) {
    if (!std::isfinite(row.cell_x_um) || !std::isfinite(row.cell_y_um) || !(row.volume_um3 > 0.0)) continue;
    x_um.push_back(row.cell_x_um);
    y_um.push_back(row.cell_y_um);
    radius_um.push_back(std::cbrt(0.75 * row.volume_um3 / std::numbers::pi));
  }
  if (x_um.empty()) return std::nullopt;
  for (auto* values : {&x_um, &y_um, &radius_um}) std::sort(values->begin(), values->end());
  const double radius = quantile(radius_um, 0.5);
  return std::array{quantile(x_um, 0.5) - kHalfWidth * radius, quantile(y_um, 0.5) - kHalfHeight * radius,
                    2.0 * kHalfWidth * radius, 2.0 * kHalfHeight * radius};
}

double RecordedSession::usual_step_s() const {
  if (times_s.size() < 2) return 0.0;
  std::vector<double> steps_s;
  steps_s.reserve(times_s.size() - 1);
  for (std::size_t i = 1; i < times_s.size(); ++i) steps_s.push_back(times_s[i] - times_s[i - 1]);
  const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2);
  std::nth_element(steps_s.begin(), middle, steps_s.end());
  return *middle;
}

RecordedSession recorded_session(const SessionReader& reader) {
  RecordedSession session;
  session.folder = reader.folder();
  session.info = reader.info();
  session.created = reader.created();
  session.complete = reader.complete();
  session.head_changed = reader.head_changed();
  session.skipped_row_count = reader.skipped_row_count();
  session.rows = reader.measurements();
  session.events = reader.events();
  session.profile = profile_of(session.info);
  const auto scale = nlohmann::json::parse(session.info.palpation_json, nullptr, false);
  if (const auto ratio = scale.is_object() ? scale.find("cell_scale_ratio") : scale.end();
      ratio != scale.end() && ratio->is_number() && ratio->get<double>() > 0.0) {
    session.scale_ratio = ratio->get<double>();
  }
  if (session.rows.empty()) {
    throw InputError(session.folder.string() + ": the session holds no frame; choose another one");
  }
  session.times_s.reserve(session.rows.size());
  double newest_s = session.rows.front().time_s;
  for (const Measurement& row : session.rows) {
    newest_s = std::max(newest_s, row.time_s);
    session.times_s.push_back(newest_s);
  }
  for (std::size_t i = 0; i < reader.steps().size(); ++i) {
    if (reader.steps()[i].has(SessionPart::kFrame)) session.image_steps.push_back(i);
  }
  return session;
}

std::string session_name_of(const std::filesystem::path& folder) {
  SourceInfo info;
  info.name = folder.string();
  return source_label(info);
}

void add_scale(const RecordedSession& session, const Measurement& row, ForceRemarks& remarks) {
  const ForceSpread spread = force_spread(row);
  if (!spread.is_own_scale || !std::isfinite(spread.scale_ratio)) return;
  remarks.has_own_scale = true;
  remarks.scale_ratio = session.scale_ratio;
  remarks.scale_sigma_ratio = spread.scale_ratio;
}

std::string session_facts(const RecordedSession& session) {
  const auto& info = session.info;
  std::string facts;
  const auto add = [&facts](const std::string& fact) {
    if (fact.empty()) return;
    if (!facts.empty()) facts += " \u00B7 ";
    facts += fact;
  };
  // "2026-11-20T20:15:00Z" to the minute.
  std::string created = session.created.substr(0, 16);
  std::replace(created.begin(), created.end(), 'T', ' ');
  add(created.empty() ? "" : created + " UTC");
  add(session.profile.name);
  add(readout::plain(info.source.pixel_size_um) + " µm/px");
  add(std::to_string(session.step_count()) + (session.step_count() == 1 ? say(" frame") : say(" frames")));
  add(readout::time(session.end_s() - session.begin_s()));
  add(session.complete ? say("complete") : say("interrupted"));
  return facts;
}

std::string session_caution(const RecordedSession& session) {
  std::string caution;
  const auto add = [&caution](const std::string& text) { caution += (caution.empty() ? "" : "; ") + text; };
  if (!session.complete) add(say("The recording was interrupted, or is still being written"));
  if (session.head_changed)
    add(say("session.json was changed after it was written: don't trust calibration and profile"));
  if (session.skipped_row_count > 0) {
    add(std::to_string(session.skipped_row_count) + (session.skipped_row_count == 1 ? say(" row") : say(" rows")) +
        say(" can't be read and are left out; pellucida check names them"));
  }
  return caution;
}

}  // namespace pellucida
