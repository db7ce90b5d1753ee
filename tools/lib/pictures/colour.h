// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/structure_label.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace pcl::sedr::tools {

/** @brief A colour of a picture, 0 to 255 per channel. */
struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  friend constexpr bool operator==(Colour a, Colour b)
  {
    return a.red == b.red && a.green == b.green && a.blue == b.blue;
  }

  friend constexpr bool operator!=(Colour a, Colour b) { return !(a == b); }

  /** @brief Returns the number 0xRRGGBB. */
  constexpr std::int32_t number() const { return red << 16 | green << 8 | blue; }
};

/** @brief Meanings of colours, the same in all pictures. */
namespace colours {
constexpr Colour paper{255, 255, 255};
constexpr Colour ink{34, 34, 34};      ///< text, the lines of a plan
constexpr Colour faint{214, 214, 214}; ///< frames and context
constexpr Colour other{155, 155, 155};
constexpr Colour ceiling{240, 144, 30};
constexpr Colour floor{45, 114, 196};
constexpr Colour wall{54, 160, 74};
constexpr Colour detail{216, 48, 44};
constexpr Colour column{141, 68, 176};
constexpr Colour removed{60, 60, 60};
constexpr Colour recovered{231, 41, 138}; ///< added by a stage
constexpr Colour arc{0, 150, 190};
} // namespace colours

/** @brief Returns one of twelve colours that are easily told apart. */
constexpr Colour
colourNumber(std::size_t number)
{
  constexpr Colour list[] = {{102, 166, 220}, {244, 178, 98},  {128, 196, 128},
                             {222, 120, 118}, {178, 148, 210}, {176, 136, 122},
                             {232, 160, 208}, {160, 160, 160}, {204, 204, 100},
                             {96, 200, 210},  {70, 120, 170},  {180, 100, 40}};
  return list[number % 12];
}

/** @brief Returns the colour of a room; grey for room 0, none. */
constexpr Colour
roomColour(std::uint32_t room)
{
  return room == 0 ? colours::other : colourNumber(room - 1);
}

/** @brief Returns `a` blended with `share` (0 to 1) of `b`. */
constexpr Colour
mixed(Colour a, Colour b, double share)
{
  const auto mix = [share](std::uint8_t u, std::uint8_t v) {
    return static_cast<std::uint8_t>(u + (v - u) * share + 0.5);
  };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

constexpr Colour
lightened(Colour colour, double share)
{
  return mixed(colour, colours::paper, share);
}

constexpr Colour
darkened(Colour colour, double share)
{
  return mixed(colour, Colour{0, 0, 0}, share);
}

constexpr Colour
colourOf(StructureLabel label)
{
  constexpr Colour list[] = {colours::other, colours::ceiling, colours::floor,
                             colours::wall,  colours::detail,  colours::column};
  return list[label <= StructureLabel::Column ? static_cast<std::uint32_t>(label) : 0];
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
