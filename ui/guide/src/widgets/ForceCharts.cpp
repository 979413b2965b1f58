#include "widgets/ForceCharts.h"

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

void ForceCharts::append(const std::vector<Measurement>& rows) {
  for (const Measurement& row : rows) {
    force_indentation_.append(row);
    force_time_.append(row);
  }
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
