#include <algorithm>
#include <cmath>

#include "pellucida/core/Table.h"
#include "pellucida/report/CellPassport.h"
#include "pellucida/report/PassportReport.h"

namespace pellucida {
namespace {

using C = ContactPassport;
using Cell = CellPassport;
constexpr FieldRange kAny;
constexpr const char* kLower = "lower end of its 95 % interval";
constexpr const char* kUpper = "upper end of its 95 % interval";

constexpr PassportField<Cell> kCellFields[] = {
    {{"session", "", &Cell::session, kAny, "name of the session's folder"}, "Session"},
    {{"profile", "", &Cell::profile, kAny, "cell profile that the forces are for"}, "Profile"},
    {{"cell", "", &Cell::cell, kAny, "number of the cell in the session, from 1"}, "Cell"},
    {{"found_s", "s", &Cell::found_s, kAny, "when it was first seen"}, "First seen"},
    {{"last_seen_s", "s", &Cell::last_seen_s, kAny, "when it was last seen"}, "Last seen"},
    {{"radius_um", "um", &Cell::radius_um, kAny,
      "radius of a sphere of the volume enclosed by the outer membrane; median of the frames without contact"},
     "Radius at rest"},
    {{"losses", "", &Cell::losses, kAny, "how often it was lost from view"}, "Lost from view"},
    {{"contacts", "", &Cell::contacts, kAny, "contacts of the needle with it"}, "Contacts"},
    {{"cell_doubts", "", &Cell::cell_doubts, kAny, "what speaks against the cell as a whole, in words"}, "Doubts"},
};

constexpr PassportField<C> kContactFields[] = {
    {{"cell", "", &C::cell, kAny, "number of the cell"}, "Cell"},
    {{"contact", "", &C::contact, kAny, "number of the contact with this cell, from 1; 0 for a cell not touched"},
     "Contact"},
    {{"outcome", "", &C::outcome, kAny,
      "how it ended: `punctured`, `retracted`, `lost` (the cell was lost in contact), `unfinished` (the recording of "
      "the "
      "cell ends in contact), `untouched`"},
     "Outcome"},
    {{"frames", "", &C::frames, kAny, "frames from the touch to the last one in contact"},
     "Frames in contact",
     "Contact"},
    {{"unmeasured_frames", "", &C::unmeasured_frames, kAny, "of these, recorded but not measured"}, "Not measured"},
    {{"confidence", "0..1", &C::confidence, kAny, "confidence in the frames in contact, median"}, "Confidence"},
    {{"touch_s", "s", &C::touch_s, kAny, "first frame in contact; the tracker notices a contact after about 1 um"},
     "Touch"},
    {{"release_s", "s", &C::release_s, kAny, "first frame after it with the needle off the cell"}, "Release"},
    {{"dwell_s", "s", &C::dwell_s, kAny,
      "from the touch to the release, or to the last frame in contact where no release was seen"},
     "Time in contact"},
    {{"inside_s", "s", &C::inside_s, kAny, "of that, after the puncture"}, "Time inside the cell"},
    {{"peak_force_uN", "uN", &C::peak_force_uN, kAny, "largest contact force, before the puncture if there is one"},
     "Peak force",
     "Force"},
    {{"peak_force_lower_uN", "uN", &C::peak_force_lower_uN, kAny, kLower}, ""},
    {{"peak_force_upper_uN", "uN", &C::peak_force_upper_uN, kAny, kUpper}, ""},
    {{"peak_force_depth_um", "um", &C::peak_force_depth_um, kAny, "indentation in that frame"}, "Depth at peak force"},
    {{"peak_force_s", "s", &C::peak_force_s, kAny, "time of that frame"}, "Time of peak force"},
    {{"picture_sigma_percent", "%", &C::picture_sigma_percent, kAny,
      "what the picture leaves open of that force (depth, sizes, model): standard deviation over the force; between "
      "forces on the same cell nothing else counts"},
     "Open by the picture"},
    {{"scale_sigma_percent", "%", &C::scale_sigma_percent, kAny,
      "what the scale leaves open: how single cells of the kind differ, or what is left of it once this cell's scale "
      "was measured; one factor on all its forces, works and stiffnesses"},
     "Open by the scale"},
    {{"largest_depth_um", "um", &C::largest_depth_um, kAny, "largest indentation, before the puncture if there is one"},
     "Largest depth"},
    {{"largest_pressure_Pa", "Pa", &C::largest_pressure_Pa, kAny, "largest excess pressure inside the cell"},
     "Largest pressure"},
    {{"work_pJ", "pJ", &C::work_pJ, kAny,
      "work of the needle on the cell from the touch to the largest depth: integral of the force over the indentation; "
      "1 pJ = 1 uN um"},
     "Work to the largest depth"},
    {{"work_lower_pJ", "pJ", &C::work_lower_pJ, kAny, kLower}, ""},
    {{"work_upper_pJ", "pJ", &C::work_upper_pJ, kAny, kUpper}, ""},
    {{"puncture_s", "s", &C::puncture_s, kAny, "first frame that shows the puncture"}, "Puncture", "Puncture"},
    {{"puncture_force_uN", "uN", &C::puncture_force_uN, kAny,
      "largest contact force of the last 0.25 s before the puncture"},
     "Force at puncture"},
    {{"puncture_force_lower_uN", "uN", &C::puncture_force_lower_uN, kAny, kLower}, ""},
    {{"puncture_force_upper_uN", "uN", &C::puncture_force_upper_uN, kAny, kUpper}, ""},
    {{"puncture_depth_um", "um", &C::puncture_depth_um, kAny, "indentation in that frame"}, "Depth at puncture"},
    {{"puncture_work_pJ", "pJ", &C::puncture_work_pJ, kAny,
      "work from the touch to the last frame before the puncture"},
     "Work at puncture"},
    {{"puncture_work_lower_pJ", "pJ", &C::puncture_work_lower_pJ, kAny, kLower}, ""},
    {{"puncture_work_upper_pJ", "pJ", &C::puncture_work_upper_pJ, kAny, kUpper}, ""},
    {{"drop_uN", "uN", &C::drop_uN, kAny,
      "force at puncture less the force of the frame that shows it; the program takes that as 0, so that the two are "
      "equal in sessions of this version"},
     "Drop of the force"},
    {{"drop_lower_uN", "uN", &C::drop_lower_uN, kAny, kLower}, ""},
    {{"drop_upper_uN", "uN", &C::drop_upper_uN, kAny, kUpper}, ""},
    {{"spring_back_um", "um", &C::spring_back_um, kAny,
      "how far the membrane has come back in the frame that shows the puncture"},
     "Membrane springs back"},
    {{"stiffness_5um_uN_per_um", "uN/um", &C::stiffness_5um_uN_per_um, kAny,
      "slope of the force over the indentation at 5 um, on the way in: the median of the slopes between all pairs of "
      "frames within 2.5 um (Theil and Sen); empty where the needle came no deeper than 6 um, or five frames are not "
      "there"},
     "Stiffness at 5 um",
     "Stiffness and hysteresis"},
    {{"stiffness_5um_lower_uN_per_um", "uN/um", &C::stiffness_5um_lower_uN_per_um, kAny, kLower}, ""},
    {{"stiffness_5um_upper_uN_per_um", "uN/um", &C::stiffness_5um_upper_uN_per_um, kAny, kUpper}, ""},
    {{"stiffness_10um_uN_per_um", "uN/um", &C::stiffness_10um_uN_per_um, kAny, "the same at 10 um"},
     "Stiffness at 10 um"},
    {{"stiffness_10um_lower_uN_per_um", "uN/um", &C::stiffness_10um_lower_uN_per_um, kAny, kLower}, ""},
    {{"stiffness_10um_upper_uN_per_um", "uN/um", &C::stiffness_10um_upper_uN_per_um, kAny, kUpper}, ""},
    {{"stiffness_20um_uN_per_um", "uN/um", &C::stiffness_20um_uN_per_um, kAny, "the same at 20 um"},
     "Stiffness at 20 um"},
    {{"stiffness_20um_lower_uN_per_um", "uN/um", &C::stiffness_20um_lower_uN_per_um, kAny, kLower}, ""},
    {{"stiffness_20um_upper_uN_per_um", "uN/um", &C::stiffness_20um_upper_uN_per_um, kAny, kUpper}, ""},
    {{"stiffness_30um_uN_per_um", "uN/um", &C::stiffness_30um_uN_per_um, kAny, "the same at 30 um"},
     "Stiffness at 30 um"},
    {{"stiffness_30um_lower_uN_per_um", "uN/um", &C::stiffness_30um_lower_uN_per_um, kAny, kLower}, ""},
    {{"stiffness_30um_upper_uN_per_um", "uN/um", &C::stiffness_30um_upper_uN_per_um, kAny, kUpper}, ""},
    {{"stiffness_40um_uN_per_um", "uN/um", &C::stiffness_40um_uN_per_um, kAny, "the same at 40 um"},
     "Stiffness at 40 um"},
    {{"stiffness_40um_lower_uN_per_um", "uN/um", &C::stiffness_40um_lower_uN_per_um, kAny, kLower}, ""},
    {{"stiffness_40um_upper_uN_per_um", "uN/um", &C::stiffness_40um_upper_uN_per_um, kAny, kUpper}, ""},
    {{"strain_stiffening", "", &C::strain_stiffening, kAny,
      "how the zona stiffens with strain, b of its law, by the last contours of the contact; see `measurements.csv`"},
     "Strain stiffening b"},
    {{"strain_stiffening_lower", "", &C::strain_stiffening_lower, kAny, kLower}, ""},
    {{"strain_stiffening_upper", "", &C::strain_stiffening_upper, kAny, kUpper}, ""},
    {{"hysteresis_pJ", "pJ", &C::hysteresis_pJ, kAny,
      "area between the curves of insertion and removal; only for a contact that ended without a puncture. Under a "
      "profile that does not relax the force depends on the depth alone, and this shows errors of measurement"},
     "Hysteresis"},
    {{"hysteresis_lower_pJ", "pJ", &C::hysteresis_lower_pJ, kAny, kLower}, ""},
    {{"hysteresis_upper_pJ", "pJ", &C::hysteresis_upper_pJ, kAny, kUpper}, ""},
    {{"approach_speed_um_per_s", "um/s", &C::approach_speed_um_per_s, kAny,
      "mean speed of the tip towards the cell in the half second before the touch"},
     "Approach speed",
     "Needle"},
    {{"insertion_speed_um_per_s", "um/s", &C::insertion_speed_um_per_s, kAny,
      "the same from the touch to the puncture, or to the largest depth"},
     "Insertion speed"},
    {{"removal_speed_um_per_s", "um/s", &C::removal_speed_um_per_s, kAny,
      "mean speed of the tip outwards, from its deepest place to the last frame in contact"},
     "Removal speed"},
    {{"largest_area_strain_percent", "%", &C::largest_area_strain_percent, kAny,
      "largest area strain of the whole outer membrane: its area against that of the sphere at rest, less 1"},
     "Largest area strain",
     "Membrane"},
    {{"largest_mean_tension_uN_per_um", "uN/um", &C::largest_mean_tension_uN_per_um, kAny,
      "largest mean tension of the outer membrane, weighted by area"},
     "Largest mean tension"},
    {{"largest_tension_uN_per_um", "uN/um", &C::largest_tension_uN_per_um, kAny,
      "largest tension of a node of the outer membrane; it lies at the tip and depends on the mesh there"},
     "Largest tension at a node"},
    {{"deposit_s", "s", &C::deposit_s, kAny, "how long the hand deposited; empty where no hand was recorded"},
     "Deposit, duration",
     "Deposit"},
    {{"first_deposit_s", "s", &C::first_deposit_s, kAny, "when it began"}, "Deposit, begin"},
    {{"doubts", "", &C::doubts, kAny, "what speaks against these numbers, in words"}, "Doubts"},
    {{"cell_name", "", &C::cell_name, kAny, "the cell's name, as it was given in the window"}, "Name"},
};

// A field's value as a CSV cell; empty for what is not there.
template <class S>
std::string cell_of(const Field<S>& field, const S& passport) {
  return std::visit(
      [&](auto member) -> std::string {
        const auto& value = passport.*member;
        using T = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<T, double>) return std::isfinite(value) ? csv_number(value) : std::string();
        if constexpr (std::is_same_v<T, std::string>) return csv_cell(value);
        if constexpr (std::is_integral_v<T>) return std::to_string(value);
      },
      field.member);
}

// `cells.csv` has the number of the cell once.
bool is_in_cell_table(const PassportField<C>& field) {
  return field.field.name != "cell";
}

void append(std::string& line, std::string_view cell) {
  if (!line.empty()) line += ',';
  line += cell;
}

}  // namespace

