#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ContactNumbers.h"
#include "ForceCurve.h"
#include "PassportCharts.h"
#include "PassportDoubts.h"
#include "PassportStyle.h"
#include "StreamFacts.h"
#include "pellucida/core/Html.h"
#include "pellucida/core/Version.h"
#include "pellucida/report/PassportReport.h"

namespace pellucida {
namespace {

using Json = nlohmann::ordered_json;
using C = ContactPassport;

constexpr const char* kNoPuncture = "no puncture";

// A number with its unit as a person reads it.
struct Shown {
  std::string value;     ///< "" for none
  std::string interval;  ///< "6.71 to 8.32"; "" for none
};

double double_of(const C& contact, const Field<C>& field) {
  const auto* member = std::get_if<double C::*>(&field.member);
  return member ? contact.**member : C::kNone;
}

// The number of a field, with the two ends that follow it in the table where it has them.
Shown shown(const C& contact, std::size_t index) {
  const auto fields = contact_fields();
  const Field<C>& field = fields[index].field;
  if (const auto* count = std::get_if<int C::*>(&field.member)) return {std::to_string(contact.**count), ""};
  const double value = double_of(contact, field);
  if (!std::isfinite(value)) return {};
  if (field.unit == "0..1") return {fixed_number(100.0 * value, 0) + " %", ""};
  const bool has_ends = index + 2 < fields.size() && fields[index + 1].label.empty();
  const double lower = has_ends ? double_of(contact, fields[index + 1].field) : C::kNone;
  const double upper = has_ends ? double_of(contact, fields[index + 2].field) : C::kNone;
  const int decimals = field.unit == "s" ? 2 : decimals_of(value);
  const std::string unit = field.unit.empty() ? "" : ' ' + unit_text(field.unit);
  Shown shown{fixed_number(value, decimals) + unit, ""};
  if (std::isfinite(lower) && std::isfinite(upper)) {
    shown.interval = fixed_number(lower, decimals) + " to " + fixed_number(upper, decimals);
  }
  return shown;
}

// Why a number is not there.
std::string reason(const C& contact, std::string_view name, const PassportInput& input) {
  const auto begins = [&](std::string_view start) { return name.starts_with(start); };
  if (begins("stiffness_")) {
    const int depth_um = std::atoi(std::string(name.substr(10)).c_str());
    return contact.largest_depth_um >= depth_um + kBeyondDepth_um ? "too few frames" : "not reached";
  }
  const bool punctured = contact.outcome == "punctured";
  if (begins("puncture_") || begins("drop_") || begins("spring_") || begins("inside_")) {
    return punctured ? "not measured" : kNoPuncture;
  }
  if (begins("hysteresis_")) return punctured ? "no removal" : "not recorded";
  if (begins("release_") || begins("removal_")) return "not seen";
  if (begins("deposit_")) return "not recorded";
  if (begins("first_deposit_")) return input.is_hand_recorded ? "no deposit" : "not recorded";
  if (begins("strain_")) return "not shown by its contours";
  if (begins("approach_") || begins("largest_")) return "not recorded";
  return "not measured";
}

std::string tag(const std::string& name, const std::string& content) {
  return '<' + name + '>' + content + "</" + name.substr(0, name.find(' ')) + '>';
}

std::string list_of(const std::vector<std::string>& sentences) {
  std::string html = "<ul>\n";
  for (const std::string& sentence : sentences) html += tag("li", html_text(sentence)) + '\n';
  return html + "</ul>\n";
}

std::string doubts_box(const char* title, const std::vector<std::string>& doubts) {
  return doubts.empty() ? "" : "<div class=\"doubts\">\n" + tag("h3", title) + list_of(doubts) + "</div>\n";
}

std::size_t index_of(std::string_view name) {
  const auto fields = contact_fields();
  return static_cast<std::size_t>(
      std::find_if(fields.begin(), fields.end(), [&](const auto& one) { return one.field.name == name; }) -
      fields.begin());
}

std::string cell_of_table(const C& contact, std::string_view name, const PassportInput& input) {
  const Shown number = shown(contact, index_of(name));
  if (number.value.empty()) return tag("td class=\"missing\"", reason(contact, name, input));
  const std::string interval = number.interval.empty() ? "" : " <span class=\"small\">" + number.interval + "</span>";
  return tag("td", number.value + interval);
}

std::string title_of(const CellPassport& cell) {
  return std::to_string(cell.cell) + (cell.name.empty() ? "" : ": " + html_text(cell.name));
}

// A row of a table for a contact: the outcome, then the numbers named.
std::string row_of(const std::string& head, const C& contact, std::size_t doubt_count, const PassportInput& input) {
  std::string html = "<tr><th scope=\"row\">" + head + "</th>" + tag("td", outcome_words(contact));
  if (contact.contact == 0)
    return html + "<td colspan=\"4\"></td>" + tag("td", std::to_string(doubt_count)) + "</tr>\n";
  for (const char* name : {"peak_force_uN", "largest_depth_um", "work_pJ", "dwell_s"}) {
    html += cell_of_table(contact, name, input);
  }
  return html + tag("td", std::to_string(doubt_count)) + "</tr>\n";
}

std::string table_head(const char* first) {
  std::string html = "<div class=\"scroll\"><table class=\"wide\">\n<thead><tr>";
  for (const char* name :
       {first, "Outcome", "Peak force", "Largest depth", "Work to it", "Time in contact", "Doubts"}) {
    html += tag("th scope=\"col\"", name);
  }
  return html + "</tr></thead>\n<tbody>\n";
}

std::string summary(std::span<const CellPassport> cells, const PassportInput& input) {
  std::string html = table_head("Cell");
  for (const CellPassport& cell : cells) {
    const C& main = cell.main_contact();
    const std::string link = "<a href=\"#cell-" + std::to_string(cell.cell) + "\">" + title_of(cell) + "</a>";
    html += row_of(link, main, main.doubt_list.size() + cell.doubt_list.size(), input);
  }
  return html + "</tbody></table></div>\n" + comparison_chart(input, cells);
}

// Which of the two opens the interval.
std::string parts_of(const C& contact) {
  if (!std::isfinite(contact.picture_sigma_percent) || !std::isfinite(contact.scale_sigma_percent)) return {};
  return tag("dd class=\"interval\"", "picture &#177;" + fixed_number(contact.picture_sigma_percent, 0) +
                                          " %, scale &#177;" + fixed_number(contact.scale_sigma_percent, 0) + " %");
}

std::string headline(const C& contact, const PassportInput& input) {
  std::string html = "<dl class=\"headline\">\n";
  const bool punctured = contact.outcome == "punctured";
  const char* const of_puncture[] = {"peak_force_uN", "puncture_force_uN", "puncture_depth_um", "puncture_work_pJ"};
  const char* const of_push[] = {"peak_force_uN", "largest_depth_um", "work_pJ", "dwell_s"};
  for (const char* name : punctured ? of_puncture : of_push) {
    const std::size_t index = index_of(name);
    const Shown number = shown(contact, index);
    html += "<div>" + tag("dt", std::string(contact_fields()[index].label));
    html += number.value.empty() ? tag("dd class=\"missing\"", reason(contact, name, input)) : tag("dd", number.value);
    if (!number.interval.empty()) html += tag("dd class=\"interval\"", number.interval);
    if (std::string_view(name) == "peak_force_uN") html += parts_of(contact);
    html += "</div>\n";
  }
  return html + "</dl>\n";
}

// All numbers of a contact, in groups.
std::string numbers(const C& contact, const PassportInput& input) {
  std::string html = "<div class=\"numbers\">\n";
  bool is_open = false;
  const auto fields = contact_fields();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto& [field, label, heading] = fields[i];
    if (label.empty() || std::holds_alternative<std::string C::*>(field.member)) continue;
    if (!heading.empty()) {
      html += (is_open ? "</table></section>\n" : "") + std::string("<section>") + tag("h3", std::string(heading)) +
              "<table>\n";
      is_open = true;
    }
    if (!is_open) continue;
    const Shown number = shown(contact, i);
    // Of a puncture that did not happen one row is enough.
    if (number.value.empty() && field.name != "puncture_s" && reason(contact, field.name, input) == kNoPuncture)
      continue;
    html += "<tr title=\"" + html_text(field.doc) + "\"><th scope=\"row\">" + html_text(unit_text(label)) + "</th>";
    html += number.value.empty()
                ? tag("td class=\"missing value\"", reason(contact, field.name, input)) + "<td></td>"
                : tag("td class=\"value\"", number.value) + tag("td class=\"interval\"", number.interval);
    html += "</tr>\n";
  }
  return html + (is_open ? "</table></section>\n" : "") + "</div>\n";
}

std::string card(const CellPassport& cell, const PassportInput& input, bool is_first) {
  const C& main = cell.main_contact();
  std::string html = "<section class=\"cell" + std::string(is_first ? " first" : "") +
                     (cell.contacts == 0 ? " brief" : "") + "\" id=\"cell-" + std::to_string(cell.cell) +
                     "\">\n<header>";
  html += tag("h2", "Cell " + title_of(cell)) + tag("span class=\"outcome\"", outcome_words(main));
  std::string seen = "seen " + fixed_number(cell.found_s, 2) + " to " + fixed_number(cell.last_seen_s, 2) + " s";
  if (std::isfinite(cell.radius_um)) seen += ", radius " + fixed_number(cell.radius_um, 1) + ' ' + unit_text("um");
  if (cell.contacts > 1) {
    seen += ", contact " + std::to_string(main.contact) + " of " + std::to_string(cell.contacts) + " in detail";
  }
  html += tag("span class=\"outcome\"", seen) + "</header>\n";
  std::vector<std::string> doubts = cell.doubt_list;
  doubts.insert(doubts.end(), main.doubt_list.begin(), main.doubt_list.end());
  if (cell.contacts == 0) return html + doubts_box("Doubts and warnings", doubts) + "</section>\n";

  html += headline(main, input) + doubts_box("Doubts and warnings", doubts) + cell_charts(input, cell) +
          numbers(main, input);
  if (cell.contacts > 1) {
    html += tag("h3 class=\"more\"", "All contacts") + table_head("Contact");
    for (const C& contact : cell.contact_list) {
      html += row_of(std::to_string(contact.contact), contact, contact.doubt_list.size(), input);
    }
    html += "</tbody></table></div>\n";
  }
  if (!cell.notes.empty()) html += "<div class=\"notes more\">" + tag("h3", "Notes") + list_of(cell.notes) + "</div>\n";
  return html + "</section>\n";
}

std::string counted(std::size_t count, const char* what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

std::string fact(const char* name, const std::string& value, const char* kind = "") {
  return std::string("<div") + kind + ">" + tag("dt", name) + tag("dd", html_text(value)) + "</div>\n";
}

std::string facts(const SessionReader& session, std::size_t cell_count) {
  const SessionInfo& info = session.info();
  const SourceInfo& source = info.source;
  const auto or_none = [](const std::string& text) { return text.empty() ? std::string("not recorded") : text; };
  std::string size = std::to_string(source.width_px) + " x " + std::to_string(source.height_px) + " px";
  if (source.frame_rate_hz > 0.0) size += ", " + fixed_number(source.frame_rate_hz, 1) + " frames/s";
  const std::string pixel = source.pixel_size_um > 0.0 ? fixed_number(source.pixel_size_um, 4) + ' ' + unit_text("um") +
                                                             " (from: " + or_none(source.pixel_size_origin) + ')'
                                                       : "not recorded";
  std::string profile = or_none(info.profile_name);
  if (!info.palpation_json.empty()) profile += ", scaled to this cell by a measurement";
  return "<dl class=\"facts\">\n" + fact("Recorded (UTC)", or_none(session.created())) +
         fact("Source", or_none(source.name)) + fact("Image", size) + fact("Pixel size", pixel) +
         fact("Cell profile", profile) +
         fact("Content", counted(session.measurements().size(), "frame") + ", " + counted(cell_count, "cell")) +
         fact("Incomplete frames", incomplete_frame_words(session)) +
         fact("Clocks", clock_words(session), " class=\"wide\"") + "</dl>\n";
}

std::string joined(const Json& object) {
  std::string text;
  for (const auto& [key, value] : object.items()) {
    text += (text.empty() ? "" : ", ") + key + ' ' + (value.is_string() ? value.get<std::string>() : value.dump());
  }
  return text;
}

std::string provenance(const SessionInfo& info) {
  std::string text;
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) text += tag("b", name) + ' ' + html_text(value) + ". ";
  };
  add("Measured with", "Pellucida " + info.software_version);
  add("Page by", std::string("Pellucida ") + kVersion);
  add("Command:", info.command_line);
  const Json json = Json::parse(info.provenance_json, nullptr, false);
  if (json.is_object()) {
    const auto object = [&](const char* key) {
      return json.contains(key) && json[key].is_object() ? json[key] : Json();
    };
    add("Libraries:", joined(object("versions")));
    add("SHA-256 of inputs:", joined(object("inputs_sha256")));
    if (json.contains("frames_sha256") && json["frames_sha256"].is_string())
      add("SHA-256 of images:", json["frames_sha256"].get<std::string>());
  }
  return tag("p", text) + '\n';
}

