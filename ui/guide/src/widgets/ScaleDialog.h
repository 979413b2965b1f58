#pragma once
#include <QDialog>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "BackgroundTask.h"
#include "pellucida/mechanics/ScaleMeasurement.h"
#include "pellucida/membrane/CellProfile.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTabWidget;

namespace pellucida {

/// Asks for a measurement of this cell's scale, in one of three ways. Finite elements of an aspiration are computed
/// while it is open.
class ScaleDialog : public QDialog {
 public:
  /// `measured`: with a whole measurement, an aspiration's modulus included; `forget`: back to the kind's scale. Either
  /// may throw an Error, which the dialog shows.
  struct Actions {
    std::function<void(const ScaleMeasurement&)> measured;
    std::function<void()> forget;
  };

  ScaleDialog(const CellProfile& profile, const ScaleMeasurement& seen, bool has_own_scale, Actions actions,
              QWidget* parent);

 private:
  QWidget* make_page(std::size_t form, const ScaleMeasurement& seen);
  ScaleMeasurement entered() const;
  void measure();
  void take(const ScaleMeasurement& measurement);
  void show_problem(const std::string& text);

  const CellProfile& profile_;
  Actions actions_;
  QTabWidget* pages_;
  QLabel* problem_;
  QPushButton* measure_;
  std::vector<std::map<std::string, QDoubleSpinBox*>> boxes_;  // by page, then key
  BackgroundTask task_;
};

}  // namespace pellucida
