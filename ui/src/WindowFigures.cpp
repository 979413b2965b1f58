#include "WindowFigures.h"

#include <time.h>
#include <unistd.h>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTimer>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "BlockWatch.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/OutputFile.h"

namespace pellucida {
namespace {

constexpr double kMemoryPeriod_s = 10.0;

double clock_s(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Since this process began, s; 0 where the system doesn't tell.
double process_age_s() {
  std::ifstream stream("/proc/self/stat");
  std::string line;
  std::getline(stream, line);
  // The name, in parentheses, may hold blanks; the start is the 22nd value, the 20th after the name.
  std::istringstream values(line.substr(std::min(line.size(), line.rfind(')') + 1)));
  std::string value;
  for (int k = 0; k < 20; ++k) values >> value;
  const double ticks = values ? std::strtod(value.c_str(), nullptr) : 0.0;
  return ticks > 0.0 ? clock_s(CLOCK_BOOTTIME) - ticks / static_cast<double>(sysconf(_SC_CLK_TCK)) : 0.0;
}

double resident_MiB() {
  std::ifstream stream("/proc/self/statm");
  double total_pages = 0.0, resident_pages = 0.0;
  stream >> total_pages >> resident_pages;
  return resident_pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

}  // namespace

WindowFigures::Moment WindowFigures::now() {
  return {std::chrono::steady_clock::now(), clock_s(CLOCK_PROCESS_CPUTIME_ID), clock_s(CLOCK_THREAD_CPUTIME_ID)};
}

double WindowFigures::elapsed_s() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_.time).count();
}

void WindowFigures::drew() {
  if (has_begun_) ++drawn_count_;
  if (has_drawn_) return;
  has_drawn_ = true;
  // What was rendered gets to the screen before the next timer.
  QTimer::singleShot(0, &owner_, [this] { begin(); });
}

void WindowFigures::begin() {
  has_begun_ = true;
  start_s_ = process_age_s();
  begin_ = now();
  memory_ = {{0.0, resident_MiB()}};
  window_blocks().begin();
}

void WindowFigures::look() {
  if (has_begun_ && elapsed_s() >= memory_.back().time_s + kMemoryPeriod_s) {
    memory_.push_back({elapsed_s(), resident_MiB()});
  }
}

void WindowFigures::write() const {
  if (file_.empty()) return;
  QJsonObject report;
  if (has_begun_) {
    const Moment end = now();
    const BlockFigures blocks = window_blocks().figures();
    const double frames = static_cast<double>(std::max(1L, drawn_count_));
    report["start_s"] = start_s_;
    report["seconds"] = elapsed_s();
    report["drawn"] = static_cast<double>(drawn_count_);
    report["drawn_per_s"] = static_cast<double>(drawn_count_) / std::max(elapsed_s(), 1e-3);
    report["longest_block_ms"] = blocks.longest_ms;
    report["longest_block_at_s"] = blocks.longest_at_s;
    report["blocks"] = blocks.count;
    report["block_ms"] = BlockWatch::kBlock_ms;
    report["processor_ms_per_frame"] = 1e3 * (end.processor_s - begin_.processor_s) / frames;
    report["window_thread_ms_per_frame"] = 1e3 * (end.thread_s - begin_.thread_s) / frames;
    QJsonArray memory;
    for (const Memory& one : memory_) memory.append(QJsonArray{one.time_s, one.resident_MiB});
    memory.append(QJsonArray{elapsed_s(), resident_MiB()});
    report["memory_s_MiB"] = memory;
  }
  OutputFile file(file_);
  file.add(QJsonDocument(report).toJson().toStdString());
  file.finish();
}

}  // namespace pellucida
