#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pellucida/haptics/HapticDevice.h"

namespace pellucida {

/// The hands that may hold the pipette: the demonstration, mouse and keyboard, the devices found. An index that is out
/// of range is the caller's fault.
class HandCatalog {
 public:
  /// Looks for devices. `demonstration`: offers the simulated operator too, first.
  explicit HandCatalog(bool demonstration);

  /// UTF-8.
  const std::vector<std::string>& names() const noexcept { return names_; }
  /// Index of the first name that starts so; nothing when there is none.
  std::optional<int> find(std::string_view start) const noexcept;

  bool is_demonstration(int index) const { return !choice(index).open; }
  /// Springs back to its centre: rate control.
  bool springs_back(int index) const { return choice(index).springs_back; }
  /// Not of the demonstration. Throws DeviceError where the device can't be opened.
  std::unique_ptr<HapticDevice> open(int index) const { return choice(index).open(); }

 private:
  struct Choice {
    std::function<std::unique_ptr<HapticDevice>()> open;  // empty: the demonstration
    bool springs_back = false;
  };
  void add(std::string name, Choice choice);
  void find_devices();
  const Choice& choice(int index) const { return choices_.at(static_cast<std::size_t>(index)); }

  std::vector<std::string> names_;
  std::vector<Choice> choices_;
};

}  // namespace pellucida
