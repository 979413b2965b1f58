#pragma once
#include <filesystem>

#include "widgets/StartCard.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace pellucida {

class Choice;

/// A camera: which, the profile, and the pixel size, typed or by the objective.
class CameraCard final : public StartCard {
 public:
  CameraCard(const StartForm& form, std::filesystem::path listing, std::function<void()> start);

  void write(StartForm& form) const override;
  using StartCard::show_problem;
  bool show_problem(const StartProblem& problem) override;
  void clear_problems() override;

 private:
  void search(const std::string& chosen);
  void show_size();
  void measure_pixel_size();

  std::filesystem::path listing_;
  Choice* camera_;
  Choice* profile_;
  Choice* objective_;
  QLineEdit* camera_pixel_;
  QLineEdit* specimen_pixel_;
  QLabel* computed_;
  QPushButton* measure_;
  CardField* camera_field_;
  CardField* camera_pixel_field_;
  CardField* specimen_pixel_field_;
};

}  // namespace pellucida
