#pragma once
#include <QFrame>
#include <QStringList>
#include <functional>

class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace pellucida {

struct HandTexts;
struct Phrase;

/// The hand: what it does and feels above, who holds it, its scale, guide, depth stop and buttons below, and the
/// emergency stop at the right end, always in reach.
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
    std::function<void(bool)> stop;          ///< true: stop; false: released on purpose
  };

  HandBar(const QStringList& hands, const QStringList& scales, Actions actions, QWidget* parent);

  void show_texts(const HandTexts& texts);
  void set_choice(int hand, int scale);
  /// 0: there is none yet.
  void set_depth_stop_um(double depth_um);
  /// The buttons that only a person's hand has.
  void set_manual(bool manual);

 private:
  QHBoxLayout* build_readouts();
  QHBoxLayout* build_controls(const QStringList& hands, const QStringList& scales);
  QComboBox* add_choice(QHBoxLayout* row, const QStringList& names, const char* tip);
  QLabel* add_text(QHBoxLayout* row, const char* widest);
  QPushButton* add_button(QHBoxLayout* row, const QString& text, const QString& tip);
  static void show_phrase(QLabel* label, const Phrase& phrase);

  Actions actions_;
  QComboBox* hand_;
  QLabel* state_;
  QPushButton* guide_;
  QComboBox* scale_;
  QDoubleSpinBox* depth_stop_;
  QProgressBar* force_bar_;
  QLabel* force_;
  QLabel* contact_;
  QLabel* note_;
  QPushButton* inject_;
  QPushButton* retract_;
  QPushButton* stop_;
  bool stopped_ = false;
};

}  // namespace pellucida
