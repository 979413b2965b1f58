// What comes from below the windows in English, and its German: errors as they are thrown, events as they are recorded.
#include "presenters/MessageBook.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QXmlStreamReader>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "Translation.h"
#include "pellucida/acquisition/OpenSource.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Event.h"
#include "pellucida/core/NewCellNote.h"
#include "pellucida/core/Observation.h"
#include "pellucida/core/PersonHint.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/core/Words.h"
#include "pellucida/mechanics/ForceEstimate.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/session/SessionReader.h"

namespace pellucida {
namespace {

class GermanMessages : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    static int count = 1;
    static char name[] = "ui_message_test";
    static char* arguments[] = {name, nullptr};
    static QCoreApplication program(count, arguments);
  }

  // The error's German sentence, without the path of the file.
  std::string error_of(const std::function<void()>& call) const {
    try {
      call();
    } catch (const Error& error) {
      std::string said = say_message(error.what());
      const std::string folder = folder_.path().string() + '/';
      for (auto at = said.find(folder); at != std::string::npos; at = said.find(folder)) said.erase(at, folder.size());
      return said;
    }
    return "no error";
  }
  std::string write(const char* name, const std::string& content) const {
    std::ofstream(folder_ / name) << content;
    return (folder_ / name).string();
  }
  static std::vector<std::pair<std::string, std::string>> sentences() {
    QFile file(PELLUCIDA_SOURCE_DIR "/resources/translations/messages_de.ts");
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    QXmlStreamReader reader(&file);
    std::vector<std::pair<std::string, std::string>> found;
    while (!reader.atEnd()) {
      if (reader.readNext() != QXmlStreamReader::StartElement) continue;
      if (reader.name() == QLatin1String("source")) found.emplace_back(reader.readElementText().toStdString(), "");
      if (reader.name() == QLatin1String("translation")) found.back().second = reader.readElementText().toStdString();
    }
    return found;
  }
  static std::string filled(std::string sentence) {
    for (char place = '1'; place <= '9'; ++place) {
      const auto at = sentence.find(std::string("%") + place);
      if (at != std::string::npos) sentence.replace(at, 2, std::string("4") + place + ".5");
    }
    return sentence;
  }

  Translation german_{"de"};
  TemporaryFolder folder_;
};

TEST_F(GermanMessages, EverySentenceIsFoundWithItsValues) {
  const auto known = sentences();
  EXPECT_GT(known.size(), 400U);
  for (const auto& [english, german] : known) EXPECT_EQ(say_message(filled(english)), filled(german)) << english;
}

TEST_F(GermanMessages, EveryKindOfEventHasItsName) {
  for (const EventKindInfo& kind : kEventKinds) {
    const std::string name(kind.name);
    EXPECT_NE(say_event_kind(name), name);
  }
  EXPECT_EQ(say_event_kind("contact"), "Kontakt");
  EXPECT_EQ(say_event_kind("of a later version"), "of a later version");
}

TEST_F(GermanMessages, DetailsOfEvents) {
  const auto said = [](const char* kind, const std::string& detail) { return say_event_detail(kind, detail); };
  EXPECT_EQ(said("puncture", "at 7.31 uN and 44.2 um, work 120.4 uN um; membrane back at 3.0 um"),
            "bei 7.31 uN und 44.2 um, Arbeit 120.4 uN um; Membran zurück bei 3.0 um");
  EXPECT_EQ(said("found",
                 "cell at 1.0 2.0 um, radius 40.0 um, confidence 0.97; one membrane only, taken as the outer: no "
                 "second edge was seen beside it; seen first as contact"),
            "Zelle bei 1.0 2.0 um, Radius 40.0 um, Sicherheit 0.97; nur eine Membran, als äußere genommen: daneben war "
            "kein zweiter Rand zu sehen; zuerst gesehen im Zustand Kontakt");
  EXPECT_EQ(
      said("warning",
           "mismatch+slip: contour 3.1 um from the model, left and right 2.0 um apart beyond it, which may "
           "cost 0.40 uN; few cells of profile mouse-oocyte bear this force: check that the profile is "
           "this cell's"),
      "Abweichung+Abgleiten: Kontur 3.1 um vom Modell, links und rechts darüber hinaus 2.0 um auseinander, was 0.40 "
      "uN kosten kann; wenige Zellen des Profils mouse-oocyte halten diese Kraft aus: prüfen Sie, ob es das Profil "
      "dieser Zelle ist");
  EXPECT_EQ(said("limit", "hand force: 3.1 N, limit 3 N"), "Kraft der Hand: 3.1 N, Grenze 3 N");
  EXPECT_EQ(said("limit", "depth: over, acted 12 times in 0.4 s, at most 51.2 um"),
            "Tiefe: vorbei, wirkte 12-mal in 0.4 s, höchstens 51.2 um");
  EXPECT_EQ(said("dropped", "12 frames (within 30 to 50) kept without their image: the disk is slower than the camera"),
            "12 Bilder (zwischen 30 und 50) ohne Bild aufgezeichnet: der Datenträger ist langsamer als die Kamera");
  EXPECT_EQ(said("gap", "3 frames missing from the source, the first before frame 7, the last before frame 20"),
            "3 Bilder der Quelle fehlen, das erste vor Bild 7, das letzte vor Bild 20");
  EXPECT_EQ(said("damaged", "over, after 3 frames"), "vorbei, nach 3 Bilder");
  EXPECT_EQ(said("palpation",
                 "this cell's forces are 1.210 times the profile's, +- 6.0 %; 2.4 standard deviations from the "
                 "kind: check the measurement, and that profile mouse-oocyte is this cell's"),
            "die Kräfte dieser Zelle sind 1.210-mal die des Profils, +- 6.0 %; 2.4 Standardabweichungen von der Art "
            "entfernt: prüfen Sie die Messung, und ob diese Zelle zum Profil mouse-oocyte gehört");
  const PersonHint hint{.kind = PersonHint::Kind::kNeedleTip, .x_um = 1.0, .y_um = 2.0};
  EXPECT_EQ(said("hint", describe(hint) + ": no straight shaft was found that ends there"),
            "Nadelspitze bei 1.000 2.000 um: kein gerader Schaft wurde gefunden, der dort endet");
}

