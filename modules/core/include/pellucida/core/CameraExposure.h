#pragma once

namespace pellucida {

/// How long a camera exposes an image, read and set while it delivers images. Any thread at any time. Every call throws
/// DeviceError when the camera refuses or is lost.
class CameraExposure {
 public:
  struct State {
    double time_ms = 0.0;                  ///< of one image; while automatic, what the camera reports of it
    double least_ms = 0.0, most_ms = 0.0;  ///< what may be set: above 0, at most a period of the frames
    bool automatic = false;                ///< the camera chooses the time itself
    bool has_automatic = false;            ///< it can
  };

  virtual ~CameraExposure() = default;
  virtual State state() const = 0;
  /// Ends the automatic. Out of range: the nearest that may be set.
  virtual void set_time_ms(double time_ms) = 0;
  /// Throws UsageError where the camera has none.
  virtual void set_automatic() = 0;
};

}  // namespace pellucida
