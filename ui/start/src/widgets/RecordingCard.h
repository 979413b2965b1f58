#pragma once
#include <filesystem>
#include <functional>
#include <optional>

#include "BackgroundTask.h"
#include "presenters/PathJudgement.h"
#include "widgets/StartCard.h"

class QLineEdit;
class QPushButton;

namespace pellucida {

class Choice;

/// A recording or a video: its path, profile, pixel size and frame rate.
class RecordingCard final : public StartCard {
 public:
  struct Actions {
    std::function<void()> start;
    std::function<std::filesystem::path(bool folder)> ask;          ///< a person's answer to a dialog; empty: not now
    std::function<void(const std::filesystem::path&)> has_session;  ///< a path given is a session
  };
  RecordingCard(const StartForm& form, Actions actions);

  /// Takes a path chosen by dialog or drop: looks at it on a thread of its own, and shows what it is. A session is
  /// reported.
  void take(const std::filesystem::path& path);
  /// Of the path shown; nothing while it is not known.
  const std::optional<PathJudgement>& judged() const noexcept { return judged_; }

  void write(StartForm& form) const override;
  using StartCard::show_problem;
  bool show_problem(const StartProblem& problem) override;
  void clear_problems() override;

 private:
  QWidget* build_path_row();
  void measure_pixel_size();
  void look_at(const std::filesystem::path& path, bool report_session);
  void show_judgement(const PathJudgement& judgement);
  void check_numbers();

  Actions actions_;
  std::optional<PathJudgement> judged_;
  QLineEdit* path_;
  Choice* profile_;
  QLineEdit* pixel_;
  QPushButton* measure_;
  QLineEdit* rate_;
  CardField* path_field_;
  CardField* pixel_field_;
  CardField* rate_field_;
  BackgroundTask look_;
};

}  // namespace pellucida
