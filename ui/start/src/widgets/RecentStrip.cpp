#include "widgets/RecentStrip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPixmap>
#include <QToolButton>
#include <QVBoxLayout>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr std::size_t kMostRecent = 6;
constexpr QSize kPicture_px(132, 74);
constexpr int kStripHeight_px = 134;

}  // namespace

RecentStrip::RecentStrip(std::filesystem::path sessions, std::function<void(const std::filesystem::path&)> open)
    : open_(std::move(open)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  auto* title = new QLabel("Recent sessions");
  title->setObjectName("recentTitle");
  column->addWidget(title);
  auto* strip = new QWidget;
  strip->setFixedHeight(kStripHeight_px);
  row_ = new QHBoxLayout(strip);
  row_->setContentsMargins(0, 0, 0, 0);
  row_->setSpacing(8);
  hint_ = new QLabel("Looking for sessions ...");
  hint_->setObjectName("fieldNote");
  row_->addWidget(hint_);
  row_->addStretch(1);
  column->addWidget(strip);
  read(std::move(sessions));
}

RecentStrip::~RecentStrip() {
  task_.cancel();
}

void RecentStrip::read(std::filesystem::path sessions) {
  task_.run(
      [this, sessions](const BackgroundTask::Control& control) -> std::function<void()> {
        std::vector<SessionThumbnail> found;
        const auto folders = newest_sessions(sessions, kMostRecent);
        for (const auto& folder : folders) {
          control.progress(found.size(), folders.size());
          try {
            found.push_back(read_thumbnail(folder, kPicture_px));
          } catch (const Error&) {
            // A damaged session is offered too: Review says what is wrong with it.
            found.push_back({{folder, folder.filename().string(), "can't be read"}, {}});
          }
        }
        return [this, found, sessions] {
          show_sessions(found);
          if (found.empty()) {
            say("None yet: what you record is kept in " + QString::fromStdString(sessions.string()) +
                " and offered here. Any other session can be dropped on this window.");
          }
        };
      },
      {}, [this](const std::string& text) { say(QString::fromStdString(text)); });
}

void RecentStrip::show_sessions(const std::vector<SessionThumbnail>& found) {
  hint_->hide();
  for (const auto& [session, picture] : found) {
    auto* button = new QToolButton;
    const QString date = QString::fromStdString(session.date), duration = QString::fromStdString(session.duration);
    button->setProperty("recent", true);
    button->setObjectName("recentSession");
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize(kPicture_px);
    QPixmap shown(kPicture_px);
    shown.fill(Qt::black);
    button->setIcon(QIcon(picture.isNull() ? shown : QPixmap::fromImage(picture)));
    button->setText(date + "\n" + duration);
    button->setToolTip(QString::fromStdString(session.folder.string()));
    button->setAccessibleName("Review the session of " + date + ", " + duration);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setFixedHeight(kStripHeight_px);
    connect(button, &QToolButton::clicked, this, [this, folder = session.folder] { open_(folder); });
    row_->insertWidget(row_->count() - 1, button);
  }
}

void RecentStrip::say(const QString& text) {
  hint_->setText(text);
  hint_->show();
}

}  // namespace pellucida
