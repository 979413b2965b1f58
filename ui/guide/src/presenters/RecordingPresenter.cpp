#include "presenters/RecordingPresenter.h"

#include <ctime>

namespace pellucida {

RecordingPresenter::RecordingPresenter(std::filesystem::path wanted, std::filesystem::path home)
    : wanted_(std::move(wanted)), home_(std::move(home)) {}

std::filesystem::path RecordingPresenter::next_folder(const std::string& stamp) {
  ++count_;
  if (wanted_.empty()) return home_ / "Pellucida" / stamp;
  if (count_ == 1) return wanted_;
  std::filesystem::path numbered = wanted_;
  numbered += "-";
  numbered += std::to_string(count_);
  return numbered;
}

std::filesystem::path RecordingPresenter::picture_file(const std::string& stamp) const {
  return home_ / "Pellucida" / ("picture-" + stamp + ".png");
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
