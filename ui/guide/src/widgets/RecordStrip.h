#pragma once
#include <QFrame>
#include <functional>

class QLineEdit;

namespace pellucida {

/// The cell's name and a note, typed while the cell goes on living: Enter takes what was typed, and the window's keys
/// work again.
class RecordStrip : public QFrame {
 public:
  struct Actions {
    std::function<void(const QString&)> name;  ///< of the cell in view; not empty
    std::function<void(const QString&)> note;  ///< not empty
  };

  RecordStrip(Actions actions, QWidget* parent);

  /// The name that the cell has, or one to take by Enter. Not while a name is being typed.
  void offer_name(const QString& name, bool is_given);
  void begin_name();
  void begin_note();

 private:
  QLineEdit* add_field(const char* key, const QString& name, const QString& hint, int stretch);
  void leave(QLineEdit& field);

  QLineEdit* name_;
  QLineEdit* note_;
};

}  // namespace pellucida
