#pragma once
#include <functional>
#include <set>
#include <vector>

#include "presenters/ReviewEvents.h"
#include "widgets/Panel.h"

class QMenu;
class QToolButton;
class QTreeWidget;

namespace pellucida {

/// The session's events and doubts, in the order of time: a click on one seeks; a menu says which kinds are listed.
class EventPanel : public Panel {
 public:
  /// `seek` is called with the event's time.
  EventPanel(std::function<void(double)> seek, QWidget* parent);

  void set_events(std::vector<ReviewEvent> events);
  /// Lists this kind or leaves it out.
  void show_kind(const std::string& kind, bool shown);
  /// Marks the newest event that isn't later than `time_s`.
  void set_position_s(double time_s);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  EventPanel(std::function<void(double)> seek, QTreeWidget* list, QWidget* parent);
  void fill();
  void fill_menu();
  void show_count();

  std::function<void(double)> seek_;
  QTreeWidget* list_;
  QToolButton* filter_ = nullptr;
  QMenu* kinds_menu_ = nullptr;
  std::vector<ReviewEvent> events_;
  std::vector<double> shown_s_;  // of the rows listed
  std::set<std::string> hidden_;
};

}  // namespace pellucida
