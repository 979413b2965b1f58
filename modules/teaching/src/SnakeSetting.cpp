#include "pellucida/teaching/SnakeSetting.h"

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr Field<SnakeSetting> kSnakeSetting[] = {
    {"picture", "", &SnakeSetting::picture, {}, "`virtual:SCENARIO`, or a session's folder"},
    {"time_s", "s", &SnakeSetting::time_s, {0, 100000}, "of the frame in it"},
    {"start_x_um", "um", &SnakeSetting::start_x_um, {0, 100000}, "middle of the circle that the snake begins on"},
    {"start_y_um", "um", &SnakeSetting::start_y_um, {0, 100000}, "the same, downwards"},
    {"start_radius_um", "um", &SnakeSetting::start_radius_um, {2, 10000}, "its radius"},
    {"runs", "", &SnakeSetting::runs, {}, "true: it runs from the beginning, without a key"},
};

}  // namespace

FieldList fields_of(SnakeSetting& setting) {
  FieldList list = fields_of(setting.parameters);
  list.add("", kSnakeSetting, setting);
  return list;
}

void require_valid(const SnakeSetting& setting) {
  SnakeSetting copy = setting;
  if (const auto fault = range_fault(fields_of(copy))) throw UsageError(*fault);
  require_valid(setting.parameters);
}

}  // namespace pellucida
