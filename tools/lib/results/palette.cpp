// SPDX-License-Identifier: BSD-3-Clause
#include "palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace pcl::sedr::tools {

Colour
roomColour(std::uint32_t room)
{
  static constexpr std::array<Colour, 12> list{{{102, 166, 220},
                                                {244, 178, 98},
                                                {128, 196, 128},
                                                {222, 120, 118},
                                                {178, 148, 210},
                                                {176, 136, 122},
                                                {232, 160, 208},
                                                {160, 160, 160},
                                                {204, 204, 100},
                                                {96, 200, 210},
                                                {70, 120, 170},
                                                {180, 100, 40}}};
  return room == 0 ? colours::other : list[(room - 1) % list.size()];
}

Colour
distanceColour(double distance, double range)
{
  static constexpr std::array<Colour, 5> stops{
      {{44, 90, 200}, {40, 170, 90}, {240, 214, 50}, {240, 140, 30}, {200, 30, 30}}};
  if (std::isnan(distance))
    return colours::other;
  const double place =
      std::clamp(distance / range, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  return mixed(stops[i], stops[i + 1], place - static_cast<double>(i));
}

std::string
distanceText(double metres)
{
  const double centimetres = 100 * metres;
  const bool is_whole = std::abs(centimetres - std::round(centimetres)) < 1e-9;
  const int digits = metres >= 1 ? 1 : is_whole ? 0 : centimetres < 0.1 ? 2 : 1;
  char text[40];
  std::snprintf(text, sizeof text, metres >= 1 ? "%.*f m" : "%.*f cm", digits,
                metres >= 1 ? metres : centimetres);
  return text;
}

std::string
hexCode(Colour colour)
{
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", colour.red, colour.green,
                colour.blue);
  return text;
}

} // namespace pcl::sedr::tools
