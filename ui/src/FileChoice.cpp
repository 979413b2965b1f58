#include "FileChoice.h"
#include "PictureSizeDialog.h"
#include "Words.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QMessageBox>
#include <QUrl>

namespace pellucida {
namespace {

QString name_of_path(const std::filesystem::path& path) {
  return QString::fromStdString(path.string());
}

std::filesystem::path path_of(const QString& name) {
  return name.toStdString();
}

// "Picture (*.png);;Drawing (*.svg)" and its ending ".png": what a name without an ending becomes.
QString first_ending(const QString& kinds) {
  const int star = kinds.indexOf('*');
  return kinds.mid(star + 1, kinds.indexOf(')', star) - star - 1);
}

}  // namespace

FileChoice dialogs_over(QWidget& window) {
  FileChoice choice;
  choice.may_replace = [&window](const std::vector<std::filesystem::path>& files) {
    QString list;
    for (const auto& file : files) list += name_of_path(file) + "\n";
    return QMessageBox::question(&window, words("Replace?"), words("These files exist. Replace them?\n\n") + list,
                                 QMessageBox::Yes | QMessageBox::No, QMessageBox::No) == QMessageBox::Yes;
  };
  choice.file_to_write = [&window, may_replace = choice.may_replace](
                             const QString& title, const std::filesystem::path& proposal, const QString& kinds) {
    // Asked below, once the name has its ending.
    const QString name = QFileDialog::getSaveFileName(&window, title, name_of_path(proposal), kinds, nullptr,
                                                      QFileDialog::DontConfirmOverwrite);
    if (name.isEmpty()) return std::filesystem::path();
    std::filesystem::path file = path_of(name);
    if (file.extension().empty()) file += first_ending(kinds).toStdString();
    if (std::filesystem::exists(file) && !may_replace({file})) return std::filesystem::path();
    return file;
  };
  choice.folder_to_write = [&window](const QString& title, const std::filesystem::path& proposal) {
    return path_of(QFileDialog::getExistingDirectory(&window, title, name_of_path(proposal)));
  };
  choice.session = [&window](const QString& title) {
    return path_of(QFileDialog::getExistingDirectory(&window, title, QDir::homePath()));
  };
  choice.picture_size = [&window](const QString& title, QSize seen, bool keeps_shape) {
    PictureSizeDialog dialog(title, seen, keeps_shape, &window);
    return dialog.exec() == QDialog::Accepted ? dialog.chosen() : QSize();
  };
  choice.show_page = [](const std::filesystem::path& page) {
    QDesktopServices::openUrl(QUrl::fromLocalFile(name_of_path(page)));
  };
  return choice;
}

}  // namespace pellucida
