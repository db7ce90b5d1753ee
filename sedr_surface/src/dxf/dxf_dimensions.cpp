// SPDX-License-Identifier: BSD-3-Clause
#include "dxf_dimensions.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {
namespace {

constexpr const char* style_name = "STANDARD";

} // namespace

void
DxfDimensions::add(const DxfDimension& dimension)
{
  const auto& [from, to, start, end, text, degrees] = dimension;
  const double length = (end - start).norm();
  const Eigen::Vector2d way = (end - start) / length;
  const Eigen::Vector2d left(-way.y(), way.x());
  const std::string block = "*D" + std::to_string(++count_);
  blocks_.group(0, "BLOCK").group(8, "0").group(2, block).group(70, 1);
  blocks_.place({0, 0}).group(3, block).group(1, "");
  const Eigen::Vector2d tick = text_height_ / 3 * (way + left);
  blocks_.line("0", start, end).line("0", start - tick, start + tick);
  blocks_.line("0", end - tick, end + tick);
  for (const auto& [corner, at] :
       {std::make_pair(from, start), std::make_pair(to, end)}) {
    const double distance = (at - corner).norm();
    const Eigen::Vector2d out = (at - corner) / std::max(distance, 1e-9);
    if (distance > 3 * text_height_)
      blocks_.line("0", corner + text_height_ / 2 * out, at + text_height_ / 2 * out);
  }
  blocks_.label("0", text, text_height_, decimalText(length, 2), degrees);
  blocks_.group(0, "ENDBLK").group(8, "0");
  constexpr int rotated = 0; // all programs measure it along the angle
  constexpr int has_place_of_text = 128;
  entities_.group(0, "DIMENSION").group(8, layer_).group(2, block).group(3, style_name);
  entities_.place(end).place(text, 11).group(70, rotated + has_place_of_text);
  entities_.group(1, "").place(from, 13).place(to, 14);
  entities_.group(50, std::atan2(way.y(), way.x()) * 180 / M_PI);
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

} // namespace pcl::sedr