TEST_F(GermanMessages, WarningsAndReasons) {
  EXPECT_EQ(say_message(describe(kShapeMismatch, "mouse-oocyte")),
            "die Kontur stimmt nicht mit der des Modells überein");
  EXPECT_EQ(say_message("the model found no equilibrium: iteration budget spent"),
            "das Modell fand kein Gleichgewicht: Zahl der Schritte erschöpft");
}

TEST_F(GermanMessages, WhatAPersonWroteStays) {
  EXPECT_EQ(say_event_detail("note", "contact"), "contact");
  EXPECT_EQ(say_event_detail("note", "new cell, from the left dish"), "new cell, from the left dish");
  EXPECT_EQ(say_event_detail("note", std::string(kNewCellNote)), "neue Zelle");
  EXPECT_EQ(say_event_detail("note", "no force: no cell to measure"), "keine Kraft: keine Zelle zu messen");
  EXPECT_EQ(say_message("this was never a sentence of the program, from 3 to 4"),
            "this was never a sentence of the program, from 3 to 4");
  EXPECT_EQ(say_message(""), "");
}

TEST_F(GermanMessages, FilesThatCantBeOpened) {
  const SourceOptions options{.pixel_size_um = 1.0, .frame_rate_hz = 30.0};
  const auto opened = [&](const std::string& path) { return error_of([&] { open_source(path, options); }); };
  EXPECT_EQ(opened(folder_ / "none.avi"), "none.avi: keine solche Datei und kein solcher Ordner; prüfen Sie den Pfad");
  EXPECT_EQ(opened(write("empty.avi", "")),
            "empty.avi: leere Datei (0 Bytes); kopieren Sie sie erneut oder nehmen Sie neu auf");
  EXPECT_EQ(opened(write("text.avi", "a text\n")),
            "text.avi: eine Textdatei, weder Video noch Bild; nötig ist AVI, MP4, MKV, MOV, PNG, TIFF, JPEG oder BMP");
  EXPECT_EQ(opened("v4l2:zero"), "v4l2:zero: „zero“ ist keine Kameranummer; nötig ist v4l2:0, v4l2:1, ...");
  EXPECT_NE(opened(write("cut.png", "\x89PNG\r\n\x1a\n")).find("beschädigtes Bild ("), std::string::npos);
  EXPECT_EQ(error_of([&] { SessionReader(folder_ / "gone"); }),
            "gone: kein solcher Sitzungsordner; prüfen Sie den Pfad");
  EXPECT_EQ(
      error_of([&] { SessionReader(folder_.path()); }),
      folder_.path().string() + ": hier liegt keine Sitzung (session.json fehlt); nennen Sie den Ordner einer Sitzung");
}

TEST_F(GermanMessages, ProfilesThatCantBeRead) {
  EXPECT_EQ(error_of([] { parse_profile("{", "own.json"); }).substr(0, 32), "own.json ist kein JSON: Byte 2; ");
  EXPECT_NE(error_of([] { parse_profile("{\"schema\": 1}", "own.json"); }).find("own.json: schema muss"),
            std::string::npos);
  EXPECT_NE(error_of([] { load_profile("elephant"); }).find("weder eine Datei noch eines der bekannten"),
            std::string::npos);
}

TEST_F(GermanMessages, AReadingTakesNoTime) {
  // A text of joints alone has the most ways to be read.
  std::string keys = "size";
  for (int i = 0; i < 200; ++i) keys += ", image.key";
  EXPECT_EQ(say_message("x.json: colour is an unknown key; known: " + keys),
            "x.json: colour ist ein unbekannter Schlüssel; bekannt: " + keys);
}

TEST(EnglishMessages, StayAsTheyAre) {
  EXPECT_EQ(say_message("the camera is on fire: no cell to measure"), "the camera is on fire: no cell to measure");
  EXPECT_EQ(say_event_kind("contact"), "contact");
}

}  // namespace
}  // namespace pellucida
