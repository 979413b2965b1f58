#pragma once
#include <QObject>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "pellucida/simulation/OperatorOptions.h"
#include "presenters/SoundCue.h"

class QAction;
class QMenu;
class QPushButton;

namespace pellucida {

class EventSound;
class HandControl;
class OperatorConsole;

/// What the person sees, feels and hears: the four modalities of the paper as one choice, the true force of a virtual
/// specimen, and sounds.
class DisplayControl : public QObject {
 public:
  struct Parts {
    OperatorConsole* console = nullptr;  ///< nullptr: no hand; then there is nothing to feel
    HandControl* hand = nullptr;
    QWidget* space = nullptr;                        ///< the view in 3-D
    bool has_truth = false;                          ///< the source knows the true force
    std::function<void(const std::string&)> remark;  ///< into the log and a recording that runs
    std::function<void()> changed;                   ///< all is to be drawn again
  };

  /// All parts must outlive the control. `button`: where its menu hangs.
  DisplayControl(Parts parts, QPushButton& button);
  ~DisplayControl() override;

  void choose(Modality modality);
  /// The one that is in force, whoever changed its parts; nothing for a mixture that the paper does not have.
  std::optional<Modality> modality() const;
  /// "display: 3-D + haptics".
  std::string words_for_recording() const;
  bool shows_truth() const;

  /// From the window's tick: notes a change of the modality, however it came about.
  void follow();
  /// A sound for what happened, if sounds are on. `now_s`: any monotonic clock.
  void hear(std::span<const Event> events, std::span<const Gauge> gauges, double now_s);

 private:
  void add_modalities(QMenu& menu);

  Parts parts_;
  QPushButton& button_;
  QAction* truth_ = nullptr;
  QAction* sounds_ = nullptr;
  QList<QAction*> modalities_;
  std::string noted_;
  CueFinder cues_;
  std::unique_ptr<EventSound> sound_;
};

}  // namespace pellucida
