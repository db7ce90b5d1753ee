// SPDX-License-Identifier: BSD-3-Clause
#include "window.h"

#include "tool_error.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>

namespace pcl::sedr::tools {

namespace {

constexpr double clip_step = 0.1; // metres
constexpr double no_clipping = std::numeric_limits<double>::infinity();
constexpr const char* screenshot_name = "sedr_view.png";

} // namespace

std::vector<Window::Key>
Window::makeKeys()
{
  std::vector<Key> keys;
  const auto add = [&](const std::string& symbol, const char* does, const char* option,
                       const std::function<void()>& press) {
    keys.push_back({symbol, does, option, press});
  };
  const auto flips = [this](bool ViewState::*member) {
    return [this, member] { state_.*member = !(state_.*member); };
  };
  const char* const layers[] = {"scan", "points of the structure", "Poisson mesh",
                                "sharp solid", "floor plan: lines black, arcs blue"};
  for (std::size_t k = 0; k < layer_names.size(); ++k)
    add(std::to_string(k + 1), layers[k], "--layers", [this, k] {
      if (state_.layers.erase(layer_names[k]) == 0)
        state_.layers.insert(layer_names[k]);
    });
  const char* const colours[][2] = {{"l", "label"},
                                    {"o", "room"},
                                    {"d", "distance"},
                                    {"n", "height"}};
  for (const auto& [symbol, name] : colours)
    add(symbol, name, "--colour", [this, name = name] { state_.colour = name; });
  add("c", "ceilings on and off", "--ceilings", flips(&ViewState::ceilings));
  add("r", "next room alone; all after the last", "--room", [this] { nextRoom(); });
  for (std::uint32_t number = 1; number <= 9; ++number)
    add("F" + std::to_string(number),
        number == 1 ? "to F9: storey 1 to 9 alone, or all again" : "", "--storey",
        [this, number] { toggleStorey(number); });
  add("Down", "clip 10 cm lower", "--clip", [this] { moveClipping(-clip_step); });
  add("Up", "clip 10 cm higher", "--clip", [this] { moveClipping(clip_step); });
  add("0", "no clipping", "", [this] { state_.clip_height = no_clipping; });
  add("e", "edges of the solid on and off", "", flips(&ViewState::edges));
  add("v", "one view, or two: scan and model", "--two-views",
      flips(&ViewState::two_views));
  add("g", "legend on and off", "--no-legend", flips(&ViewState::legend));
  add("plus", "larger points", "--point-size", [this] { state_.point_size += 1; });
  add("minus", "smaller points", "--point-size",
      [this] { state_.point_size = std::max(1.0, state_.point_size - 1); });
  const char* const views[][2] = {{"t", "top"}, {"i", "iso"}, {"p", "inside"}};
  for (const auto& [symbol, name] : views)
    add(symbol, name, "--view", [this, name = name] {
      state_.view = name;
      moveCamera();
    });
  add("j", "write sedr_view.png", "--screenshot", [this] { writeScreenshot(); });
  add("h", "print these keys", "", [this] { std::cout << help() << std::flush; });
  add("q", "quit", "", [this] { wants_to_quit_ = true; }); // closed outside of VTK
  return keys;
}

std::string
Window::help() const
{
  std::string text = "Keys, and the option that does the same:\n";
  const auto add = [&](const Key& key) {
    const bool is_name = key.option == "--colour" || key.option == "--view";
    const std::string option = key.option + (is_name ? " " + key.does : "");
    const std::string does = key.option == "--colour" ? "colours by " + key.does
                             : is_name                ? "view: " + key.does
                                                      : key.does;
    char line[120];
    std::snprintf(line, sizeof line, "  %-14s%-42s%s\n", key.symbol.c_str(),
                  does.c_str(), option.c_str());
    text += line;
  };
  for (const Key& key : keys_)
    if (!key.does.empty())
      add(key);
  text += "Mouse:\n";
  add({"left", "turn", "", {}});
  add({"middle", "shift", "", {}});
  add({"right, wheel", "nearer and farther", "", {}});
  add({"shift + left", "what is there: label, room, element, distance", "", {}});
  return text;
}

void
Window::onKey(const std::string& symbol)
{
  const auto key = std::find_if(keys_.begin(), keys_.end(), [&](const Key& known) {
    return known.symbol == symbol;
  });
  if (key == keys_.end())
    return;
  key->press();
  update();
  visualizer_->getRenderWindow()->Render();
}

void
Window::moveClipping(double by)
{
  const Eigen::AlignedBox3d box = result_.bounds();
  if (box.isEmpty() || (!std::isfinite(state_.clip_height) && by > 0))
    return;
  const double height =
      std::isfinite(state_.clip_height) ? state_.clip_height + by : box.max().z();
  constexpr double least = 0.01; // metres above the bottom, to leave something visible
  state_.clip_height =
      height > box.max().z() ? no_clipping : std::max(height, box.min().z() + least);
}

void
Window::toggleStorey(std::uint32_t number)
{
  if (result_.rules.find(number))
    state_.storey = state_.storey == number ? 0 : number;
}

void
Window::nextRoom()
{
  std::uint32_t next = 0;
  for (const PlanRoom& room : result_.plan.rooms)
    if (room.id > state_.room && (next == 0 || room.id < next))
      next = room.id;
  state_.room = next;
}

void
Window::writeScreenshot()
{
  try {
    saveScreenshot(screenshot_name);
    std::cout << "written: " << screenshot_name << std::endl;
  }
  catch (const ToolError& error) { // keeps the window open
    std::cerr << error.what() << std::endl;
  }
}

} // namespace pcl::sedr::tools
