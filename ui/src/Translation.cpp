#include "Translation.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <QXmlStreamReader>
#include <cstddef>

#include "Words.h"
#include "pellucida/core/Error.h"
#include "presenters/MessageBook.h"

namespace pellucida {

// Made by CMake from resources/translations/pellucida_de.ts; empty where lrelease was missing.
extern const unsigned char kGermanTexts[];
extern const std::size_t kGermanTextsSize;
// messages_de.ts itself, and a zero.
extern const unsigned char kGermanMessages[];
extern const std::size_t kGermanMessagesSize;

namespace {

std::string translate_with_qt(const char* english) {
  return QCoreApplication::translate("Pellucida", english).toStdString();
}

MessageBook read_messages() {
  MessageBook book;
  QXmlStreamReader file(QByteArray::fromRawData(reinterpret_cast<const char*>(kGermanMessages),
                                                static_cast<int>(kGermanMessagesSize - 1)));
  std::string english;
  while (!file.atEnd()) {
    if (file.readNext() != QXmlStreamReader::StartElement) continue;
    if (file.name() == QLatin1String("source")) {
      english = file.readElementText().toStdString();
    } else if (file.name() == QLatin1String("translation")) {
      book.add(english, file.readElementText().toStdString());
    }
  }
  return book;
}

// Stays to the program's end: a thread may be in it when the window's language ends.
std::string translate_message(const std::string& english) {
  static const MessageBook book = read_messages();
  return book.translate(english);
}

std::string language_of_system() {
  return kGermanTextsSize > 1 && QLocale::system().language() == QLocale::German ? "de" : "en";
}

}  // namespace

Translation::Translation(const std::string& language) : language_(language.empty() ? language_of_system() : language) {
  QLocale::setDefault(QLocale::c());
  if (language_ == "en") return;
  program_ = std::make_unique<QTranslator>();
  if (kGermanTextsSize <= 1 || !program_->load(kGermanTexts, static_cast<int>(kGermanTextsSize))) {
    throw DeviceError(
        "this build has no German texts: install the package qttools5-dev-tools and build again, or "
        "choose --language en");
  }
  QCoreApplication::installTranslator(program_.get());
  toolkit_ = std::make_unique<QTranslator>();
  if (toolkit_->load("qtbase_de", QLibraryInfo::location(QLibraryInfo::TranslationsPath))) {
    QCoreApplication::installTranslator(toolkit_.get());
  }
  set_translator(&translate_with_qt, &translate_message);
}

Translation::~Translation() {
  set_translator(nullptr, nullptr);
  if (!QCoreApplication::instance()) return;
  for (const auto& texts : {program_.get(), toolkit_.get()}) {
    if (texts) QCoreApplication::removeTranslator(texts);
  }
}

}  // namespace pellucida
