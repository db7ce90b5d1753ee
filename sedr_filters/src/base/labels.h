// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_types.h>

#include <cstdint>

namespace pcl::sedr {

/** @brief Returns a label as the value of a point's field. */
inline std::uint32_t
valueOf(StructureLabel label)
{
  return static_cast<std::uint32_t>(label);
}

/** @brief Colour of a label in exported meshes, channels from 0 to 1. */
struct LabelColour {
  StructureLabel label;
  double red, green, blue;
};

constexpr LabelColour label_colours[] = {{StructureLabel::Ceiling, 0.93, 0.93, 0.90},
                                         {StructureLabel::Floor, 0.72, 0.58, 0.42},
                                         {StructureLabel::Wall, 0.82, 0.84, 0.86},
                                         {StructureLabel::Detail, 0.42, 0.62, 0.78},
                                         {StructureLabel::Column, 0.80, 0.45, 0.35}};

/** @brief Returns the colour of a label's number; grey for others. */
inline LabelColour
colourOf(std::uint32_t label)
{
  for (const LabelColour& colour : label_colours)
    if (static_cast<std::uint32_t>(colour.label) == label)
      return colour;
  return {StructureLabel::Other, 0.6, 0.6, 0.6};
}

} // namespace pcl::sedr
