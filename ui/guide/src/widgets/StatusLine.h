#pragma once
#include <QWidget>

class QLabel;

namespace pellucida {

struct Phrase;
struct StatusTexts;

/// The line at the window's bottom: age and rate of the frames, what was lost, notices, the recording.
class StatusLine : public QWidget {
 public:
  explicit StatusLine(QWidget* parent);

  /// All but the notice.
  void show_texts(const StatusTexts& texts);
  void show_notice(const Phrase& phrase);

 private:
  QLabel* frame_age_;
  QLabel* frame_rate_;
  QLabel* lost_;
  QLabel* notice_;
  QLabel* recording_;
};

}  // namespace pellucida
