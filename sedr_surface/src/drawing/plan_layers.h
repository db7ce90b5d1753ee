// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheet/sheet.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

#include <array>
#include <cstddef>

namespace pcl::sedr {

/** @brief What a line, an area or a text of a drawing tells of. */
enum class PlanLayer {
  Wall,
  Outside, ///< far sides of walls with one seen face, as far as reveals are deep
  Guess,   ///< walls of which hardly anything was measured
  Column,
  Niche,
  Door,
  Window,
  Ceiling,  ///< edges of details, steps of a ceiling that is not level
  Ridge,    ///< ridges, hips and valleys
  Contour,  ///< of vaults and domes
  Slope,    ///< arrows up slopes of a ceiling
  Headroom, ///< where a ceiling that is not level is 1.5 or 2.3 m above the floor
  Floor,    ///< steps, platforms and slopes
  Stair,    ///< flights: treads, the way up
  Beyond,   ///< edges behind a section
  Room,     ///< numbers, areas and heights of rooms
  Height,   ///< heights of ceilings
  Dimension,
  Number,  ///< numbers of walls
  Unseen,  ///< what nobody saw of a wall
  Section, ///< marks of sections
  Note
};

/** @brief How a layer looks on a sheet, in millimetres, and in a DXF. */
struct LayerStyle {
  const char* dxf_name; ///< of the US National CAD Standard (AIA)
  int dxf_colour;       ///< index of AutoCAD's palette
  bool is_dashed;       ///< in a DXF
  SheetLook line;
  SheetColour text;
};

/** @brief Areas and marks without a layer of their own. */
namespace looks {
constexpr SheetColour room_colour = 0xf6f3ec;
constexpr SheetColour blue = 0x2b62a8;
inline const SheetLook room{room_colour};
inline const SheetLook column{0x7d7d7d};
inline const SheetLook wall_body{0xbdb8ae};
inline const SheetLook assumed_body{0xe6e3dc};
inline const SheetLook jamb{no_colour, ink, 0.25};
inline const SheetLook leaf{no_colour, ink, 0.5};
inline const SheetLook thin{no_colour, 0x555555, 0.15};
inline const SheetLook tick{no_colour, ink, 0.35};
inline const SheetLook frame{no_colour, ink, 0.5};
inline const SheetLook cell{no_colour, ink, 0.18};
} // namespace looks

/** In the order of PlanLayer. */
inline const std::array<LayerStyle, 22> layer_styles{
    {{"A-WALL", 7, false, {no_colour, ink, 0.5}, ink},
     {"A-WALL-EXTR", 8, true, {no_colour, 0x9a9a9a, 0.35, {1.6, 1}}, 0x9a9a9a},
     {"A-WALL-GUES", 8, true, {no_colour, 0x9a9a9a, 0.35, {0.6, 1}}, 0x9a9a9a},
     {"A-COLS", 1, false, {no_colour, ink, 0.35}, 0x444444},
     {"A-WALL-NICH", 6, false, {no_colour, 0x333333, 0.3}, ink},
     {"A-DOOR", 4, false, {no_colour, ink, 0.25}, 0x444444},
     {"A-GLAZ", 4, false, {no_colour, ink, 0.25}, 0x444444},
     {"A-CLNG", 5, true, {no_colour, looks::blue, 0.2, {1.8, 0.9}}, looks::blue},
     {"A-CLNG-RIDG",
      5,
      true,
      {no_colour, looks::blue, 0.3, {5, 1, 0.6, 1}},
      looks::blue},
     {"A-CLNG-CNTR", 5, false, {no_colour, looks::blue, 0.15}, looks::blue},
     {"A-CLNG-SLPE", 30, false, {no_colour, 0xb3562b, 0.25}, 0xb3562b},
     {"A-CLNG-HEAD", 30, true, {no_colour, 0xb3562b, 0.2, {0.8, 0.8}}, 0xb3562b},
     {"A-FLOR-LEVL", 3, false, {no_colour, 0x333333, 0.2}, looks::blue},
     {"A-FLOR-STRS", 3, false, {no_colour, 0x333333, 0.2}, looks::blue},
     {"A-SECT-BYND", 8, false, {no_colour, 0x777777, 0.18}, 0x777777},
     {"A-AREA-IDEN", 7, false, {}, ink},
     {"A-CLNG-IDEN", 5, false, {}, looks::blue},
     {"A-ANNO-DIMS", 8, false, {no_colour, 0x444444, 0.13}, 0x444444},
     {"A-WALL-IDEN", 9, false, {}, 0x8a8a8a},
     {"A-WALL-UNSN", 9, false, {no_colour, 0x9a9a9a, 0.13}, ink},
     {"A-ANNO-SECT", 1, false, {no_colour, ink, 0.5}, ink},
     {"A-ANNO-TEXT", 7, false, {}, looks::blue}}};

/** @param view edges of ceilings are dashed only where they are seen from above */
inline LayerStyle
styleOf(PlanLayer layer, DrawingView view = DrawingView::Floor)
{
  LayerStyle style = layer_styles[static_cast<std::size_t>(layer)];
  if (layer == PlanLayer::Ceiling && view == DrawingView::Ceiling) {
    style.is_dashed = false;
    style.line.dash.clear();
  }
  return style;
}

/** @brief Returns whether a layer has faces of walls. */
inline bool
isWall(PlanLayer layer)
{
  return layer <= PlanLayer::Guess;
}

/** @brief Font sizes, millimetres; the letters of the larger ones are 1.8 and 2.5 mm
 * high, as usual in ISO 3098. */
constexpr double smallest_font = 1.8;
constexpr double small_font = 2.5;
constexpr double large_font = 3.5;

} // namespace pcl::sedr
