// A developer's tool, not installed and no test: pictures of the virtual microscope's looks, and the time a frame
// takes.
//   look_pictures [--scenario NAME] [--look NAME] [--frame N] [--out PREFIX]
// Without --look all that are shipped. Writes PREFIX<look>.png.
#include <cstdio>
#include <ctime>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/VirtualMicroscope.h"

int main(int count, char** arguments) {
  using namespace pellucida;
  cv::setNumThreads(1);
  std::string scenario_name = "default", look_name, out = "look_";
  long frame_index = 100;
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string word = arguments[i], value = arguments[i + 1];
    if (word == "--scenario")
      scenario_name = value;
    else if (word == "--look")
      look_name = value;
    else if (word == "--frame")
      frame_index = std::stol(value);
    else if (word == "--out")
      out = value;
    else
      return std::fprintf(stderr, "look_pictures: unknown argument %s\n", word.c_str()), 2;
  }
  Scenario scenario = load_scenario(scenario_name);
  const std::vector<std::string> names = look_name.empty() ? look_names() : std::vector<std::string>{look_name};
  for (const std::string& name : names) {
    scenario.look = name;
    VirtualMicroscope microscope(scenario);
    for (long k = 0; k < frame_index; ++k) microscope.skip();
    std::optional<Frame> frame = microscope.next();
    constexpr int kTimed = 5;
    const std::clock_t start = std::clock();
    for (int k = 0; k < kTimed; ++k)
      if (std::optional<Frame> next = microscope.next()) frame = std::move(next);
    const double took_ms = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / kTimed;
    const ImageView view = view_of(frame->image.get());
    const cv::Mat grey(view.height_px, view.width_px, view.format == PixelFormat::kGray16 ? CV_16U : CV_8U,
                       const_cast<void*>(view.data), static_cast<std::size_t>(view.row_bytes));
    std::string stem = name.substr(name.rfind('/') + 1);
    cv::imwrite(out + stem + ".png", grey);
    std::printf("%-28s %5.1f ms a frame\n", stem.c_str(), took_ms);
  }
  return 0;
}
