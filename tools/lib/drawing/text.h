// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "image.h"

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Where a text stands from its place. */
enum class Anchor { Left, Middle, Right };

/** @brief A line of text, ASCII only: the font that is built in has no more. */
struct Text {
  std::string line;
  double x = 0; ///< pixels; of its left end, middle or right end
  double y = 0; ///< of the middle of its letters, from the top
  int size = 13;
  Colour colour = colours::ink;
  Anchor anchor = Anchor::Left;
  bool is_bold = false;
  bool has_halo = false; ///< a white rim, to be read on any ground
};

/** @brief Width of a text, pixels. */
int widthOf(const Text& text);

/** @brief Draws a text into an image, cut off at its edges. */
void drawText(const Text& text, Image& image);

} // namespace tools
} // namespace sedr
} // namespace pcl
