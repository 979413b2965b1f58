#pragma once
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "CellFollower.h"
#include "SceneReader.h"

namespace pellucida {

/// Asks the networks, in frames between two looks at the whole image, whether they read a cell and a needle that lines
/// follow in the same place. That takes them as long as several frames of following: it is asked in one frame, worked
/// out on a thread of its own, and answered in the next, so that no frame waits for it and the answer does not depend
/// on how fast the computer is. Networks take all cores: they begin when the frame has its force, or the next one is
/// there.
class Rereading {
 public:
  struct Answer {
    bool is_same_outline = false;
    bool is_same_needle = false;  ///< also where the network is sure of no tip
  };

  /// Copies image and cell. What was asked before must have been taken or dropped.
  void ask(const ImageView& image, const CellFollower& by_lines);
  /// Waits for it; nothing where nothing was asked. Throws what reading a network threw.
  std::optional<Answer> take();
  /// The cell is another by now.
  void drop();

 private:
  enum class Stage : std::uint8_t { kIdle, kAsked, kAnswered };

  void run(const std::stop_token& stop);
  void wait_for_answer(std::unique_lock<std::mutex>& lock);

  std::vector<std::uint8_t> pixels_;
  ImageView image_;  // over `pixels_`
  Eigen::Matrix2Xd outline_;
  NeedleTracker needle_;
  SceneReader reader_;  // a network serves one thread at a time
  Answer answer_;
  std::exception_ptr fault_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  Stage stage_ = Stage::kIdle;
  bool is_awaited_ = false;
  std::jthread thread_;  // begins with the first question; last: it uses all of the above
};

}  // namespace pellucida
