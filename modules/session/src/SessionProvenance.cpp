#include "SessionProvenance.h"

#include <vtkImageData.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "pellucida/core/Error.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

using ProvenanceJson = nlohmann::ordered_json;

FrameStretches stretches_from(const ProvenanceJson& used, const char* key) {
  return FrameStretches::of(used.at(key).get<std::vector<std::pair<long, long>>>());
}

}  // namespace

void FrameStretches::add(long frame_index, bool in_set) {
  if (in_set && open_) {
    stretches_.back().second = frame_index;
  } else if (in_set) {
    stretches_.emplace_back(frame_index, frame_index);
  }
  open_ = in_set;
}

bool FrameStretches::holds(long frame_index) const noexcept {
  const auto after = std::upper_bound(stretches_.begin(), stretches_.end(), frame_index,
                                      [](long frame, const auto& stretch) { return frame < stretch.first; });
  return after != stretches_.begin() && frame_index <= std::prev(after)->second;
}

FrameStretches FrameStretches::of(std::vector<std::pair<long, long>> stretches) {
  FrameStretches set;
  set.stretches_ = std::move(stretches);
  return set;
}

void ProvenanceLog::add(const Scene& scene) {
  const Measurement& row = scene.measurement;
  used_.tracked.add(row.frame, row.state.has_value());
  used_.measured.add(row.frame, row.state.has_value() && scene.contact.frame_index == row.frame);
  if (scene.run_index != run_index_) used_.run_starts.push_back(row.frame);
  run_index_ = scene.run_index;
  if (!scene.frame) return;

  // The pixels alone, after the frame's number and size: the same for a video and for a session made of it.
  const ImageView image = view_of(scene.frame.get());
  const std::array<std::int64_t, 4> head{row.frame, image.width_px, image.height_px,
                                         image.format == PixelFormat::kGray16 ? 16 : 8};
  pixels_.add(head.data(), sizeof head);
  const std::size_t row_bytes =
      static_cast<std::size_t>(image.width_px) * (image.format == PixelFormat::kGray16 ? 2 : 1);
  const auto* pixels = static_cast<const std::uint8_t*>(image.data);
  for (int y = 0; y < image.height_px; ++y) pixels_.add(pixels + y * image.row_bytes, row_bytes);
  ++image_count_;
}

std::string ProvenanceLog::merged_into(const std::string& provenance_json) const {
  ProvenanceJson json = ProvenanceJson::parse(provenance_json, nullptr, false);
  if (!json.is_object()) json = ProvenanceJson::object();
  json["frames_used"] = {{"tracked", used_.tracked.stretches()},
                         {"measured", used_.measured.stretches()},
                         {"run_starts", used_.run_starts}};
  json["frames_sha256"] = image_count_ > 0 ? ProvenanceJson(pixels_.hex()) : ProvenanceJson(nullptr);
  return json.dump();
}

std::optional<FramesUsed> frames_used_of(const SessionInfo& info) {
  const ProvenanceJson json = ProvenanceJson::parse(info.provenance_json, nullptr, false);
  if (!json.is_object() || !json.contains("frames_used")) return std::nullopt;
  try {
    const ProvenanceJson& used = json.at("frames_used");
    return FramesUsed{stretches_from(used, "tracked"), stretches_from(used, "measured"),
                      used.at("run_starts").get<std::vector<long>>()};
  } catch (const nlohmann::json::exception& error) {
    throw InputError("session.json: provenance.frames_used is damaged (" + std::string(error.what()) +
                     "); without that key every frame counts as used");
  }
}

}  // namespace pellucida
