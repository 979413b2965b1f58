#include "Rereading.h"

#include <chrono>
#include <cstring>
#include <utility>

#include "SceneVerdict.h"
#include "pellucida/core/Background.h"

namespace pellucida {
namespace {

// What follows tracking in the frame that asked takes a third of that.
constexpr std::chrono::milliseconds kHeadStart{3};

}  // namespace

void Rereading::ask(const ImageView& image, const CellFollower& by_lines) {
  const std::size_t row_bytes =
      (image.format == PixelFormat::kGray8 ? 1U : 2U) * static_cast<std::size_t>(image.width_px);
  pixels_.resize(row_bytes * static_cast<std::size_t>(image.height_px));
  for (int y = 0; y < image.height_px; ++y) {
    std::memcpy(pixels_.data() + static_cast<std::size_t>(y) * row_bytes,
                static_cast<const unsigned char*>(image.data) + y * image.row_bytes, row_bytes);
  }
  image_ = image;
  image_.data = pixels_.data();
  image_.row_bytes = static_cast<std::ptrdiff_t>(row_bytes);
  outline_ = outline_of(by_lines);
  needle_ = by_lines.needle();
  if (!thread_.joinable()) thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  {
    const std::scoped_lock lock(mutex_);
    stage_ = Stage::kAsked;
    is_awaited_ = false;
  }
  changed_.notify_all();
}

void Rereading::wait_for_answer(std::unique_lock<std::mutex>& lock) {
  is_awaited_ = true;
  changed_.notify_all();
  changed_.wait(lock, [this] { return stage_ != Stage::kAsked; });
}

std::optional<Rereading::Answer> Rereading::take() {
  std::unique_lock lock(mutex_);
  if (stage_ == Stage::kIdle) return std::nullopt;
  wait_for_answer(lock);
  stage_ = Stage::kIdle;
  if (fault_) std::rethrow_exception(std::exchange(fault_, nullptr));
  return answer_;
}

void Rereading::drop() {
  std::unique_lock lock(mutex_);
  wait_for_answer(lock);
  stage_ = Stage::kIdle;
  fault_ = nullptr;
}

void Rereading::run(const std::stop_token& stop) {
  work_in_background();
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [this] { return stage_ == Stage::kAsked; })) return;
      changed_.wait_for(lock, stop, kHeadStart, [this] { return is_awaited_; });
      if (stop.stop_requested()) return;
    }
    try {
      const FrameSampler image(image_);
      answer_ = {is_outline_read(outline_, image, reader_.boundaries()), needle_.is_where_read(reader_.tips(), image)};
    } catch (const std::exception&) {
      fault_ = std::current_exception();
    }
    {
      const std::scoped_lock lock(mutex_);
      stage_ = Stage::kAnswered;
    }
    changed_.notify_all();
  }
}

}  // namespace pellucida
