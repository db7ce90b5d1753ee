// SPDX-License-Identifier: BSD-3-Clause
#include "tool_error.h"
#include "viewer/keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace {

using namespace pcl::sedr::tools;

constexpr HeightRange heights{0, 2.5};

KeyCommand
press(const std::string& key, ViewState& state)
{
  return pressKey(key, heights, state);
}

TEST(ViewerKeys, EachLayerHasOneThatTogglesIt)
{
  ViewState state;
  for (const auto layer : all_layers) {
    const std::string key(1, static_cast<char>('1' + static_cast<int>(layer)));
    EXPECT_EQ(press(key, state), KeyCommand::Redraw);
    EXPECT_TRUE(state.layers == LayerSet{layer}) << key;
    press(key, state);
    EXPECT_TRUE(state.layers.empty());
  }
}

TEST(ViewerKeys, ColouringsCeilingsEdgesLegendAndViews)
{
  ViewState state;
  press("o", state);
  EXPECT_EQ(state.colouring, Colouring::Room);
  press("d", state);
  EXPECT_EQ(state.colouring, Colouring::Distance);
  press("n", state);
  EXPECT_EQ(state.colouring, Colouring::Plain);
  press("l", state);
  EXPECT_EQ(state.colouring, Colouring::Label);
  press("c", state);
  EXPECT_FALSE(state.ceiling);
  press("c", state);
  EXPECT_TRUE(state.ceiling);
  press("e", state);
  EXPECT_FALSE(state.edges);
  press("g", state);
  EXPECT_FALSE(state.legend);
  press("v", state);
  EXPECT_TRUE(state.two_views);
  EXPECT_EQ(press("t", state), KeyCommand::MoveCamera);
  EXPECT_EQ(state.view_point, ViewPoint::Top);
  EXPECT_EQ(press("p", state), KeyCommand::MoveCamera);
  EXPECT_EQ(state.view_point, ViewPoint::Inside);
  EXPECT_EQ(press("j", state), KeyCommand::Screenshot);
  EXPECT_EQ(press("h", state), KeyCommand::Help);
  EXPECT_EQ(press("q", state), KeyCommand::Quit);
  EXPECT_EQ(press("F7", state), KeyCommand::None);
}

TEST(ViewerKeys, AreUniqueAndAllInTheHelp)
{
  std::set<std::string> keys;
  for (const auto& binding : keyBindings()) {
    EXPECT_TRUE(keys.insert(binding.key).second) << binding.key << " twice";
    if (binding.does.empty()) // described with another one
      continue;
    EXPECT_NE(keyHelp().find("  " + binding.shown + " "), std::string::npos);
    EXPECT_NE(keyHelp().find(binding.does), std::string::npos);
  }
}

TEST(ViewerKeys, PointsStayBetween1And20Pixels)
{
  ViewState state;
  for (int k = 0; k < 40; ++k)
    press("plus", state);
  EXPECT_EQ(state.point_size, 20);
  for (int k = 0; k < 40; ++k)
    press("minus", state);
  EXPECT_EQ(state.point_size, 1);
}

TEST(ViewState, ClippingComesDownFromTheTopAndEndsThere)
{
  ViewState state;
  EXPECT_FALSE(state.isClipped());
  press("Up", state);
  EXPECT_FALSE(state.isClipped()) << "nothing above no clipping";
  press("Down", state);
  EXPECT_EQ(state.clip_height, 2.5);
  press("Down", state);
  EXPECT_NEAR(state.clip_height, 2.4, 1e-12);
  press("Up", state);
  press("Up", state);
  EXPECT_FALSE(state.isClipped());
  for (int k = 0; k < 100; ++k)
    press("Down", state);
  EXPECT_GT(state.clip_height, 0) << "something is left";
  press("0", state);
  EXPECT_FALSE(state.isClipped());
}

TEST(ViewState, TwoViewsHaveTheScanAtTheLeftAndTheModelAtTheRight)
{
  ViewState state;
  state.layers = {Layer::Mesh};
  EXPECT_FALSE(state.isShownLeft(Layer::Raw)) << "one view";
  state.two_views = true;
  EXPECT_TRUE(state.isShownLeft(Layer::Raw)) << "asked for or not";
  EXPECT_FALSE(state.isShownLeft(Layer::Thinned));
  EXPECT_FALSE(state.isShownLeft(Layer::Mesh));
  EXPECT_TRUE(state.isShownRight(Layer::Mesh));
  state.layers = {Layer::Mesh, Layer::Thinned};
  EXPECT_TRUE(state.isShownLeft(Layer::Thinned));
  EXPECT_FALSE(state.isShownLeft(Layer::Raw));
  EXPECT_FALSE(state.isShownRight(Layer::Thinned));
}

TEST(ViewState, NamesOfLayersAreReadAndOthersRefused)
{
  EXPECT_TRUE(layersOf("") == LayerSet());
  EXPECT_TRUE(layersOf("plan,raw,plan") == (LayerSet{Layer::Raw, Layer::Plan}));
  EXPECT_THROW(layersOf("raw,walls"), ToolError);
  EXPECT_EQ(colouringOf("distance"), Colouring::Distance);
  EXPECT_EQ(viewPointOf("inside"), ViewPoint::Inside);
}

TEST(ViewState, AStoreyIsShownAloneAndAllAgain)
{
  ViewState state;
  EXPECT_EQ(press("F2", state), KeyCommand::None) << "there are no storeys";
  state.storeys = {1, 2, 3};
  EXPECT_EQ(press("F2", state), KeyCommand::Redraw);
  EXPECT_EQ(state.storey, 2u);
  press("F3", state);
  EXPECT_EQ(state.storey, 3u);
  press("F3", state);
  EXPECT_EQ(state.storey, 0u) << "all";
  EXPECT_EQ(press("F4", state), KeyCommand::None);
  EXPECT_EQ(state.storey, 0u);
}

} // namespace
