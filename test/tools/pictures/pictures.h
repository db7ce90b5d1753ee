// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace programs {

using namespace pcl::sedr::tools;

/** Pixels row by row from the top left. */
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Colour> pixels{};

  Colour at(int x, int y) const
  {
    return pixels.at(static_cast<std::size_t>(y * width + x));
  }
};

/** Decodes a PNG file; empty if the bytes are invalid. */
inline Image
imageOf(std::string png)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetMemoryBuffer(png.data());
  reader->SetMemoryBufferLength(static_cast<vtkIdType>(png.size()));
  reader->Update();
  const int* size = reader->GetOutput()->GetDimensions();
  if (size[0] < 2 || reader->GetOutput()->GetNumberOfScalarComponents() != 3)
    return {};
  Image image{size[0], size[1]};
  for (int y = image.height - 1; y >= 0; --y)
    for (int x = 0; x < image.width; ++x) {
      const auto* p = static_cast<const std::uint8_t*>(
          reader->GetOutput()->GetScalarPointer(x, y, 0));
      image.pixels.push_back(p[0] << 16 | p[1] << 8 | p[2]);
    }
  return image;
}

/** Returns the colour of map `i` of a picture at a place, metres. */
inline Colour
colourAt(const Picture& picture, std::size_t i, const Eigen::Vector2d& place)
{
  const Panel& panel = picture.maps.at(i);
  pcl::sedr::Sheet sheet;
  sheet.size = {600, 600};
  const double scale = 600 / panel.view.sizes().maxCoeff();
  panel.draw({0, 0}, scale, sheet);
  EXPECT_TRUE(panel.view.contains(place)) << place.transpose();
  const Eigen::Vector2d at = scale * (place - panel.view.min());
  return imageOf(pcl::sedr::sheetPng(sheet))
      .at(static_cast<int>(at.x()), static_cast<int>(600 - at.y()));
}

/** Returns the cells of rows `y0` to `y1` and columns `x0` to `x1`, inclusive. */
inline pcl::sedr::CellSet
block(int x0, int x1, int y0, int y1)
{
  std::vector<pcl::sedr::CellKey> keys;
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x)
      keys.push_back(pcl::sedr::keyOf({x, y}));
  return pcl::sedr::CellSet(std::move(keys));
}

} // namespace programs
