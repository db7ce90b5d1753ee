// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "view_state.h"

#include <functional>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What is to be done after a key, besides drawing anew. */
enum class KeyCommand {
  None, ///< the key means nothing
  Redraw,
  MoveCamera, ///< to the view point of the state
  Screenshot,
  Help,
  Quit
};

/** @brief A key, and the option that does the same from the start. */
struct KeyBinding {
  std::string key;    ///< its symbol as X and VTK name it: "c", "Up", "plus"
  std::string shown;  ///< as people call it: "+"
  std::string does;   ///< "ceilings on and off"; empty where another key tells it
  std::string option; ///< "--no-ceiling"; empty for none
  std::function<KeyCommand(ViewState&, HeightRange)> press;
};

/** @brief Every key of the viewer, once. */
const std::vector<KeyBinding>& keyBindings();

/** @brief Lets a key change the state. Unknown keys change nothing. */
KeyCommand pressKey(const std::string& key, HeightRange heights, ViewState& state);

/** @brief The keys, a line each, with what the mouse does. */
std::string keyHelp();

} // namespace tools
} // namespace sedr
} // namespace pcl
