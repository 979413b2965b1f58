#pragma once
#include <QFrame>
#include <functional>
#include <vector>

class QAbstractButton;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;

namespace pellucida {

class Playback;
enum class Pictogram;

/// The buttons under the timeline: play, steps, events, speed, loop, backwards; and where one is.
class TransportBar : public QFrame {
 public:
  /// What the buttons do; all on the window's thread.
  struct Actions {
    std::function<void()> toggle_play;
    std::function<void(long)> step_by;      ///< frames, negative towards the beginning
    std::function<void(bool)> to_event;     ///< true: the next one
    std::function<void(bool)> to_end;       ///< false: to the beginning
    std::function<void(double)> set_speed;  ///< ratio to the session's own
    std::function<void(bool)> set_loop;
    std::function<void(bool)> set_backwards;
  };

  TransportBar(Actions actions, QWidget* parent);

  /// Speeds to choose from; the first and last are those of `Playback`.
  static const std::vector<double>& speeds();

  /// `frame`: the source's number of the frame shown.
  void show_state(const Playback& playback, long frame);

 private:
  QPushButton* add_button(QHBoxLayout* row, Pictogram pictogram, const QKeySequence& key, const QString& tip,
                          std::function<void()> action, bool repeats = false);
  QPushButton* add_toggle(QHBoxLayout* row, Pictogram pictogram, const QKeySequence& key, const QString& tip,
                          const std::function<void(bool)>& action);
  void add_speed(QHBoxLayout* row);
  void change_speed(int by);

  Actions actions_;
  QPushButton* play_ = nullptr;
  QPushButton* loop_ = nullptr;
  QPushButton* backwards_ = nullptr;
  QComboBox* speed_ = nullptr;
  QLabel* place_ = nullptr;
};

}  // namespace pellucida
