#pragma once
#include <QLabel>

namespace pellucida {

/// How often the windows' thread was busy for too long, and for how long at most: calm, and hidden while it never was.
/// Looks once a second.
class BlockLabel : public QLabel {
 public:
  explicit BlockLabel(QWidget* parent = nullptr);

 private:
  void look();
};

}  // namespace pellucida
