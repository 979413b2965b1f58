#pragma once
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <string>

#include "pellucida/core/CameraExposure.h"

class QCheckBox;
class QLabel;
class QMenu;
class QSlider;

namespace pellucida {

/// The camera's exposure, at the end of the image's menu: a time, or the camera's own automatic. Unlike the rest of
/// that menu it changes what is measured, so each change goes into the log and a recording that runs.
class ExposureControl : public QObject {
 public:
  using Remark = std::function<void(const std::string&)>;
  using Say = std::function<void(const QString& text, bool problem)>;

  /// Belongs to `menu`. `remark`: into the log; `say_it`: to the person, where the camera refuses.
  ExposureControl(std::shared_ptr<CameraExposure> exposure, QMenu& menu, Remark remark, Say say_it);

 private:
  void build(QMenu& menu);
  void take(bool automatic);
  void show_state();

  std::shared_ptr<CameraExposure> exposure_;
  Remark remark_;
  Say say_;
  CameraExposure::State state_;
  QSlider* time_ = nullptr;
  QLabel* number_ = nullptr;
  QCheckBox* automatic_ = nullptr;
  QTimer settled_;  // a slider that moves is one change
};

}  // namespace pellucida
