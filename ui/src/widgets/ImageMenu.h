#pragma once
#include <QToolButton>
#include <functional>

class QLabel;
class QSlider;

namespace pellucida {

class FeedView;
struct ImageLook;

/// How the microscope's image is shown: how much of it, how bright, with how much contrast. It changes the picture on
/// the screen alone, never what is measured in it.
class ImageMenu : public QToolButton {
 public:
  /// `view` must outlive the menu; `changed` has it drawn again.
  ImageMenu(FeedView& view, std::function<void()> changed, QWidget* parent);

 private:
  QWidget* build_look();
  void show_look();
  void apply(const ImageLook& look);

  FeedView& view_;
  std::function<void()> changed_;
  QAction* follows_;
  QSlider* brightness_;
  QSlider* contrast_;
  QLabel* numbers_[2];
};

}  // namespace pellucida
