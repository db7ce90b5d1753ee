// SPDX-License-Identifier: BSD-3-Clause
#include "text.h"

#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>

#include <cmath>
#include <vector>

namespace pcl::sedr::tools {

namespace {

constexpr int dots_per_inch = 72; // one point is one pixel

/** @brief Coverage of each pixel by a text, 0 to 1, relative to its left end on the
 * baseline. */
struct TextMask {
  int left = 0;
  int bottom = 0; ///< lowest row, upwards from the baseline
  int width = 0;
  int height = 0;
  std::vector<double> ink; ///< row by row from the bottom
};

void
describe(const Text& text, vtkTextProperty& property)
{
  property.SetFontFamilyToArial();
  property.SetFontSize(text.size);
  property.SetBold(text.is_bold ? 1 : 0);
  property.SetColor(0, 0, 0);
}

TextMask
maskOf(const Text& text)
{
  TextMask mask;
  if (text.line.empty())
    return mask;
  vtkNew<vtkTextProperty> property;
  describe(text, *property);
  vtkNew<vtkImageData> data;
  int size[2] = {0, 0};
  vtkFreeTypeTools* font = vtkFreeTypeTools::GetInstance();
  font->ScaleToPowerTwoOff();
  if (!font->RenderString(property, vtkStdString(text.line), dots_per_inch, data, size))
    return mask;
  const int* extent = data->GetExtent();
  mask.left = extent[0];
  mask.bottom = extent[2];
  mask.width = extent[1] - extent[0] + 1;
  mask.height = extent[3] - extent[2] + 1;
  for (int y = extent[2]; y <= extent[3]; ++y)
    for (int x = extent[0]; x <= extent[1]; ++x) {
      const auto* rgba =
          static_cast<const unsigned char*>(data->GetScalarPointer(x, y, 0));
      mask.ink.push_back(rgba[3] / 255.0);
    }
  return mask;
}

void
stamp(const TextMask& mask, int left, int base, Colour colour, Image& image)
{
  for (int row = 0; row < mask.height; ++row)
    for (int column = 0; column < mask.width; ++column) {
      const double ink = mask.ink[static_cast<std::size_t>(row) *
                                      static_cast<std::size_t>(mask.width) +
                                  static_cast<std::size_t>(column)];
      const int x = left + mask.left + column;
      const int y = base - mask.bottom - row;
      if (ink > 0 && x >= 0 && y >= 0 && x < image.width && y < image.height)
        image.at(x, y) = mixed(image.at(x, y), colour, ink);
    }
}

} // namespace

int
widthOf(const Text& text)
{
  const TextMask mask = maskOf(text);
  return mask.left + mask.width;
}

void
drawText(const Text& text, Image& image)
{
  const TextMask mask = maskOf(text);
  const double width = mask.left + mask.width;
  const double share = text.anchor == Anchor::Left     ? 0
                       : text.anchor == Anchor::Middle ? 0.5
                                                       : 1;
  const auto left = static_cast<int>(std::lround(text.x - share * width));
  // A capital letter is 0.7 times as high as its font size.
  const auto base = static_cast<int>(std::lround(text.y + 0.35 * text.size));
  if (text.has_halo)
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx)
        if (dx * dx + dy * dy <= 5)
          stamp(mask, left + dx, base + dy, colours::paper, image);
  stamp(mask, left, base, text.colour, image);
}

} // namespace pcl::sedr::tools
