// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <iterator>
#include <string>

namespace pcl::sedr {

/** @brief A colour, 0xRRGGBB, or none. */
using SheetColour = int;
constexpr SheetColour no_colour = -1;
constexpr SheetColour paper_colour = 0xffffff;
constexpr SheetColour room_colour = 0xf6f3ec;
constexpr SheetColour ink = 0x111111;

/** @brief Look of lines and areas of a sheet; widths and dashes in millimetres of
 * paper. */
struct SheetLook {
  const char* name;
  SheetColour fill;
  SheetColour stroke;
  double width;
  double dash[4] = {0, 0, 0, 0}; ///< strokes and gaps; solid if the first is 0
};

constexpr SheetLook sheet_looks[] = {
    {"room", room_colour, no_colour, 0},
    {"wall_body", 0xbdb8ae, no_colour, 0},
    {"wall", no_colour, ink, 0.5},
    {"column", 0x7d7d7d, ink, 0.35},
    {"detail", no_colour, 0x2b62a8, 0.2, {1.8, 0.9}},
    {"ridge", no_colour, 0x2b62a8, 0.3, {5, 1, 0.6, 1}},
    {"headroom", no_colour, 0xb3562b, 0.2, {0.8, 0.8}},
    {"floor_detail", no_colour, 0x333333, 0.2},
    {"niche", room_colour, 0x333333, 0.3},
    {"doorway", room_colour, no_colour, 0},
    {"gap", no_colour, room_colour, 0.8},
    {"jamb", no_colour, ink, 0.25},
    {"line", no_colour, 0x555555, 0.15},
    {"tick", no_colour, ink, 0.35},
    {"frame", no_colour, ink, 0.5},
    {"cell", no_colour, ink, 0.18},
    {"north", ink, no_colour, 0},
    {"bar_dark", ink, ink, 0.15},
    {"bar_light", paper_colour, ink, 0.15}};

struct TextLook {
  const char* name;
  SheetColour colour;
};

constexpr TextLook text_looks[] = {
    {"name", ink},          {"size", 0x444444},        {"level", 0x2b62a8},
    {"headroom", 0xb3562b}, {"floor_level", 0x2b62a8}, {"stair", 0x2b62a8},
    {"title", ink},         {"caption", 0x777777}};

template <typename Looks>
const auto&
lookNamed(const Looks& looks, const std::string& name)
{
  return *std::find_if(std::begin(looks), std::end(looks) - 1,
                       [&](const auto& look) { return name == look.name; });
}

} // namespace pcl::sedr
