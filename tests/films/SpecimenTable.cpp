#include "films/SpecimenTable.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>

namespace pellucida::test {
namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return -1.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

void print_row(const std::string& name, const std::vector<const FilmRun*>& runs) {
  if (runs.empty()) return;
  std::vector<double> given, bias, own, palpated;
  double measured = 0, covered = 0, whole = 0, wide = 0;
  for (const FilmRun* run : runs) {
    const SpecimenResult& r = *run->specimen;
    given.push_back(r.given_percent);
    bias.push_back(r.bias_percent);
    own.push_back(run->true_sight_percent);
    if (r.palpated_percent >= 0) palpated.push_back(r.palpated_percent);
    measured += run->measured_count;
    covered += run->covered_count;
    whole += r.in_whole * run->measured_count;
    wide += r.in_wide * run->measured_count;
  }
  std::printf("%-28s %5zu | %6.1f %6.1f %+7.1f | %6.1f %6.1f | %6.1f %6.1f | %6.1f %6.1f %6.1f\n", name.c_str(),
              runs.size(), quantile(given, 0.5), quantile(given, 0.95), quantile(bias, 0.5), quantile(own, 0.5),
              quantile(own, 0.95), quantile(palpated, 0.5), quantile(palpated, 0.95), 100 * covered / measured,
              100 * whole / measured, 100 * wide / measured);
}

struct Kind {
  const char* name;
  std::vector<double> borders;
  std::function<double(const SpecimenResult&)> value;
};

}  // namespace

void print_by_specimen(const std::vector<FilmRun>& runs) {
  std::vector<const FilmRun*> all;
  for (const FilmRun& run : runs)
    if (run.specimen && run.specimen->given_percent >= 0) all.push_back(&run);
  std::printf("%-28s %5s | %6s %6s %7s | %6s %6s | %6s %6s | %6s %6s %6s\n", "RMS, % of peak; frames in %", "films",
              "given", "95 %", "bias", "sight", "95 %", "push", "95 %", "pict.", "kind", "x10");
  print_row("ALL", all);
  const Kind kinds[] = {
      {"h/R",
       {0, 0.08, 0.13, 0.2, kAny},
       [](const auto& r) { return r.specimen.thickness_um / r.specimen.middle_radius_um; }},
      {"a/R",
       {0, 0.03, 0.06, 0.1, kAny},
       [](const auto& r) { return r.specimen.tip_radius_um / r.specimen.middle_radius_um; }},
      {"holder/R",
       {0, 0.3, 0.45, 0.6, kAny},
       [](const auto& r) {
         return (r.specimen.holder_ring_um + r.specimen.holder_half_width_um) / r.specimen.middle_radius_um;
       }},
      {"deepest/R", {0, 0.2, 0.4, 0.6, kAny}, [](const auto& r) { return r.deepest_ratio; }},
      {"length/width", {0, 0.95, 0.9999, 1.0001, 1.05, kAny}, [](const auto& r) { return r.specimen.aspect_ratio; }},
      {"suction/modulus",
       {0, 1e-9, 0.003, kAny},
       [](const auto& r) { return r.specimen.suction_kPa / r.specimen.young_modulus_kPa; }},
      {"stiffening", {0, 1e-9, 0.15, kAny}, [](const auto& r) { return r.specimen.stiffening; }},
      {"holder's angle", {0, 1e-9, 30, 60, kAny}, [](const auto& r) { return r.specimen.holder_angle_deg; }},
      {"offset/R",
       {0, 1e-9, 0.1, kAny},
       [](const auto& r) { return r.specimen.offset_um / r.specimen.middle_radius_um; }},
  };
  for (const Kind& kind : kinds) {
    for (std::size_t k = 0; k + 1 < kind.borders.size(); ++k) {
      std::vector<const FilmRun*> some;
      for (const FilmRun* run : all) {
        const double value = kind.value(*run->specimen);
        if (kind.borders[k] <= value && value < kind.borders[k + 1]) some.push_back(run);
      }
      if (some.size() == all.size()) continue;
      char name[64];
      std::snprintf(name, sizeof name, "%s %.3g to %.3g", kind.name, kind.borders[k], kind.borders[k + 1]);
      print_row(name, some);
    }
  }
}

}  // namespace pellucida::test
