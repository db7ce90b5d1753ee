// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "view_state.h"

#include <functional>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Action after a key, besides drawing again. */
enum class KeyCommand {
  None, ///< unknown key
  Redraw,
  MoveCamera, ///< to the state's view point
  Screenshot,
  Help,
  Quit
};

/** @brief A key, and the equivalent option at start. */
struct KeyBinding {
  std::string key;    ///< symbol in X and VTK: "c", "Up", "plus"
  std::string shown;  ///< for display: "+"
  std::string does;   ///< "ceilings on and off"; empty if another key explains it
  std::string option; ///< "--no-ceiling"; empty if there is none
  std::function<KeyCommand(ViewState&, HeightRange)> press;
};

/** @brief Returns every key of the viewer, once. */
const std::vector<KeyBinding>& keyBindings();

/** @brief Applies a key to the state. Unknown keys change nothing. */
KeyCommand pressKey(const std::string& key, HeightRange heights, ViewState& state);

/** @brief Returns a help text with one key per line, and the mouse actions. */
std::string keyHelp();

} // namespace pcl::sedr::tools
