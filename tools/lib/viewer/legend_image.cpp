// SPDX-License-Identifier: BSD-3-Clause
#include "legend_image.h"

#include "canvas.h"

#include <algorithm>

namespace pcl {
namespace sedr {
namespace tools {

namespace {

// Pixels.
constexpr int line_height = 19;
constexpr int margin = 8;
constexpr int patch = 12;
constexpr int patch_space = 20;

Text
textOf(const LegendLine& line)
{
  Text text;
  text.line = line.text;
  text.x = margin + (line.is_sample ? patch_space : 0);
  return text;
}

} // namespace

Image
drawLegend(const std::vector<LegendLine>& lines)
{
  if (lines.empty())
    return {};
  int width = 0;
  for (const auto& line : lines) {
    const Text text = textOf(line);
    width = std::max(width, static_cast<int>(text.x) + widthOf(text) + margin);
  }
  Canvas canvas(width, static_cast<int>(lines.size()) * line_height + 2 * margin);
  double y = margin + line_height / 2.0;
  for (const auto& line : lines) {
    if (line.is_sample)
      canvas.fillBox({{margin, y - patch / 2.0}, {margin + patch, y + patch / 2.0}},
                     line.colour);
    Text text = textOf(line);
    text.y = y;
    canvas.addText(text);
    y += line_height;
  }
  return canvas.image();
}

} // namespace tools
} // namespace sedr
} // namespace pcl
