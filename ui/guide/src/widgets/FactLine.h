#pragma once
#include <QFrame>

class QLabel;

namespace pellucida {

class ScaleGauge;
class StatePill;
struct ReadoutTexts;
struct ScaleTexts;

/// What Guide says beside its gauges, in one line: state, the last puncture, pressure, confidence, scale, cell profile.
class FactLine : public QFrame {
 public:
  explicit FactLine(QWidget* parent);
  void show_texts(const ReadoutTexts& texts);
  void show_scale(const ScaleTexts& texts);
  /// Empty: there was none.
  void show_puncture(const QString& text);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// `widest`: the text it has room for, UTF-8.
  QLabel* add_fact(const char* key, const QString& name, const QString& widest);

  StatePill* state_;
  QLabel* parts_;
  QLabel* puncture_name_ = nullptr;
  QLabel* puncture_;
  QLabel* pressure_name_ = nullptr;
  QLabel* pressure_;
  QLabel* confidence_;
  QLabel* scale_;
  ScaleGauge* gauge_;
  QLabel* profile_;
};

}  // namespace pellucida
