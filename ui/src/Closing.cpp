#include "Closing.h"

#include <QVariant>
#include <QWidget>

namespace pellucida {
namespace {

constexpr const char* kNow = "closesNow";
constexpr const char* kStartPage = "leadsToStartPage";

}  // namespace

void close_now(QWidget& window) {
  window.setProperty(kNow, true);
  window.close();
}

bool closes_now(const QWidget& window) {
  return window.property(kNow).toBool();
}

void close_for_start_page(QWidget& window) {
  window.setProperty(kStartPage, true);
  window.close();
}

bool leads_to_start_page(const QWidget& window) {
  return window.property(kStartPage).toBool();
}

void forget_start_page(QWidget& window) {
  window.setProperty(kStartPage, false);
}

}  // namespace pellucida