std::string glossary() {
  std::string html = "<details class=\"glossary\"><summary>What each number means</summary><table>\n";
  for (const auto& [field, label, heading] : contact_fields()) {
    if (label.empty()) continue;
    std::string doc = html_text(field.doc);
    std::erase(doc, '`');
    html += "<tr>" + tag("th scope=\"row\"", html_text(unit_text(label))) + tag("td", doc) + "</tr>\n";
  }
  return html + "</table></details>\n";
}

constexpr const char* kReadingHelp =
    "Each number comes with its 95 % interval, where the session has one. It is the whole: what the picture leaves "
    "open (depth, shape, model, sizes) and what the scale does (how single cells of one kind differ, less once this "
    "cell's scale was measured). In the charts the dark band is the picture's part, the light one the whole. Both are "
    "given for the peak force, as standard deviations: numbers of one cell differ "
    "by the picture's part alone, since the scale is one factor on all of them. Sessions of earlier versions give one "
    "interval, which does not contain how cells differ. Work and stiffness take the force's interval with them. A "
    "puncture's force after the event is 0 by definition, not measured.";

}  // namespace

std::string passport_page(const SessionReader& session, const PassportInput& input,
                          std::span<const CellPassport> cells) {
  const std::string name = html_text(input.session);
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n";
  html += tag("title", "Dose passport: " + name) + "\n<style>" + kPassportStyle + "</style>\n</head>\n<body>\n";
  html += "<header class=\"top\">" + tag("h1", name) + tag("p class=\"kind\"", "Dose passport") + "</header>\n" +
          facts(session, cells.size());
  html += doubts_box("The session as a whole", session_doubts(session, input));
  if (cells.empty()) html += tag("p class=\"none\"", "No cell was found in this session.") + '\n';
  // Of several cells the first sheet is an overview with all that is common to them.
  const bool has_overview = cells.size() > 1;
  const std::string common = "<footer>\n" + tag("p", kReadingHelp) + provenance(session.info()) + "</footer>\n";
  if (has_overview) html += summary(cells, input) + common;
  for (const CellPassport& cell : cells) html += card(cell, input, !has_overview);
  return html + (has_overview ? "" : common) + glossary() + "</body>\n</html>\n";
}

}  // namespace pellucida
