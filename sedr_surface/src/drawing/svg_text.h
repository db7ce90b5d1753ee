// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../formats/decimal_text.h"

#include <string>

namespace pcl {
namespace sedr {

/** @brief How the parts of a drawing look, by their class. */
constexpr const char* svg_style = R"(
  text { font-family: Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif; }
  .room { fill: #f6f3ec; fill-rule: evenodd; stroke: none; }
  .wall { fill: none; stroke: #111; stroke-width: 0.5; stroke-linejoin: miter; }
  .column { fill: #7d7d7d; stroke: #111; stroke-width: 0.35; }
  .detail { fill: none; stroke: #2b62a8; stroke-width: 0.2; stroke-dasharray: 1.8 0.9; }
  .floor_detail { fill: none; stroke: #333; stroke-width: 0.2; }
  .niche { fill: #f6f3ec; stroke: #333; stroke-width: 0.3; }
  .doorway { fill: #f6f3ec; stroke: none; }
  .gap { fill: none; stroke: #f6f3ec; stroke-width: 0.8; }
  .jamb { fill: none; stroke: #111; stroke-width: 0.25; stroke-linecap: square; }
  .line { fill: none; stroke: #555; stroke-width: 0.15; }
  .frame { fill: none; stroke: #111; stroke-width: 0.25; }
  .north { fill: #111; stroke: none; }
  .size { fill: #555; text-anchor: middle; }
  .level { fill: #2b62a8; text-anchor: middle; }
  .name { fill: #111; text-anchor: middle; }
  .start { text-anchor: start; }
  .halo { paint-order: stroke; stroke: #f6f3ec; stroke-width: 0.8;
    stroke-linejoin: round; }
)";

/** @brief A length on paper, millimetres. */
inline std::string
mm(double value)
{
  return shortDecimalText(value, 4);
}

/** @brief A name as it may stand in XML: control characters are blanks. */
inline std::string
svgText(const std::string& name)
{
  std::string text;
  for (const char c : name)
    text += c == '&'   ? "&amp;"
            : c == '<' ? "&lt;"
                       : std::string(1, c >= 0 && c < ' ' ? ' ' : c);
  return text;
}

} // namespace sedr
} // namespace pcl
