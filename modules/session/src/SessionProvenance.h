#pragma once
#include <string>

#include "pellucida/core_vtk/Scene.h"
#include "pellucida/session/FramesUsed.h"
#include "pellucida/session/Sha256.h"

namespace pellucida {

/// What the writer itself knows of where the numbers come from: which frames were used, and their pixels' SHA-256.
class ProvenanceLog {
 public:
  void add(const Scene& scene);

  /// `provenance_json` (an object, or empty) with `frames_used` and `frames_sha256` set.
  std::string merged_into(const std::string& provenance_json) const;

 private:
  FramesUsed used_;
  Sha256 pixels_;
  long image_count_ = 0;
  long run_index_ = 0;
};

}  // namespace pellucida
