#pragma once
#include <QObject>
#include <filesystem>
#include <functional>
#include <optional>

#include "BackgroundTask.h"
#include "pellucida/core_vtk/Scene.h"

namespace pellucida {

class NodePanel;

/// The node picked on the membrane: its panel, and its history read in the background.
class NodeReview : public QObject {
 public:
  /// `seek`: a time, s. `closed`: no node any more.
  NodeReview(std::function<void(double)> seek, std::function<void()> closed, QObject* parent);

  /// To be put into the window; hidden without a node. Belongs to the widget it is put into.
  NodePanel& panel() noexcept { return *panel_; }
  std::optional<long> node() const noexcept { return node_; }

  /// Shows a node and reads its history from `session`.
  void choose(const std::filesystem::path& session, long node);
  void clear();
  /// What this step says of the node.
  void show_step(const Scene& scene);
  void draw_chart();

 private:
  std::optional<long> node_;
  NodePanel* panel_;
  BackgroundTask reading_;
};

}  // namespace pellucida
