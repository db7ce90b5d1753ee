// SPDX-License-Identifier: BSD-3-Clause
#include "colour.h"
#include "sedr_filters/src/base/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::sedr::tools {

Colour
distanceColour(double distance, double range)
{
  static constexpr std::array<Colour, 5> stops{
      {0x2c5ac8, 0x28aa5a, 0xf0d632, 0xf08c1e, 0xc81e1e}};
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
  return formatText(metres >= 1 ? "%.*f m" : "%.*f cm", digits,
                    metres >= 1 ? metres : centimetres);
}

std::string
hexCode(Colour colour)
{
  return formatText("#%06x", colour);
}

} // namespace pcl::sedr::tools
