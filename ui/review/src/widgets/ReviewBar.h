#pragma once
#include <QWidget>
#include <functional>

class QHBoxLayout;
class QLabel;
class QMenu;
class QPushButton;

namespace pellucida {

struct RecordedSession;

/// The line at the window's top in Review mode: name, what can be done with a session, and the session's facts.
class ReviewBar : public QWidget {
 public:
  struct Actions {
    std::function<void()> open;
    std::function<void()> export_window;    ///< the window as a picture
    std::function<void()> export_view;      ///< the 3-D view as a picture
    std::function<void()> export_feed;      ///< the microscope's picture with its lines
    std::function<void()> export_time;      ///< the chart over time
    std::function<void()> export_touch;     ///< the chart over indentation
    std::function<void()> export_node;      ///< the node's chart
    std::function<void()> export_video;     ///< views and charts as a film
    std::function<void()> export_tables;    ///< rows, events and more as CSV
    std::function<void()> export_seen;      ///< what the window shows now, as CSV
    std::function<void()> report;           ///< the dose passport
    std::function<void(bool)> compare;      ///< with another session; false: no more
    std::function<void()> cells;            ///< the cells of several sessions
    std::function<void(bool)> show_events;  ///< the list at the side
  };
  ReviewBar(const Actions& actions, QWidget* parent);

  /// Puts `button` after the others.
  void add(QPushButton& button);
  /// Null: no session, and nothing to export.
  void show_session(const RecordedSession* session);
  /// Shows or hides the list at the side, as its button does.
  void show_events(bool shown);
  /// Whether a session is compared with another one, as its button shows.
  void set_comparing(bool comparing);
  /// A node is chosen, and has a chart.
  void set_node_chosen(bool chosen);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QPushButton* add_button(QHBoxLayout* row, const QString& text, const QKeySequence& key, const QString& tip);
  void add_export(QHBoxLayout* row, const Actions& actions);

  QHBoxLayout* row_ = nullptr;
  QPushButton* export_ = nullptr;
  QPushButton* compare_ = nullptr;
  QPushButton* events_ = nullptr;
  QWidget* last_ = nullptr;  // of the buttons, in the order of Tab
  QAction* node_ = nullptr;
  QLabel* brand_ = nullptr;
  QLabel* name_ = nullptr;
  QLabel* facts_ = nullptr;
};

}  // namespace pellucida
