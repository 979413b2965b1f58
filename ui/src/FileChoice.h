#pragma once
#include <QSize>
#include <QString>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <vector>

class QWidget;

namespace pellucida {

/// How the window asks for files and folders; a test answers in a person's stead. An empty answer: not now.
struct FileChoice {
  /// A file to write, of one of the kinds ("Picture (*.png)"); asks before a file is replaced.
  std::function<std::filesystem::path(const QString& title, const std::filesystem::path& proposal,
                                      const QString& kinds)>
      file_to_write;
  /// A folder that may be new.
  std::function<std::filesystem::path(const QString& title, const std::filesystem::path& proposal)> folder_to_write;
  /// A session's folder.
  std::function<std::filesystem::path(const QString& title)> session;
  /// Whether these files, which exist, may be replaced.
  std::function<bool(const std::vector<std::filesystem::path>&)> may_replace;
  /// How large a picture is to be, pixels, of what has `seen` on screen; an empty size: not now. `keeps_shape`: no
  /// other shape than that. Not set: as on screen.
  std::function<QSize(const QString& title, QSize seen, bool keeps_shape)> picture_size;
  /// Shows a page of the report in the reader's browser.
  std::function<void(const std::filesystem::path&)> show_page;
};

/// Qt's dialogs over `window`.
FileChoice dialogs_over(QWidget& window);

}  // namespace pellucida
