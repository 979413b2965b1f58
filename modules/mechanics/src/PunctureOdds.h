#pragma once
#include <limits>

namespace pellucida {

/// A sequential test (Wald) over the frames of a contact, by Bayes' rule on four hypotheses:
/// - contact: the membrane lies on the tip, or both went back together (slipped, drawn back);
/// - misled: the same, and the picture about the tip is one that looks pierced (a look like none before);
/// - misread: contour or tip is not where it seems (tracker confused, needle wrongly placed);
/// - punctured: the membrane went back and the tip, beyond it, did not.
/// A misreading is the rarer the better the frame was seen, so that one frame decides alone where it was seen well; and
/// it tends to last, so that a frame that repeats a poor one adds little. One thread at a time.
class PunctureOdds {
 public:
  /// Of one frame, against the deepest membrane of late.
  struct Evidence {
    double back_ratio = 0.0;        ///< by which share of that depth the membrane has come back
    double back_sigma_ratio = 0.0;  ///< its standard deviation, > 0
    double tip_share = 0.0;         ///< the tip's own way back as a share of the membrane's; 1: they went together
    double tip_share_sigma = 0.0;   ///< its standard deviation, >= 0
    double confidence = 1.0;        ///< 0..1, how well membrane and tip were seen
    bool is_apart = false;          ///< the tip lies beyond the membrane by more than noise explains
    bool is_astray = false;         ///< the membrane seems to lie beyond the tip: one of them is elsewhere
    /// By which share of their depth the flanks of the dimple have come back, beside the tip and what hides or ties the
    /// membrane there, with its standard deviation; NaN: there were none to see.
    double flank_ratio = std::numeric_limits<double>::quiet_NaN();
    double flank_sigma_ratio = 0.1;
    /// Likewise of the bulge of the cell's sides, which no misreading under the tip reaches.
    double side_ratio = std::numeric_limits<double>::quiet_NaN();
    double side_sigma_ratio = 0.1;
    /// How likely the tip is through, by the picture about it alone, 0..1; NaN: that wasn't read.
    double pierced = std::numeric_limits<double>::quiet_NaN();
    bool is_deepening = false;  ///< the flanks went deeper, against the frame before, by more than noise
  };

  void weigh(const Evidence& now) noexcept;
  void reset() noexcept { *this = PunctureOdds{}; }

  /// Probability that the membrane is through.
  double probability() const noexcept { return punctured_ / sum(); }
  /// That it isn't a contact as usual.
  double doubt() const noexcept { return (misread_ + punctured_) / sum(); }

 private:
  void advance(double misread_rate, double lasting) noexcept;
  void normalise() noexcept;
  double sum() const noexcept { return contact_ + misled_ + misread_ + punctured_; }

  double contact_ = 1.0, misled_ = 0.0, misread_ = 0.0, punctured_ = 0.0;
  double shown_before_ = 0.0;  // back by so much, in the frame before
};

}  // namespace pellucida
