#include "NodeReview.h"

#include "presenters/NodeHistory.h"
#include "widgets/CurvePanel.h"
#include "widgets/NodePanel.h"

namespace pellucida {

NodeReview::NodeReview(std::function<void(double)> seek, std::function<void()> closed, QObject* parent)
    : QObject(parent) {
  panel_ = new NodePanel({std::move(seek), [this] { reading_.ask_to_end(); }, std::move(closed)}, nullptr);
  panel_->setObjectName("nodePanel");
  panel_->hide();
}

void NodeReview::choose(const std::filesystem::path& session, long node) {
  node_ = node;
  panel_->set_node(node);
  panel_->show_history({});
  panel_->show();
  panel_->show_progress(0, 1);
  reading_.run(
      [this, session, node](const BackgroundTask::Control& control) -> std::function<void()> {
        auto history = read_node_history(session, node,
                                         [&](std::size_t done, std::size_t all) { return control.go_on(done, all); });
        return [this, history = std::move(history)] {
          panel_->show_progress(0, 0);
          panel_->show_history(history);
          panel_->render();
        };
      },
      [this](std::size_t done, std::size_t all) { panel_->show_progress(done, all); },
      [this](const std::string& error) {
        panel_->show_progress(0, 0);
        panel_->show_problem(QString::fromStdString(error));
      });
}

void NodeReview::clear() {
  reading_.cancel();
  node_.reset();
  panel_->hide();
}

void NodeReview::show_step(const Scene& scene) {
  if (!node_) return;
  panel_->show_frame(scene.surface.shallow_copy(), scene.measurement.time_s);
}

void NodeReview::draw_chart() {
  if (node_) panel_->render();
}

}  // namespace pellucida
