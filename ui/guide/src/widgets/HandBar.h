#pragma once
#include <QFrame>
#include <QStringList>
#include <functional>
#include <string>

class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace pellucida {

class HoldButton;
struct HandTexts;

/// The hand: what it does and feels above, who holds it, its scale, guide, depth stop and buttons below, and the
/// emergency stop at the right end, always in reach. While the stop is in force its release is beside it, a button that
/// must be held: no click, nor two of them, releases a stop.
class HandBar : public QFrame {
 public:
  /// What the bar's controls do. All are called on the window's thread, none while the bar itself is being set.
  struct Actions {
    std::function<void(int)> choose_hand;    ///< index into the names given
    std::function<void(bool)> guide;         ///< on or off
    std::function<void(int)> choose_scale;   ///< index into the scales given
    std::function<void(double)> depth_stop;  ///< um behind the entry
    std::function<void(bool)> inject;        ///< while held down
    std::function<void(bool)> retract;       ///< while held down
    std::function<void()> new_cell;          ///< empty: there is none, and no button
    std::function<void()> stop;              ///< as soon as the button goes down
    std::function<void()> release_stop;      ///< the release was held for a second
  };

  HandBar(const QStringList& hands, const QStringList& scales, Actions actions, QWidget* parent);

  void show_texts(const HandTexts& texts);
  void set_choice(int hand, int scale);
  /// 0: there is none yet.
  void set_depth_stop_um(double depth_um);
  /// The buttons that only a person's hand has.
  void set_manual(bool manual);
  void set_guided(bool on);
  /// Holds the release of the stop, as its button does; nothing while no stop is in force.
  void hold_release(bool held);
  const QWidget& stop_button() const;
  /// Why the stop has to wait for the window, for its tip.
  void explain_late_stop(const std::string& reason);

 private:
  QHBoxLayout* build_readouts();
  QHBoxLayout* build_controls(const QStringList& hands, const QStringList& scales);
  QComboBox* add_choice(QHBoxLayout* row, const QStringList& names, const QString& tip);
  QPushButton* add_button(QHBoxLayout* row, const QString& text);
  void build_stop(QHBoxLayout* bar);

  Actions actions_;
  QComboBox* hand_;
  QLabel* state_;
  QPushButton* guide_;
  QComboBox* scale_;
  QDoubleSpinBox* depth_stop_;
  QProgressBar* force_bar_;
  QLabel* force_;
  QLabel* contact_;
  QLabel* plane_;
  QLabel* note_;
  QPushButton* inject_;
  QPushButton* retract_;
  HoldButton* release_;
  QPushButton* stop_;
  bool stopped_ = false;
};

}  // namespace pellucida
