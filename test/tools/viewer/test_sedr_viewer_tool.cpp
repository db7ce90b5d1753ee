// SPDX-License-Identifier: BSD-3-Clause
#include "colour.h"
#include "tools/in_folder.h"
#include "tools/pictures/pictures.h"
#include "tools/sample_result.h"

#include <csignal>
#include <cstdio>
#include <memory>

namespace {

using namespace programs;

/** @brief An X server without a screen that ends with this object.
 *
 * It selects a free display and reports its number once it answers. xvfb-run instead
 * checks for a lock file first, which fails when other servers start or end meanwhile.
 */
class VirtualScreen {
public:
  static bool isInstalled() { return std::system("command -v Xvfb >/dev/null") == 0; }

  VirtualScreen()
      : output_(popen("echo $$; exec Xvfb -displayfd 1 -screen 0 1280x1024x24 "
                      "-nolisten tcp -noreset 2>/dev/null",
                      "r"))
  {
    int display = -1;
    if (output_ == nullptr || std::fscanf(output_, "%d %d", &process_, &display) != 2) {
      end();
      throw std::runtime_error("Xvfb did not start");
    }
    name_ = ":" + std::to_string(display);
  }

  VirtualScreen(const VirtualScreen&) = delete;
  VirtualScreen& operator=(const VirtualScreen&) = delete;

  ~VirtualScreen() { end(); }

  /** Returns the value of DISPLAY for programs. */
  const std::string& name() const { return name_; }

private:
  void end()
  {
    if (process_ > 0)
      kill(process_, SIGTERM);
    if (output_ != nullptr)
      pclose(output_); // waits until the server has ended
    output_ = nullptr;
  }

  std::FILE* output_;
  int process_ = 0;
  std::string name_;
};

/** Runs the viewer with or without a display. */
class ViewerTool : public InFolder<> {
protected:
  void SetUp() override
  {
    sample_.writeTo(folder_.path() / "model");
    // A separate cloud with all six labels: adjacent squares of 1 m.
    std::vector<std::vector<float>> points;
    std::vector<std::uint32_t> labels;
    for (std::uint32_t label = 0; label < 6; ++label)
      for (int i = 0; i < 900; ++i) {
        // The unlabelled square is in the middle, surrounded by the others.
        points.push_back(
            {static_cast<float>((label + 3) % 6) + static_cast<float>(i % 30) / 33,
             static_cast<float>(i / 30) / 33, 0});
        labels.push_back(label);
      }
    writeFile(in("stage.pcd"), pcdBytes(points, labels));
  }

  /** Returns a screenshot taken on a virtual screen. */
  Image shoot(const std::string& input, std::vector<std::string> arguments)
  {
    if (!screen_)
      screen_ = std::make_unique<VirtualScreen>();
    EXPECT_EQ(setenv("DISPLAY", screen_->name().c_str(), 1), 0);
    const std::string picture = in("view.png");
    std::filesystem::remove(picture);
    arguments.insert(arguments.begin(),
                     {input, "--screenshot", picture, "--size", "600x400"});
    const ProgramRun result = done(run(SEDR_VIEWER, arguments));
    EXPECT_EQ(result.err, "") << "quiet when piped";
    const Image image = imageOf(bytesOf(picture));
    EXPECT_EQ(image.width, 600);
    EXPECT_EQ(image.height, 400);
    return image;
  }

  /** Returns the share of the pixels with a colour in any light. */
  static double shareOf(const Image& image, Colour colour)
  {
    // The channels keep their ratios in any light.
    const auto rgb = [](Colour of) {
      const auto [red, green, blue] = channelsOf(of);
      return Eigen::Vector3d(red, green, blue);
    };
    std::size_t count = 0;
    for (const auto pixel : image.pixels) {
      const Eigen::Vector3d p = rgb(pixel);
      const Eigen::Vector3d c = rgb(colour);
      const bool is_lit_so = p.norm() > 0.6 * c.norm() && p.norm() < 1.05 * c.norm();
      if (is_lit_so && p.normalized().dot(c.normalized()) > 0.9995)
        ++count;
    }
    return static_cast<double>(count) / static_cast<double>(image.pixels.size());
  }

