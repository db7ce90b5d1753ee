// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colour.h"

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief 8-bit RGB pixels, row by row from the top left. */
struct Image {
  Image() = default;

  Image(int pixels_wide, int pixels_high, Colour background)
      : width(pixels_wide)
      , height(pixels_high)
      , pixels(static_cast<std::size_t>(pixels_wide) *
                   static_cast<std::size_t>(pixels_high),
               background)
  {}

  Colour& at(int x, int y) { return pixels[indexOf(x, y)]; }
  Colour at(int x, int y) const { return pixels[indexOf(x, y)]; }

  int width = 0;
  int height = 0;
  std::vector<Colour> pixels;

private:
  std::size_t indexOf(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

/** @brief Encodes an image as PNG; deterministic. */
std::string pngOf(const Image& image);

} // namespace pcl::sedr::tools
