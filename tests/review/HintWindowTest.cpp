// Review mode corrected by hints: a recorded film, clicks on its image, measured again.
#include <gtest/gtest.h>

#include <vtkImageData.h>

#include <QPushButton>

#include "HintReview.h"
#include "ReviewViews.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/pipeline/AnySource.h"
#include "pellucida/pipeline/BatchRun.h"
#include "pellucida/pipeline/RunProvenance.h"
#include "pellucida/session/SessionWriter.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "review/ReviewWindowFixture.h"
#include "widgets/FeedPanel.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

using namespace test;

// The first frames of a film.
class FirstFrames final : public FrameSource {
 public:
  FirstFrames(const Scenario& scenario, int count) : microscope_(scenario), left_(count) {}
  const SourceInfo& info() const noexcept override { return microscope_.info(); }
  std::optional<Frame> next() override { return left_-- > 0 ? microscope_.next() : std::nullopt; }

 private:
  VirtualMicroscope microscope_;
  int left_;
};

class HintWindow : public ReviewWindowTest {
 protected:
  static constexpr std::size_t kFilmFrames = 12, kHinted = 6;

  void SetUp() override {
    session_ = *films_ / "film";
    FirstFrames source(load_scenario("default"), kFilmFrames);
    SessionInfo info;
    info.source = source.info();
    const CellProfile profile = load_profile("mouse-oocyte");
    info.profile_name = profile.name;
    info.profile_json = to_json(profile);
    info.provenance_json = to_json(RunProvenance{}, PipelineOptions{}, profile);
    SessionWriter writer(session_, info);
    run_batch(source, {}, [&](const Scene& scene) { writer.write(scene); });
    writer.close();
    window_->open(session_);
    ASSERT_TRUE(shows(0)) << text("problem");
    ASSERT_TRUE(activate(*window_)) << "not active";
    for (std::size_t k = 0; k < kHinted; ++k) {
      input_.tap(kRightKey);
      pass(60);
    }
    ASSERT_TRUE(shows(kHinted));
  }

  // Shift+O, and a click on the cell.
  void deny_the_cell() {
    const Measurement& row = window_->session()->rows[kHinted];
    input_.key(kShiftKey, true);
    input_.tap(kOKey);
    input_.key(kShiftKey, false);
    pass(300);
    auto& views = const_cast<ReviewViews&>(window_->views());
    ViewWidget& view = views.feed().view();
    const Eigen::Vector2d origin_um = views.image().place_um(0.0, 0.0, view.height());
    const Eigen::Vector2d per_px = (views.image().place_um(100.0, 100.0, view.height()) - origin_um) / 100.0;
    const Eigen::Vector2d at = (Eigen::Vector2d(row.cell_x_um, row.cell_y_um) - origin_um).cwiseQuotient(per_px);
    click(view, QPoint(static_cast<int>(at.x()), static_cast<int>(at.y())));
  }
  bool has_strip() const { return window_->findChild<QWidget*>("hintStrip")->isVisible(); }

  std::unique_ptr<TemporaryFolder> films_ = std::make_unique<TemporaryFolder>();
  std::filesystem::path session_;
};

TEST_F(HintWindow, AHintIsListedAndTakenBackByOneKey) {
  EXPECT_FALSE(has_strip());
  deny_the_cell();
  ASSERT_TRUE(pass_until([&] { return has_strip(); }));
  EXPECT_NE(text("hintText").find("1 hint: no cell at"), std::string::npos) << text("hintText");
  pass(300);
  keep_picture(*window_, "review-hint");
  window_->resize(1000, 640);
  pass(500);
  keep_picture(*window_, "review-hint-small");
  ASSERT_EQ(window_->hints().draft().hints().size(), 1U);
  const PersonHint hint = window_->hints().draft().hints()[0];
  const Measurement& row = window_->session()->rows[kHinted];
  EXPECT_NEAR(hint.x_um, row.cell_x_um, 2.0);
  EXPECT_NEAR(hint.y_um, row.cell_y_um, 2.0);
  EXPECT_EQ(hint.since_s, window_->session()->times_s[kHinted]);
  input_.tap(kBackspaceKey);
  EXPECT_TRUE(pass_until([&] { return !has_strip(); }));
}

TEST_F(HintWindow, TheSessionIsMeasuredAgainFromThereAndOpened) {
  deny_the_cell();
  ASSERT_TRUE(pass_until([&] { return has_strip(); }));
  const std::vector<Measurement> before = window_->session()->rows;
  input_.tap(kMKey);
  ASSERT_TRUE(pass_until([&] { return window_->session()->folder.filename() == "film-corrected"; })) << text("notice");
  ASSERT_TRUE(shows(kHinted));
  const std::vector<Measurement>& now = window_->session()->rows;
  ASSERT_EQ(now.size(), before.size());
  for (std::size_t k = 0; k < now.size(); ++k) {
    if (k < kHinted) {
      EXPECT_EQ(now[k].tip_x_um, before[k].tip_x_um) << k;
      EXPECT_EQ(now[k].state, before[k].state) << k;
    } else {
      EXPECT_EQ(now[k].state, CellState::kNoCell) << k;
    }
  }
  EXPECT_EQ(text("statePill"), "No cell");
  keep_picture(*window_, "review-measured-again");
  EXPECT_FALSE(has_strip());
  // The recorded session is what it was.
  EXPECT_EQ(SessionReader(session_).measurements().size(), before.size());
}

// The film opens as any recording does, with a picture for each frame.
TEST_F(HintWindow, TheViewsAreFilmedFrameByFrame) {
  answer_ = *films_ / "views.avi";
  trigger("exportVideo");
  ASSERT_TRUE(pass_until([&] { return std::filesystem::exists(answer_); })) << text("notice");
  const auto film = open_any_source(answer_.string(), {.pixel_size_um = 1.0});
  EXPECT_EQ(film->info().width_px, window_->views().width() & ~1);
  EXPECT_EQ(film->info().height_px, window_->views().height() & ~1);
  EXPECT_NEAR(film->info().frame_rate_hz, 1.0 / window_->session()->usual_step_s(), 0.1);
  std::vector<double> brightness;
  while (const auto frame = film->next()) {
    double range[2];
    frame->image.shallow_copy()->GetScalarRange(range);
    EXPECT_GT(range[1], range[0] + 50.0) << brightness.size();
    brightness.push_back(range[1]);
  }
  EXPECT_EQ(brightness.size(), kFilmFrames);
}

TEST_F(HintWindow, ACancelledFilmLeavesNothing) {
  answer_ = *films_ / "views.mp4";
  trigger("exportVideo");
  pass(60);
  window_->findChild<QPushButton*>("cancelWork")->click();
  pass(200);
  EXPECT_FALSE(std::filesystem::exists(answer_));
  EXPECT_FALSE(std::filesystem::exists(*films_ / "views.part.mp4"));
}

}  // namespace
}  // namespace pellucida
