// SPDX-License-Identifier: BSD-3-Clause
#include "dxf_dimensions.h"

#include "plan_drawing.h"

#include <cmath>

namespace pcl {
namespace sedr {
namespace {

constexpr const char* style_name = "STANDARD";

} // namespace

void
DxfDimensions::add(const PlanElement& segment)
{
  const std::string text = sizeText(segment);
  const double length = segment.length();
  if (segment.isArc() || length < text_height_ * static_cast<double>(text.size()))
    return;
  const Eigen::Vector2d way = (segment.end - segment.start) / length;
  const Eigen::Vector2d inward(-way.y(), way.x());
  const double off = 2 * text_height_; // of the dimension's line from the wall
  const Eigen::Vector2d from = segment.start + off * inward;
  const Eigen::Vector2d to = segment.end + off * inward;
  const Eigen::Vector2d middle = (from + to) / 2 + 0.75 * text_height_ * inward;
  // Read from below or from the right; a degree for walls that are not quite upright.
  double degrees = std::atan2(way.y(), way.x()) * 180 / M_PI;
  if (degrees > 91)
    degrees -= 180;
  if (degrees <= -89)
    degrees += 180;
  const std::string block = "*D" + std::to_string(++count_);
  blocks_.group(0, "BLOCK").group(8, "0").group(2, block).group(70, 1);
  blocks_.place({0, 0}).group(3, block).group(1, "");
  const Eigen::Vector2d tick = text_height_ / 3 * (way + inward);
  blocks_.line("0", from, to).line("0", from - tick, from + tick);
  blocks_.line("0", to - tick, to + tick)
      .label("0", middle, text_height_, text, degrees);
  blocks_.group(0, "ENDBLK").group(8, "0");
  constexpr int rotated = 0; // which all programs measure along the angle
  entities_.group(0, "DIMENSION").group(8, layer_).group(2, block).group(3, style_name);
  entities_.place(to).place(middle, 11).group(70, rotated).group(1, "");
  entities_.place(segment.start, 13).place(segment.end, 14);
  entities_.group(50, degrees);
}

DxfText
DxfDimensions::table() const
{
  DxfText dxf;
  dxf.group(0, "TABLE").group(2, "DIMSTYLE").group(70, 1);
  dxf.group(0, "DIMSTYLE").group(2, style_name).group(70, 0);
  dxf.group(40, 1.0).group(41, text_height_).group(42, text_height_ / 4);
  dxf.group(44, text_height_ / 2).group(140, text_height_).group(77, 1);
  return dxf.group(0, "ENDTAB");
}

} // namespace sedr
} // namespace pcl
