// The watch over the windows' thread, and what a window remembers from one time to the next.
#include "BlockWatch.h"

#include <gtest/gtest.h>
#include <xcb/xcb.h>

#include <QAction>
#include <QEventLoop>
#include <QFile>
#include <QFileInfo>
#include <QMainWindow>
#include <QSettings>
#include <QSlider>
#include <QSplitter>
#include <QToolButton>
#include <thread>

#include "SettingsFile.h"
#include "WindowMemory.h"
#include "WindowProgram.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/ui/WindowOptions.h"
#include "pellucida/visualization/VirtualDisplay.h"
#include "support/WaitUntil.h"
#include "widgets/BlockLabel.h"

namespace pellucida {
namespace {

using namespace std::chrono_literals;

constexpr auto kBlock = 120ms;

// The program as the windows run in it, with settings of its own.
class WindowProgramTest : public testing::Test {
 protected:
  WindowProgramTest() {
    // Qt asks for the folder once in a program.
    static const TemporaryFolder settings;
    qputenv("XDG_CONFIG_HOME", QByteArray::fromStdString(settings.path().string()));
    QFile::remove(settings_file("windows"));
    program_ = std::make_unique<WindowProgram>(options_);
  }
  // Does `act` in the loop of a shown window, then closes it.
  void in_window(QWidget& window, std::function<void()> act, int after_ms = 50) {
    QTimer::singleShot(after_ms, &window, [&window, act = std::move(act)] {
      act();
      QTimer::singleShot(50, &window, [&window] { window.close(); });
    });
    program_->show(window, options_);
  }

  // A server starts anew when its last client goes, and does not answer meanwhile: one client stays.
  class Client {
   public:
    Client() {
      EXPECT_TRUE(test::wait_until([this] {
        xcb_disconnect(server_);
        server_ = xcb_connect(nullptr, nullptr);
        return xcb_connection_has_error(server_) == 0;
      }));
    }
    ~Client() { xcb_disconnect(server_); }
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

   private:
    xcb_connection_t* server_ = nullptr;
  };

  TemporaryFolder folder_;
  VirtualDisplay display_;
  Client client_;
  WindowOptions options_;
  std::unique_ptr<WindowProgram> program_;
};

TEST(BlockWatch, AnEventInsideAnotherIsPartOfItALoopInsideIsNot) {
  BlockWatch watch;
  {
    const BlockWatch::Event event(watch, 1);
    std::this_thread::sleep_for(30ms);
    const BlockWatch::Event sent(watch, 1);
    std::this_thread::sleep_for(30ms);
  }
  EXPECT_EQ(watch.figures().count, 1);
  EXPECT_GE(watch.figures().longest_ms, 60.0);
  watch.begin();
  EXPECT_EQ(watch.figures().longest_ms, 0.0);
  {
    const BlockWatch::Event opens_dialog(watch, 1);
    // The dialog waits for a person; what it handles counts by itself.
    std::this_thread::sleep_for(kBlock);
    const BlockWatch::Event click(watch, 2);
  }
  EXPECT_EQ(watch.figures().count, 0);
}

TEST_F(WindowProgramTest, ABlockIsCountedAndShown) {
  QMainWindow window;
  auto* label = new BlockLabel(&window);
  QString text, tip;
  in_window(window, [&] {
    window_blocks().begin();
    QTimer::singleShot(0, &window, [] { std::this_thread::sleep_for(kBlock); });
    QEventLoop loop;
    QTimer::singleShot(1500, &loop, &QEventLoop::quit);
    loop.exec();
    text = label->text();
    tip = label->toolTip();
  });
  EXPECT_GE(window_blocks().figures().count, 1);
  EXPECT_GE(window_blocks().figures().longest_ms, 120.0);
  // A loop that waits in an event is no block.
  EXPECT_LT(window_blocks().figures().longest_ms, 1400.0);
  EXPECT_TRUE(text.contains("block")) << text.toStdString();
  EXPECT_TRUE(tip.contains("50 ms")) << tip.toStdString();
}

struct KeptWindow : QMainWindow {
  KeptWindow() {
    auto* splitter = new QSplitter;
    splitter->addWidget(toggle = new QToolButton);
    splitter->addWidget(slider = new QSlider(Qt::Horizontal));
    for (int k = 0; k < 2; ++k) splitter->widget(k)->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    toggle->setCheckable(true);
    toggle->setChecked(true);
    slider->setRange(0, 100);
    action = new QAction(this);
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this] { ++trigger_count; });
    keep_as(*toggle, "toggle_1");
    keep_as(*slider, "slider");
    keep_as(*action, "action");
    setCentralWidget(parts = splitter);
    resize(600, 400);
  }
  QSplitter* parts;
  QToolButton* toggle;
  QSlider* slider;
  QAction* action;
  int trigger_count = 0;
};

TEST_F(WindowProgramTest, AWindowOpensAsItWasLeft) {
  {
    KeptWindow window;
    const WindowMemory memory(window, "guide", options_);
    in_window(window, [&] {
      EXPECT_TRUE(window.toggle->isChecked());
      window.resize(700, 500);
      window.parts->setSizes({200, 500});
      window.toggle->click();
      window.slider->setValue(42);
      window.action->trigger();
    });
  }
  const auto reopened = [&](const char* mode, auto check) {
    KeptWindow window;
    const WindowMemory memory(window, mode, options_);
    in_window(window, [&] { check(window); });
  };
  reopened("guide", [](KeptWindow& window) {
    EXPECT_EQ(window.size(), QSize(700, 500));
    EXPECT_NEAR(window.parts->sizes().front(), 200, 10);
    EXPECT_FALSE(window.toggle->isChecked());
    EXPECT_EQ(window.slider->value(), 42);
    EXPECT_TRUE(window.action->isChecked());
    EXPECT_EQ(window.trigger_count, 1) << "who listens must hear of it";
  });
  // Another mode has its own; a stated size counts more; a picture depends on nothing.
  const auto is_new = [](KeptWindow& window) {
    EXPECT_EQ(window.size(), QSize(600, 400));
    EXPECT_TRUE(window.toggle->isChecked());
  };
  reopened("review", is_new);
  options_.figures = (folder_ / "figures.json").string();
  reopened("guide", is_new);
  options_.figures.clear();
  options_.remembered_size = false;
  reopened("guide", [](KeptWindow& window) { EXPECT_EQ(window.size(), QSize(600, 400)); });
}

TEST_F(WindowProgramTest, DamagedSettingsLeaveTheWindowAsItWasBuilt) {
  const QString file = settings_file("windows");
  for (const char* damage :
       {"\x01\x02[[[[", "[guide]\ngeometry=@ByteArray(zzz)\nsplitter_0=a, b, c\ntoggle_1=mauve\n"}) {
    std::filesystem::create_directories(QFileInfo(file).path().toStdString());
    QFile damaged(file);
    ASSERT_TRUE(damaged.open(QIODevice::WriteOnly));
    damaged.write(damage);
    damaged.close();
    KeptWindow window;
    const WindowMemory memory(window, "guide", options_);
    in_window(window, [&] {
      EXPECT_EQ(window.slider->value(), 0);
      EXPECT_EQ(window.parts->sizes().size(), 2);
      window.slider->setValue(7);
    });
    EXPECT_EQ(QSettings(file, QSettings::IniFormat).value("guide/slider").toInt(), 7);
  }
}

}  // namespace
}  // namespace pellucida
