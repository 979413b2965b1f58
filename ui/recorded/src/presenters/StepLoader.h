#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "pellucida/core/Clock.h"
#include "pellucida/core/SharedLatest.h"
#include "pellucida/core/Stage.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/session/SessionReader.h"

namespace pellucida {

/// A step as it was read. `error`: why a file of it can't be read; the scene then holds its recorded row alone.
struct LoadedStep {
  std::size_t step = 0;
  Scene scene;
  std::string error;
};

/// Reads steps of a session on a thread of its own. The newest request wins: what was asked for before and not begun is
/// left out. All calls from one thread.
class StepLoader {
 public:
  /// Takes over the reader.
  explicit StepLoader(SessionReader reader);
  ~StepLoader();

  void request(std::size_t step);
  /// The newest step read, once; nothing while there is no newer one than before.
  std::optional<LoadedStep> take();
  /// Whether the last request is still to come.
  bool busy() const noexcept { return requested_ != taken_; }

 private:
  struct ReadStep {
    using Input = std::size_t;
    using Output = LoadedStep;
    SessionReader reader;
    expected<LoadedStep, StepFailure> process(const std::size_t& step);
  };

  ReadStep read_;
  SteadyClock clock_;
  SharedLatest<std::size_t> requests_;
  SharedLatest<std::shared_ptr<const LoadedStep>> results_;
  std::uint64_t sequence_ = 0;
  std::optional<std::size_t> requested_;
  std::optional<std::size_t> taken_;
  Stage<ReadStep, SharedLatest<std::size_t>> stage_;
};

}  // namespace pellucida
