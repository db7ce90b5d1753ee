// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "image.h"

#include <string>

namespace pcl::sedr::tools {

/** @brief Horizontal alignment of a text. */
enum class Anchor { Left, Middle, Right };

/** @brief A line of ASCII text, the range of the built-in font. */
struct Text {
  std::string line;
  double x = 0; ///< of its left end, centre or right end, pixels
  double y = 0; ///< of the centre of its letters, from the top
  int size = 13;
  Colour colour = colours::ink;
  Anchor anchor = Anchor::Left;
  bool is_bold = false;
  bool has_halo = false; ///< white outline, readable on any background
};

/** @brief Returns the width of a text, pixels. */
int widthOf(const Text& text);

/** @brief Draws a text into an image, clipped at its edges. */
void drawText(const Text& text, Image& image);

} // namespace pcl::sedr::tools
