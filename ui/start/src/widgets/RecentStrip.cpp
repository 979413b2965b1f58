#include "widgets/RecentStrip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPixmap>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>

#include "Words.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr std::size_t kMostRecent = 6;
constexpr QSize kLargestPicture_px(224, 126);
constexpr int kGap_px = 8;
constexpr int kFrame_px = 22;    // beside a picture, in its button
constexpr int kLetters_px = 54;  // below it

}  // namespace

RecentStrip::RecentStrip(std::filesystem::path sessions, std::function<void(const std::filesystem::path&)> open)
    : open_(std::move(open)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  auto* title = new QLabel(words("Recent sessions"));
  title->setObjectName("recentTitle");
  column->addWidget(title);
  strip_ = new QWidget;
  row_ = new QHBoxLayout(strip_);
  row_->setContentsMargins(0, 0, 0, 0);
  row_->setSpacing(kGap_px);
  hint_ = new QLabel(words("Looking for sessions ..."));
  hint_->setObjectName("fieldNote");
  row_->addWidget(hint_);
  row_->addStretch(1);
  column->addWidget(strip_);
  fit();
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
            found.push_back(read_thumbnail(folder, kLargestPicture_px));
          } catch (const Error&) {
            // A damaged session is offered too: Review says what is wrong with it.
            found.push_back({{folder, folder.filename().string(), words("can't be read")}, {}});
          }
        }
        return [this, found, sessions] {
          show_sessions(found);
          if (found.empty()) {
            show_text(words("None yet: what you record is kept in ") + QString::fromStdString(sessions.string()) +
                      words(" and offered here. Any other session can be dropped on this window."));
          }
        };
      },
      {}, [this](const std::string& text) { show_text(QString::fromStdString(text)); });
}

void RecentStrip::show_sessions(const std::vector<SessionThumbnail>& found) {
  hint_->hide();
  for (const auto& [session, picture] : found) {
    auto* button = new QToolButton;
    const QString date = QString::fromStdString(session.date), duration = QString::fromStdString(session.duration);
    button->setProperty("recent", true);
    button->setObjectName("recentSession");
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    QPixmap shown(kLargestPicture_px);
    shown.fill(Qt::black);
    button->setIcon(QIcon(picture.isNull() ? shown : QPixmap::fromImage(picture)));
    button->setText(date + "\n" + duration);
    button->setToolTip(QString::fromStdString(session.folder.string()));
    button->setAccessibleName(words("Review the session of ") + date + ", " + duration);
    button->setFocusPolicy(Qt::StrongFocus);
    connect(button, &QToolButton::clicked, this, [this, folder = session.folder] { open_(folder); });
    row_->insertWidget(row_->count() - 1, button);
  }
  fit();
}

// Six pictures side by side in the width there is.
void RecentStrip::fit() {
  const int count = static_cast<int>(kMostRecent);
  const int button_px = std::min((width() - (count - 1) * kGap_px) / count, kLargestPicture_px.width() + kFrame_px);
  const QSize picture_px =
      kLargestPicture_px.scaled(std::max(1, button_px - kFrame_px), kLargestPicture_px.height(), Qt::KeepAspectRatio);
  strip_->setFixedHeight(picture_px.height() + kLetters_px);
  for (QToolButton* button : strip_->findChildren<QToolButton*>("recentSession")) {
    button->setIconSize(picture_px);
    button->setFixedSize(button_px, strip_->height());
  }
}

void RecentStrip::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit();
}

void RecentStrip::show_text(const QString& text) {
  hint_->setText(text);
  hint_->show();
}

}  // namespace pellucida
