#include "presenters/RecordingPresenter.h"

#include <ctime>

namespace pellucida {

RecordingPresenter::RecordingPresenter(std::filesystem::path wanted, std::filesystem::path home)
    : wanted_(std::move(wanted)), place_(std::move(home) / "Pellucida") {}

void RecordingPresenter::set_place(std::filesystem::path place) {
  place_ = std::move(place);
  wanted_.clear();
}

std::filesystem::path RecordingPresenter::place() const {
  return wanted_.empty() ? place_ : std::filesystem::absolute(wanted_).parent_path();
}

std::filesystem::path RecordingPresenter::next_folder(const std::string& stamp) {
  ++count_;
  if (wanted_.empty()) return place_ / stamp;
  if (count_ == 1) return wanted_;
  std::filesystem::path numbered = wanted_;
  numbered += "-";
  numbered += std::to_string(count_);
  return numbered;
}

std::filesystem::path RecordingPresenter::picture_file(const std::string& stamp) const {
  return place_ / ("picture-" + stamp + ".png");
}

std::filesystem::path RecordingPresenter::cells_file(const std::string& stamp) const {
  return place_ / ("cells-" + stamp + ".csv");
}

std::string RecordingPresenter::utc_stamp() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H-%M-%SZ", &utc);
  return text;
}

}  // namespace pellucida
