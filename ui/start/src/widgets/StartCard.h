#pragma once
#include <QFrame>
#include <functional>

#include "presenters/StartForm.h"
#include "widgets/Icons.h"

class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace pellucida {

class CardField;

/// One way to begin: icon, title, a sentence, its own choices, and a button that starts it. The card itself takes the
/// focus, so that a digit or a click chooses it and Tab leads to its choices.
class StartCard : public QFrame {
 public:
  struct Look {
    StartCardId id;
    Pictogram icon;
    QString title;
    QString sentence;
    QString button;
  };
  /// `start`: a person pressed the button.
  StartCard(const Look& look, std::function<void()> start);

  StartCardId id() const noexcept { return id_; }
  QPushButton& start_button() const { return *start_; }
  /// The card that Enter starts.
  void show_current(bool current);
  /// An error of the card as a whole; empty: none.
  void show_problem(const std::string& text);
  /// Height of title and sentence at the card's present width, px; and the height to give them, so that the fields of
  /// all cards begin at one height.
  int head_height_px() const;
  void set_head_height(int height_px);

  /// Its part of the form.
  virtual void write(StartForm& form) const = 0;
  /// An error at one of its fields; false when it has no such field.
  virtual bool show_problem(const StartProblem& problem) = 0;
  /// No field is wrong any more.
  virtual void clear_problems() = 0;

 protected:
  CardField* add_field(const QString& name, QWidget* control, const char* object_name);
  void add_widget(QWidget* widget);
  /// Shows an error at a field, which gets the focus; false for no field.
  bool point_at(CardField* field, const std::string& text);
  /// After the last field: the rest of the card stays empty, and Tab goes through the fields to the start button.
  void finish();

 private:
  StartCardId id_;
  QWidget* head_;
  QScrollArea* scroll_;
  QWidget* fields_;
  QVBoxLayout* column_;
  QLabel* problem_;
  QPushButton* start_;
};

}  // namespace pellucida
