#include "presenters/SourcePresenter.h"

#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {

std::string source_label(const SourceInfo& info) {
  // A folder may be named with a slash at its end.
  std::string name = info.name;
  while (name.size() > 1 && name.back() == '/') name.pop_back();
  const std::size_t slash = name.rfind('/');
  return slash == std::string::npos || slash + 1 == name.size() ? name : name.substr(slash + 1);
}

std::string window_title(const SourceInfo& info) {
  return say("Pellucida - ") + source_label(info);
}

std::string source_caption(const SourceInfo& info) {
  std::string text = std::to_string(info.width_px) + " \u00D7 " + std::to_string(info.height_px) + " px  \u00B7  " +
                     readout::plain(info.pixel_size_um) + " µm/px";
  if (info.frame_rate_hz > 0.0 && info.frame_rate_origin != "still") {
    text += "  \u00B7  " + readout::plain(info.frame_rate_hz) + say(" frames/s");
  }
  return text;
}

}  // namespace pellucida
