// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_surface/src/sheet/sheet.h"
#include <pcl/sedr_filters/point_types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace pcl::sedr::tools {

using Colour = SheetColour;

/** @brief Meanings of colours, the same in all pictures. */
namespace colours {
constexpr Colour paper = paper_colour;
constexpr Colour ink = 0x222222;   ///< text, the lines of a plan
constexpr Colour faint = 0xd6d6d6; ///< frames and context
constexpr Colour other = 0x9b9b9b;
constexpr Colour ceiling = 0xf0901e;
constexpr Colour floor = 0x2d72c4;
constexpr Colour wall = 0x36a04a;
constexpr Colour detail = 0xd8302c;
constexpr Colour column = 0x8d44b0;
constexpr Colour removed = 0x3c3c3c;
constexpr Colour recovered = 0xe7298a; ///< added by a stage
constexpr Colour arc = 0x0096be;
} // namespace colours

/** @brief Returns red, green and blue, 0 to 255 each. */
constexpr std::array<std::uint8_t, 3>
channelsOf(Colour colour)
{
  return {static_cast<std::uint8_t>(colour >> 16 & 0xff),
          static_cast<std::uint8_t>(colour >> 8 & 0xff),
          static_cast<std::uint8_t>(colour & 0xff)};
}

/** @brief Returns the colour of a room, one of twelve that are easily told apart; grey
 * for room 0, none. */
constexpr Colour
roomColour(std::uint32_t room)
{
  constexpr Colour list[] = {0x66a6dc, 0xf4b262, 0x80c480, 0xde7876,
                             0xb294d2, 0xb0887a, 0xe8a0d0, 0xa0a0a0,
                             0xcccc64, 0x60c8d2, 0x4678aa, 0xb46428};
  return room == 0 ? colours::other : list[(room - 1) % 12];
}

constexpr Colour
colourOf(StructureLabel label)
{
  constexpr Colour list[] = {colours::other, colours::ceiling, colours::floor,
                             colours::wall,  colours::detail,  colours::column};
  return list[label <= StructureLabel::Column ? static_cast<std::uint32_t>(label) : 0];
}

/** @brief Returns `a` blended with `share` (0 to 1) of `b`. */
constexpr Colour
mixed(Colour a, Colour b, double share)
{
  Colour colour = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const int from = channelsOf(a)[k];
    const int to = channelsOf(b)[k];
    colour = colour << 8 | static_cast<Colour>(from + (to - from) * share + 0.5);
  }
  return colour;
}

constexpr Colour
lightened(Colour colour, double share)
{
  return mixed(colour, colours::paper, share);
}

constexpr Colour
darkened(Colour colour, double share)
{
  return mixed(colour, 0, share);
}

/** @brief Returns the colour of a distance from the model (paper, Figure 11): from blue
 * at 0 through green, yellow and orange to red at `range` metres and more; grey for
 * NaN. */
Colour distanceColour(double distance, double range);

/** @brief Formats a distance: "0.3 cm", "4 cm", "1.2 m". */
std::string distanceText(double metres);

/** @brief Formats a colour: "#f0901e". */
std::string hexCode(Colour colour);

} // namespace pcl::sedr::tools
