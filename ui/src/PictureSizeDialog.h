#pragma once
#include <QDialog>
#include <QSize>

class QComboBox;
class QSpinBox;

namespace pellucida {

/// Asks how large a picture is to be, in pixels: as on screen, twice or four times that, or a size of one's own.
class PictureSizeDialog : public QDialog {
 public:
  /// Largest width and height, pixels.
  static constexpr int kMost_px = 8000;

  /// `seen`: its size on screen, pixels. `keeps_shape`: the height follows from the width.
  PictureSizeDialog(const QString& title, QSize seen, bool keeps_shape, QWidget* parent);

  QSize chosen() const;

 private:
  void choose(int index);
  void follow_width(int width_px);

  QSize seen_;
  bool keeps_shape_;
  QComboBox* choice_ = nullptr;
  QSpinBox* width_ = nullptr;
  QSpinBox* height_ = nullptr;
};

}  // namespace pellucida
