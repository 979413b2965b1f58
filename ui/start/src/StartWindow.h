#pragma once
#include <QMainWindow>
#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "StartMemory.h"
#include "TimedScreenshot.h"
#include "pellucida/start/Start.h"
#include "presenters/StartForm.h"

namespace pellucida {

class RecordingCard;
class StartCard;

/// The start page: four cards and the newest sessions. It closes with a choice, or without.
class StartWindow : public QMainWindow {
 public:
  /// A person's answer to a file dialog (for a folder or for a file); empty: not now.
  using AskForPath = std::function<std::filesystem::path(bool folder)>;

  /// `ask`: in a person's stead; nothing: Qt's dialogs.
  explicit StartWindow(StartOptions options, AskForPath ask = {});
  ~StartWindow() override;

  /// What was chosen; nothing while the window is open, and when it was closed.
  const std::optional<StartChoice>& choice() const noexcept { return choice_; }
  const TimedScreenshot& screenshot() const noexcept { return *screenshot_; }
  /// The card that Enter starts.
  StartCardId current_card() const noexcept { return current_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void build(const StartForm& form, AskForPath ask);
  QWidget* build_cards(const StartForm& form, AskForPath ask);
  void add_keys();
  void press_enter();
  void align_cards();
  void make_current(StartCardId card);
  StartCard& card(StartCardId id) const { return *cards_[static_cast<std::size_t>(id)]; }
  StartForm form() const;
  void start(StartCardId id);
  void choose(StartChoice choice);

  StartOptions options_;
  StartMemory memory_;
  StartCardId current_ = StartCardId::kVirtual;
  std::array<StartCard*, kStartCardCount> cards_{};
  RecordingCard* recording_ = nullptr;
  std::optional<StartChoice> choice_;
  std::unique_ptr<TimedScreenshot> screenshot_;
};

}  // namespace pellucida