std::span<const PassportField<CellPassport>> cell_fields() noexcept {
  return kCellFields;
}

std::span<const PassportField<ContactPassport>> contact_fields() noexcept {
  return kContactFields;
}

std::string cells_csv(std::span<const CellPassport> cells) {
  std::string text;
  for (const auto& field : kCellFields) append(text, field.field.name);
  for (const auto& field : kContactFields)
    if (is_in_cell_table(field)) append(text, field.field.name);
  text += '\n';
  for (const CellPassport& cell : cells) {
    std::string line;
    for (const auto& field : kCellFields) {
      if (&field != kCellFields) line += ',';
      line += cell_of(field.field, cell);
    }
    // A cell that was not touched has its name all the same.
    ContactPassport main = cell.main_contact();
    main.cell_name = cell.name;
    for (const auto& field : kContactFields)
      if (is_in_cell_table(field)) line += ',' + cell_of(field.field, main);
    text += line + '\n';
  }
  return text;
}

std::string contacts_csv(std::span<const CellPassport> cells) {
  std::string text = "session";
  for (const auto& field : kContactFields) append(text, field.field.name);
  text += '\n';
  for (const CellPassport& cell : cells) {
    for (const ContactPassport& contact : cell.contact_list) {
      text += csv_cell(cell.session);
      for (const auto& field : kContactFields) text += ',' + cell_of(field.field, contact);
      text += '\n';
    }
  }
  return text;
}

}  // namespace pellucida
