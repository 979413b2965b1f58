#include "pellucida/batch/OverviewPage.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "BoxPlot.h"
#include "pellucida/core/Html.h"

namespace pellucida {
namespace {

constexpr const char* kStyle = R"(
body{font:15px/1.5 system-ui,"DejaVu Sans",sans-serif;color:#1b2430;background:#fff;margin:2rem auto;max-width:78rem;padding:0 1.5rem}
h1{font-size:1.6rem;margin:0}h2{font-size:1.15rem;margin:2.2rem 0 .6rem}p{margin:.3rem 0}.dim{color:#566273}
.counts{display:flex;gap:2.2rem;margin:1.2rem 0 0;padding:0;list-style:none}.counts b{display:block;font-size:1.7rem;line-height:1.2}
.wide{overflow-x:auto}table{border-collapse:collapse;width:100%}
th,td{text-align:left;padding:.3rem .7rem .3rem 0;border-bottom:1px solid #e3e8ee;vertical-align:top}
th{font-weight:600;color:#566273;font-size:.85rem;vertical-align:bottom}td.n,th.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
a{color:#0b5fa5}.measured{color:#1c7a3e}.damaged,.nothing{color:#8f5a00}.failed{color:#b3261e}.waiting{color:#566273}
.plots{display:flex;flex-wrap:wrap;gap:1.2rem 2rem}svg text{font:12px system-ui,"DejaVu Sans",sans-serif;fill:#1b2430}
svg text.name{font-weight:600;font-size:13px}svg text.dim{fill:#566273}svg .grid{stroke:#e3e8ee}
td.name{white-space:nowrap}td.word{overflow-wrap:anywhere}
)";

struct Result {
  const char* word;
  const char* meaning;
};
constexpr Result kResults[] = {
    {batch_result::kMeasured, "measured to the end"},
    {batch_result::kDamaged, "broken off: measured up to the damage"},
    {batch_result::kNothing, "without a cell in any frame"},
    {batch_result::kFailed, "failed"},
    {batch_result::kWaiting, "not analysed yet"},
};

std::string cell(const std::string& html, bool number = false) {
  return (number ? "<td class=\"n\">" : "<td>") + html + "</td>";
}

std::string number_cell(double value, int digits) {
  return cell(fixed_number(value, digits), true);
}

std::string name_cell(const BatchRow& row) {
  const std::string name = html_text(row.name);
  return "<td class=\"name\">" +
         (row.session.empty() ? name : "<a href=\"" + html_link(row.session) + "/\">" + name + "</a>") + "</td>";
}

std::string result_cell(const BatchRow& row) {
  return "<td class=\"" + row.result + "\">" + row.result + "</td>";
}

std::string counts(std::span<const BatchRow> rows) {
  std::string html = "<ul class=\"counts\">";
  for (const Result& result : kResults) {
    const auto count =
        std::count_if(rows.begin(), rows.end(), [&](const auto& row) { return row.result == result.word; });
    if (count == 0) continue;
    html += "<li class=\"" + std::string(result.word) + "\"><b>" + std::to_string(count) + "</b>" + result.meaning +
            "</li>";
  }
  return html + "</ul>\n";
}

std::string failures(std::span<const BatchRow> rows) {
  std::string html;
  for (const BatchRow& row : rows) {
    if (row.error.empty()) continue;
    html += "<tr>" + name_cell(row) + result_cell(row) + number_cell(row.exit_code, 0) + "<td class=\"word\">" +
            html_text(row.error) + "</td></tr>\n";
  }
  if (html.empty()) return {};
  return "<h2>What went wrong</h2>\n<div class=\"wide\"><table><thead><tr><th>recording</th><th>result</th>"
         "<th class=\"n\">exit code</th><th>in words</th></tr></thead>\n<tbody>" +
         html + "</tbody></table></div>\n";
}

std::string plots(std::span<const BatchRow> rows, const std::vector<std::string>& groups) {
  std::string html;
  for (const GroupQuantity& quantity : group_quantities()) {
    std::vector<BoxSample> samples;
    for (const std::string& group : groups) samples.push_back({group, values_in(rows, group, quantity)});
    html += box_plot_svg(std::string(quantity.title), samples);
  }
  return "<div class=\"plots\">\n" + html + "</div>\n";
}

std::string interval(double value, double lower, double upper) {
  if (std::isnan(value)) return "–";
  if (std::isnan(lower)) return fixed_number(value, 2);
  return fixed_number(value, 2) + " <span class=\"dim\">[" + fixed_number(lower, 2) + ", " + fixed_number(upper, 2) +
         "]</span>";
}

std::string group_table(std::span<const GroupRow> groups) {
  std::string html =
      "<div class=\"wide\"><table><thead><tr><th>quantity</th><th>group</th><th class=\"n\">n</th><th "
      "class=\"n\">median</th>"
      "<th class=\"n\">quartiles</th><th class=\"n\">Hedges&#39; g</th><th class=\"n\">Cliff&#39;s "
      "delta</th></tr></thead>\n"
      "<tbody>";
  std::string before;
  for (const GroupRow& row : groups) {
    html += "<tr>" + cell(row.quantity == before ? "" : html_text(row.quantity)) + cell(html_text(row.group)) +
            cell(std::to_string(row.count), true) + number_cell(row.median, 3) +
            cell(fixed_number(row.lower_quartile, 3) + " to " + fixed_number(row.upper_quartile, 3), true) +
            cell(interval(row.hedges_g, row.hedges_g_lower, row.hedges_g_upper), true) +
            cell(interval(row.cliffs_delta, row.cliffs_delta_lower, row.cliffs_delta_upper), true) + "</tr>\n";
    before = row.quantity;
  }
  return html + "</tbody></table></div>\n";
}

std::string group_part(std::span<const BatchRow> rows, std::span<const GroupRow> groups) {
  if (groups.empty()) return {};
  std::vector<std::string> names;
  for (const GroupRow& row : groups) {
    if (row.quantity == groups.front().quantity) names.push_back(row.group);
  }
  return "<h2>Groups</h2>\n<p class=\"dim\">Boxes: quartiles and median; whiskers: to the farthest value within 1.5 "
         "boxes; "
         "dots: recordings. Hedges&#39; g and Cliff&#39;s delta compare each group with <b>" +
         html_text(names.front()) + "</b>, with 95&nbsp;% bootstrap intervals from " +
         "4 recordings a group on. <a href=\"groups.csv\">groups.csv</a></p>\n" + plots(rows, names) +
         group_table(groups);
}

std::string recordings(std::span<const BatchRow> rows) {
  std::string html =
      "<h2>Recordings</h2>\n<p class=\"dim\">A name leads to the recording&#39;s session. All numbers: <a "
      "href=\"summary.csv\">summary.csv</a></p>\n<div class=\"wide\"><table><thead><tr><th>recording</th><th>group</th>"
      "<th>result</th><th class=\"n\">frames</th><th class=\"n\">duration<br>s</th><th class=\"n\">measured<br>%</th>"
      "<th class=\"n\">peak force<br>µN</th><th class=\"n\">95 % interval<br>µN</th><th class=\"n\">picture; "
      "scale<br>σ, %</th>"
      "<th class=\"n\">at depth<br>µm</th>"
      "<th class=\"n\">puncture<br>µN</th><th class=\"n\">at depth<br>µm</th><th>warnings</th>"
      "<th class=\"n\">analysis<br>s</th></tr></thead>\n<tbody>";
  for (const BatchRow& row : rows) {
    const RecordingSummary& s = row.numbers;
    const bool measured = !row.session.empty();
    html +=
        "<tr>" + name_cell(row) + cell(html_text(row.group)) + result_cell(row) +
        cell(measured ? std::to_string(s.frame_count) : "–", true) + number_cell(s.duration_s, 2) +
        number_cell(100.0 * s.measured_share, 0) + number_cell(s.peak_force_uN, 2) +
        cell(std::isnan(s.peak_force_lower_uN)
                 ? "–"
                 : fixed_number(s.peak_force_lower_uN, 2) + " to " + fixed_number(s.peak_force_upper_uN, 2),
             true) +
        cell(std::isnan(s.peak_scale_sigma_percent)
                 ? "–"
                 : fixed_number(s.peak_picture_sigma_percent, 0) + "; " + fixed_number(s.peak_scale_sigma_percent, 0),
             true) +
        number_cell(s.peak_depth_um, 1) + number_cell(s.puncture_force_uN, 2) + number_cell(s.puncture_depth_um, 1) +
        cell(html_text(s.warnings)) + number_cell(row.wall_time_s, 1) + "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

// "200 recordings, 812 s of film, analysed at 3.1 times real time in one process"
std::string extent(std::span<const BatchRow> rows) {
  double film_s = 0.0, wall_s = 0.0;
  for (const BatchRow& row : rows) {
    if (std::isnan(row.speed_ratio)) continue;
    film_s += row.numbers.duration_s;
    wall_s += row.wall_time_s;
  }
  std::string text = std::to_string(rows.size()) + (rows.size() == 1 ? " recording" : " recordings");
  if (wall_s > 0.0) {
    text += ", " + fixed_number(film_s, 0) + " s of film; a process analyses " + fixed_number(film_s / wall_s, 2) +
            " s of it in a second";
  }
  return text;
}

}  // namespace

std::string overview_page(const std::string& title, std::span<const BatchRow> rows, std::span<const GroupRow> groups) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         html_text(title) + "</title>\n<style>" + kStyle + "</style></head>\n<body>\n<h1>" + html_text(title) +
         "</h1>\n<p class=\"dim\">" + extent(rows) + "</p>\n" + counts(rows) + failures(rows) +
         group_part(rows, groups) + recordings(rows) + "</body>\n</html>\n";
}

}  // namespace pellucida
