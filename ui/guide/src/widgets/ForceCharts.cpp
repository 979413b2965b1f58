#include "widgets/ForceCharts.h"

#include <limits>

#include "Words.h"
#include "widgets/Panel.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

constexpr double kTimeWindow_s = 60.0;
constexpr int kSamples = 4;
constexpr int kBetweenCharts_ms = 50;
// Heights from which on a chart is read.
constexpr int kLeast_px = 120, kLeastLow_px = 92;

}  // namespace

ForceCharts::ForceCharts(QWidget* parent) : QSplitter(Qt::Horizontal, parent) {
  force_time_.set_time_window_s(kTimeWindow_s);
  setHandleWidth(4);
  setChildrenCollapsible(false);
  force_indentation_widget_ = new ViewWidget(force_indentation_, kSamples, nullptr);
  force_time_widget_ = new ViewWidget(force_time_, kSamples, nullptr);
  addWidget(new pellucida::Panel(words("Force over indentation"), force_indentation_widget_, nullptr));
  addWidget(new pellucida::Panel(words("Force over time"), force_time_widget_, nullptr));
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, [this] { render_next(); });
}

// The widgets show the charts: they go first.
ForceCharts::~ForceCharts() {
  delete force_indentation_widget_;
  delete force_time_widget_;
}

void ForceCharts::append(const std::vector<Measurement>& rows,
                         const std::function<std::optional<double>(long)>& true_force_uN) {
  for (const Measurement& row : rows) {
    const auto truth_uN = true_force_uN ? true_force_uN(row.frame) : std::nullopt;
    for (ForceChart* chart : {&force_indentation_, &force_time_}) {
      chart->append(row, truth_uN.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
  }
  draw_soon();
}

void ForceCharts::show_truth(bool shown) {
  for (ForceChart* chart : {&force_indentation_, &force_time_}) chart->show_truth(shown);
  draw_soon();
}

void ForceCharts::draw_soon() {
  const bool is_stale = force_indentation_.is_stale() || force_time_.is_stale();
  if (is_stale && !timer_.isActive()) timer_.start(kBetweenCharts_ms);
}

void ForceCharts::set_low(bool low) {
  for (ViewWidget* chart : {force_indentation_widget_, force_time_widget_}) {
    chart->setMinimumHeight(low ? kLeastLow_px : kLeast_px);
  }
}

void ForceCharts::render() {
  if (force_indentation_.is_stale()) force_indentation_widget_->render();
  if (force_time_.is_stale()) force_time_widget_->render();
}

void ForceCharts::render_next() {
  const bool time = time_is_next_ ? force_time_.is_stale() : !force_indentation_.is_stale();
  time_is_next_ = !time;
  (time ? force_time_widget_ : force_indentation_widget_)->render();
  if (force_indentation_.is_stale() || force_time_.is_stale()) timer_.start(kBetweenCharts_ms);
}

}  // namespace pellucida
