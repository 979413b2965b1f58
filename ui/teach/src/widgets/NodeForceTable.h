#pragma once
#include <QWidget>

class QLabel;
class QTableWidget;
class QCheckBox;

namespace pellucida {

struct NodeForces;
struct ThemeColors;

/// Eq. (1) and (2) on one node: each term's force in uN, in the colour of its arrow, and what they leave.
class NodeForceTable : public QWidget {
 public:
  explicit NodeForceTable(QWidget* parent);

  void show_forces(const NodeForces& forces, const ThemeColors& theme);
  /// No node is chosen.
  void show_hint();
  /// Arrows one behind the other.
  QCheckBox& head_to_tail() noexcept { return *head_to_tail_; }

 protected:
  /// Where there is no room for all columns, x and y go: z and the size say most.
  void resizeEvent(QResizeEvent* event) override;

 private:
  QLabel* title_;
  QTableWidget* table_;
  QCheckBox* head_to_tail_;
};

}  // namespace pellucida