  SampleResult sample_;
  std::unique_ptr<VirtualScreen> screen_; ///< from the first screenshot on
};

#define SKIP_WITHOUT_XVFB                                                              \
  if (!VirtualScreen::isInstalled())                                                   \
  GTEST_SKIP() << "Xvfb is missing: Debian's package xvfb"

TEST_F(ViewerTool, WithoutADisplaySaysSoInOneSentence)
{
  for (const char* display : {"", ":4711"}) {
    ASSERT_EQ(setenv("DISPLAY", display, 1), 0);
    for (const std::vector<std::string>& more :
         {std::vector<std::string>{}, {"--screenshot", in("view.png")}}) {
      std::vector<std::string> arguments{in("model")};
      arguments.insert(arguments.end(), more.begin(), more.end());
      const ProgramRun result = run(SEDR_VIEWER, arguments);
      expectSentence(result, 1, "xvfb-run");
    }
  }
  EXPECT_FALSE(std::filesystem::exists(in("view.png")));
}

TEST_F(ViewerTool, BadCommandLinesAreRefusedBeforeADisplayIsAskedFor)
{
  unsetenv("DISPLAY");
  const auto refuses = [&](const std::string& input, std::vector<std::string> arguments,
                           const char* word) {
    arguments.insert(arguments.begin(), in(input));
    const ProgramRun result = run(SEDR_VIEWER, arguments);
    expectSentence(result, 1, word);
  };
  refuses("model", {"--layers", "walls"}, "walls");
  refuses("model", {"--colour", "pink"}, "pink");
  refuses("model", {"--view", "under"}, "under");
  refuses("model", {"--size", "600"}, "600");
  refuses("model", {"--size", "600x20000"}, "20000");
  refuses("model", {"--screenshot", in("view.jpg")}, "png");
  refuses("stage.pcd", {"--raw", in("none.pcd")}, "--raw names the raw scan");
}

TEST_F(ViewerTool, CeilingsAreHiddenAtFirst)
{
  SKIP_WITHOUT_XVFB;
  const std::vector<std::string> top{"--view", "top", "--no-legend"};
  const Image open = shoot(in("model"), top);
  EXPECT_GT(shareOf(open, colours::floor), 0.2);
  EXPECT_GT(shareOf(open, colours::wall), 0.02);
  EXPECT_EQ(shareOf(open, colours::ceiling), 0);
  const Image closed =
      shoot(in("model"), {"-view", "top", "-no-legend", "-ceilings"}); // PCL's way
  EXPECT_GT(shareOf(closed, colours::ceiling), 0.2);
  EXPECT_EQ(shareOf(closed, colours::floor), 0);
  const Image clipped =
      shoot(in("model"), {"--view", "top", "--no-legend", "--ceilings", "--clip", "1"});
  EXPECT_GT(shareOf(clipped, colours::floor), 0.2);
  const Image one = shoot(in("model"), {"--view", "top", "--no-legend", "--room", "2"});
  EXPECT_LT(shareOf(one, colours::floor), 0.6 * shareOf(open, colours::floor));
}

TEST_F(ViewerTool, EveryLayerShowsSomething)
{
  SKIP_WITHOUT_XVFB;
  for (const char* layer : {"scan", "structure", "plan", "solid"})
    EXPECT_LT(
        shareOf(shoot(in("model"), {"--layers", layer, "--no-legend"}), colours::paper),
        0.999)
        << layer;
}

TEST_F(ViewerTool, AStagesCloudShowsEveryLabelInItsColour)
{
  SKIP_WITHOUT_XVFB;
  const Image image =
      shoot(in("stage.pcd"), {"--view", "top", "--no-legend", "--ceilings"});
  for (std::uint32_t label = 0; label < 6; ++label)
    EXPECT_GT(shareOf(image, colourOf(static_cast<pcl::sedr::StructureLabel>(label))),
              0.01)
        << label;
  const auto isWritten = [](const Image& view) {
    int dark = 0;
    for (int y = 0; y < 100; ++y)
      for (int x = 0; x < 150; ++x)
        dark += channelsOf(view.at(x, y))[1] < 128 ? 1 : 0;
    return dark > 100;
  };
  EXPECT_FALSE(isWritten(image));
  EXPECT_TRUE(isWritten(shoot(in("stage.pcd"), {"--view", "top"}))) << "the legend";
}

} // namespace
