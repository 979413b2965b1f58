#include "SourceCalibration.h"

#include "pellucida/acquisition/StatedRange.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

struct Range {
  const char* option;
  StatedRange stated;
  const char* unit;
};
constexpr Range kPixelSize{"--pixel-size-um", kStatedPixelSize_um, "micrometres a pixel"};
constexpr Range kFrameRate{"--fps", kStatedFrameRate_hz, "frames a second"};

void check(const std::optional<double>& value, const Range& range) {
  // Written so that NaN fails too.
  if (!value || (*value >= range.stated.lower && *value <= range.stated.upper)) return;
  const std::string number = csv_number(*value);
  throw UsageError(std::string(range.option) + " " + (number.empty() ? "nan" : number) + ": out of range; give " +
                   csv_number(range.stated.lower) + " to " + csv_number(range.stated.upper) + " " + range.unit);
}

void settle(const std::string& name, const char* what, const Range& range, const std::optional<double>& option,
            const std::optional<double>& metadata, double& value, std::string& origin) {
  if (option) {
    value = *option;
    origin = "option";
  } else if (metadata) {
    value = *metadata;
    origin = "metadata";
  } else {
    throw UsageError(name + ": " + what + " unknown; give " + range.option + " (" + range.unit + ")");
  }
}

}  // namespace

void check_options(const SourceOptions& options) {
  check(options.pixel_size_um, kPixelSize);
  check(options.frame_rate_hz, kFrameRate);
}

void settle_pixel_size(SourceInfo& info, const SourceOptions& options, const PhysicalSize& metadata) {
  settle(info.name, "pixel size", kPixelSize, options.pixel_size_um, metadata.pixel_size_um, info.pixel_size_um,
         info.pixel_size_origin);
}

void settle_frame_rate(SourceInfo& info, const SourceOptions& options, const PhysicalSize& metadata) {
  settle(info.name, "frame rate", kFrameRate, options.frame_rate_hz, metadata.frame_rate_hz, info.frame_rate_hz,
         info.frame_rate_origin);
}

}  // namespace pellucida
