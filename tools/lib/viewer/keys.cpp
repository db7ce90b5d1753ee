// SPDX-License-Identifier: BSD-3-Clause
#include "keys.h"

#include <algorithm>

namespace pcl::sedr::tools {

namespace {

using Press = std::function<KeyCommand(ViewState&, HeightRange)>;

constexpr double clip_step = 0.1;     // metres
constexpr double max_point_size = 20; // pixels

Press
flips(bool ViewState::*member)
{
  return [member](ViewState& state, HeightRange) {
    state.*member = !(state.*member);
    return KeyCommand::Redraw;
  };
}

Press
flips(Layer layer)
{
  return [layer](ViewState& state, HeightRange) {
    state.layers.flip(layer);
    return KeyCommand::Redraw;
  };
}

template <typename ValueT>
Press
sets(ValueT ViewState::*member, ValueT value)
{
  return [member, value](ViewState& state, HeightRange) {
    state.*member = value;
    return KeyCommand::Redraw;
  };
}

Press
storey(std::uint32_t number)
{
  return [number](ViewState& state, HeightRange) {
    return state.toggleStorey(number) ? KeyCommand::Redraw : KeyCommand::None;
  };
}

Press
goesTo(ViewPoint view_point)
{
  return [view_point](ViewState& state, HeightRange) {
    state.view_point = view_point;
    return KeyCommand::MoveCamera;
  };
}

Press
clips(double by)
{
  return [by](ViewState& state, HeightRange heights) {
    state.moveClipping(by, heights);
    return KeyCommand::Redraw;
  };
}

Press
resizesPoints(double by)
{
  return [by](ViewState& state, HeightRange) {
    state.point_size = std::clamp(state.point_size + by, 1.0, max_point_size);
    return KeyCommand::Redraw;
  };
}

Press
asks(KeyCommand command)
{
  return [command](ViewState&, HeightRange) { return command; };
}

} // namespace

const std::vector<KeyBinding>&
keyBindings()
{
  static const std::vector<KeyBinding> bindings{
      {"1", "1", "raw scan", "--layers raw", flips(Layer::Raw)},
      {"2", "2", "scan thinned to one point a voxel", "--layers thinned",
       flips(Layer::Thinned)},
      {"3", "3", "points of the structure", "--layers structure",
       flips(Layer::Structure)},
      {"4", "4", "floor plan: lines black, arcs blue", "--layers plan",
       flips(Layer::Plan)},
      {"5", "5", "Poisson mesh", "--layers mesh", flips(Layer::Mesh)},
      {"6", "6", "sharp solid", "--layers solid", flips(Layer::Solid)},
      {"l", "l", "colours by label", "--colour label",
       sets(&ViewState::colouring, Colouring::Label)},
      {"o", "o", "colours by room", "--colour room",
       sets(&ViewState::colouring, Colouring::Room)},
      {"d", "d", "colours by distance from the mesh", "--colour distance",
       sets(&ViewState::colouring, Colouring::Distance)},
      {"n", "n", "colours of clouds by height", "--colour plain",
       sets(&ViewState::colouring, Colouring::Plain)},
      {"c", "c", "ceilings on and off", "--no-ceiling", flips(&ViewState::ceiling)},
      {"F1", "F1 to F9", "storey 1 to 9 alone, or all again", "--storey", storey(1)},
      {"F2", "F2", "", "", storey(2)},
      {"F3", "F3", "", "", storey(3)},
      {"F4", "F4", "", "", storey(4)},
      {"F5", "F5", "", "", storey(5)},
      {"F6", "F6", "", "", storey(6)},
      {"F7", "F7", "", "", storey(7)},
      {"F8", "F8", "", "", storey(8)},
      {"F9", "F9", "", "", storey(9)},
      {"Down", "Down", "clip 10 cm lower", "--clip", clips(-clip_step)},
      {"Up", "Up", "clip 10 cm higher", "--clip", clips(clip_step)},
      {"0", "0", "no clipping", "",
       sets(&ViewState::clip_height, ViewState::no_clipping)},
      {"e", "e", "edges of the solid on and off", "--no-edges",
       flips(&ViewState::edges)},
      {"v", "v", "one view, or two: scan and model", "--two-views",
       flips(&ViewState::two_views)},
      {"g", "g", "legend on and off", "--no-legend", flips(&ViewState::legend)},
      {"plus", "+", "larger points", "--point-size", resizesPoints(1)},
      {"minus", "-", "smaller points", "--point-size", resizesPoints(-1)},
      {"t", "t", "view from the top", "--view top", goesTo(ViewPoint::Top)},
      {"i", "i", "view from outside, aslant", "--view iso", goesTo(ViewPoint::Iso)},
      {"p", "p", "view of a person in the largest room", "--view inside",
       goesTo(ViewPoint::Inside)},
      {"j", "j", "write sedr_view.png", "--screenshot", asks(KeyCommand::Screenshot)},
      {"h", "h", "print these keys", "", asks(KeyCommand::Help)},
      {"q", "q", "quit", "", asks(KeyCommand::Quit)},
  };
  return bindings;
}

KeyCommand
pressKey(const std::string& key, HeightRange heights, ViewState& state)
{
  const auto& bindings = keyBindings();
  const auto found =
      std::find_if(bindings.begin(), bindings.end(),
                   [&](const KeyBinding& binding) { return binding.key == key; });
  return found == bindings.end() ? KeyCommand::None : found->press(state, heights);
}

std::string
keyHelp()
{
  const auto line = [](const std::string& key, const std::string& does,
                       const std::string& option) {
    std::string text =
        "  " + key + std::string(key.size() < 14 ? 14 - key.size() : 1, ' ') + does;
    if (!option.empty())
      text += std::string(text.size() < 56 ? 56 - text.size() : 1, ' ') + option;
    return text + "\n";
  };
  std::string help = "Keys, and the option that does the same:\n";
  for (const auto& binding : keyBindings())
    if (!binding.does.empty())
      help += line(binding.shown, binding.does, binding.option);
  help += "Mouse:\n";
  help += line("left", "turn", "");
  help += line("middle", "shift", "");
  help += line("right, wheel", "nearer and farther", "");
  help +=
      line("shift + left", "tell what a point is: label, room, element, distance", "");
  return help;
}

} // namespace pcl::sedr::tools
