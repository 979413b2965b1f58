// Theme and language: chosen in the window, followed by all that is open, kept for the next window.
#include <gtest/gtest.h>

#include <vtkRenderer.h>

#include <QAction>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QVBoxLayout>
#include <fstream>

#include "Look.h"
#include "Theme.h"
#include "Translation.h"
#include "Words.h"
#include "pellucida/charts_vtk/ForceChart.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/visualization/Palette.h"
#include "presenters/Phrase.h"
#include "ui/DisplayTest.h"
#include "widgets/Icons.h"
#include "widgets/PhraseLabel.h"
#include "widgets/TitleBar.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

class LookTest : public test::DisplayTest {
 protected:
  LookTest() {
    qputenv("XDG_CONFIG_HOME", QByteArray::fromStdString(folder_.path().string()));
    apply_theme(*qApp, dark_theme());
  }
  ~LookTest() override { apply_theme(*qApp, dark_theme()); }

  static bool has_color(const QImage& image, const Color& color) {
    const QColor wanted = to_qt(color);
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        if (image.pixelColor(x, y) == wanted) return true;
      }
    }
    return false;
  }

  TemporaryFolder folder_;
};

TEST_F(LookTest, WhatIsKeptComesBackAndDamageLeavesTheDefaults) {
  EXPECT_EQ(remembered_look().theme, "dark");
  EXPECT_EQ(remembered_look().language, "");
  remember_look({.theme = "light", .language = "de"});
  EXPECT_EQ(remembered_look().theme, "light");
  EXPECT_EQ(remembered_look().language, "de");
  remember_look({.theme = "mauve", .language = "tlh"});
  EXPECT_EQ(remembered_look().theme, "dark");
  EXPECT_EQ(remembered_look().language, "");
}

TEST_F(LookTest, TheThemeIsChosenInTheWindowAndAllFollows) {
  QMainWindow window;
  auto* page = new QWidget(&window);
  auto* column = new QVBoxLayout(page);
  auto* bar = new TitleBar(page);
  bar->add_look_menu();
  column->addWidget(bar);
  auto* label = new QLabel;
  show_phrase(*label, {"in doubt", current_theme().warning});
  column->addWidget(label);
  auto* button = new QPushButton(make_icon(Pictogram::kNote), {});
  column->addWidget(button);
  ForceChart chart(ForceChartKind::kForceTime);
  auto* view = new ViewWidget(chart, 0, nullptr);
  column->addWidget(view);
  window.setCentralWidget(page);
  window.resize(700, 400);
  window.show();
  pass(300);
  ASSERT_TRUE(has_color(button->icon().pixmap(32, 32).toImage(), dark_theme().text));

  auto* light = window.findChild<QAction*>("lightTheme");
  ASSERT_NE(light, nullptr);
  EXPECT_FALSE(light->isChecked());
  light->trigger();
  pass(200);
  EXPECT_TRUE(current_theme().is_light);
  EXPECT_EQ(remembered_look().theme, "light");
  EXPECT_TRUE(label->styleSheet().contains(QString::fromStdString(light_theme().warning.css())));
  EXPECT_TRUE(has_color(button->icon().pixmap(32, 32).toImage(), light_theme().text));
  EXPECT_NEAR(chart.renderer()->GetBackground()[0], light_theme().panel.red, 1e-9);
  EXPECT_TRUE(has_color(window.grab().toImage(), light_theme().panel));
  light->trigger();
  EXPECT_FALSE(current_theme().is_light);
  EXPECT_EQ(remembered_look().theme, "dark");
  EXPECT_TRUE(label->styleSheet().contains(QString::fromStdString(dark_theme().warning.css())));

  // The language is the next window's.
  window.findChild<QAction*>("language_de")->trigger();
  EXPECT_EQ(remembered_look().language, "de");
  EXPECT_EQ(remembered_look().theme, "dark");
  delete window.takeCentralWidget();
}

TEST_F(LookTest, GermanIsSpokenWhileItsTextsAreThere) {
  EXPECT_EQ(say("Punctured"), "Punctured");
  {
    const Translation german("de");
    EXPECT_EQ(german.language(), "de");
    EXPECT_EQ(say("Punctured"), "Durchstochen");
    EXPECT_EQ(QString(words("Needle")), "Nadel");
    EXPECT_EQ(say("no text of the program"), "no text of the program");
  }
  EXPECT_EQ(say("Punctured"), "Punctured");
  const Translation english("en");
  EXPECT_EQ(say("Punctured"), "Punctured");
}

}  // namespace
}  // namespace pellucida
