// SPDX-License-Identifier: BSD-3-Clause
#include "furniture.h"

#include "simulator/scan/assembly.h"

#include <algorithm>

namespace pcl::sedr::sim {

namespace {

void
addLegs(Assembly& assembly, double half_width, double half_depth, double height)
{
  constexpr double thickness = 0.05;
  for (const double x : {-half_width, half_width - thickness})
    for (const double y : {-half_depth, half_depth - thickness})
      assembly.add({x, y, 0.0}, {x + thickness, y + thickness, height});
}

/** @brief Adds books of varying height on about two thirds of a board's width. */
void
addBooks(Assembly& assembly, const Extent& shelf, double board, double room, int row)
{
  constexpr double width = 0.21;
  const double half_width = 0.5 * shelf.width;
  int place = 0;
  for (double x = -half_width + 0.03; x + width < half_width - 0.03; x += width) {
    ++place;
    if ((place + row) % 3 == 0)
      continue;
    const double height = room * (0.62 + 0.08 * ((place * 7 + row * 3) % 4));
    const double front = -0.5 * shelf.depth + 0.04 + 0.01 * ((place * 5 + row) % 4);
    assembly.add({x, front, board},
                 {x + width, 0.5 * shelf.depth - 0.02, board + height});
  }
}

} // namespace

Object
makeBlock(const std::string& name, const Spot& spot, const Extent& extent)
{
  Assembly assembly(name, spot);
  const double x = 0.5 * extent.width;
  const double y = 0.5 * extent.depth;
  assembly.add({-x, -y, 0.0}, {x, y, extent.height});
  return assembly.take();
}

Object
makeTable(const Spot& spot, const Extent& extent)
{
  Assembly assembly("table", spot);
  const double x = 0.5 * extent.width;
  const double y = 0.5 * extent.depth;
  const double under = extent.height - 0.03;
  assembly.add({-x, -y, under}, {x, y, extent.height});
  addLegs(assembly, x - 0.04, y - 0.04, under);
  return assembly.take();
}

Object
makeChair(const Spot& spot)
{
  Assembly assembly("chair", spot);
  constexpr double half = 0.5 * kChairWidth;
  addLegs(assembly, half, half, 0.43);
  assembly.add({-half, -half, 0.43}, {half, half, 0.47});
  assembly.add({-half, half - 0.04, 0.47}, {half, half, 0.92});
  return assembly.take();
}

Object
makeShelf(const Spot& spot, const Extent& extent)
{
  constexpr double board = 0.02;
  Assembly assembly("shelf", spot);
  const double x = 0.5 * extent.width;
  const double y = 0.5 * extent.depth;
  assembly.add({-x, -y, 0.0}, {-x + board, y, extent.height});
  assembly.add({x - board, -y, 0.0}, {x, y, extent.height});
  assembly.add({-x + board, y - 0.01, 0.0}, {x - board, y, extent.height});
  const int rows = std::max(1, static_cast<int>(std::lround(extent.height / 0.35)));
  const double pitch = (extent.height - board) / rows;
  for (int row = 0; row <= rows; ++row) {
    const double z = row * pitch;
    assembly.add({-x + board, -y, z}, {x - board, y - 0.01, z + board});
    if (row < rows)
      addBooks(assembly, extent, z + board, pitch - board, row);
  }
  return assembly.take();
}

Object
makeLamp(Vec2 center, double ceiling, double drop, double radius)
{
  const double shade = std::min(0.25, 0.5 * drop);
  Object lamp;
  lamp.name = "lamp";
  lamp.cylinders.push_back({lifted(center, ceiling - drop), radius, shade});
  lamp.cylinders.push_back(
      {lifted(center, ceiling - drop + shade), 0.008, drop - shade});
  return lamp;
}

Object
makeFixture(const std::string& name,
            Vec2 center,
            double yaw,
            const Extent& extent,
            double ceiling,
            double drop)
{
  constexpr double rod = 0.004;
  constexpr double inset = 0.05;
  const double top = ceiling - drop;
  Object object = makeBlock(name, {center, yaw, top - extent.height}, extent);
  if (drop > 0.0)
    for (const double x : {inset - 0.5 * extent.width, 0.5 * extent.width - inset})
      for (const double y : {inset - 0.5 * extent.depth, 0.5 * extent.depth - inset})
        object.cylinders.push_back(
            {lifted(center + rotated({x, y}, yaw), top), rod, drop});
  return object;
}

Object
makeDuct(Vec2 from, Vec2 to, double radius, double top)
{
  constexpr int boards = 48;
  const Vec2 along = to - from;
  const Vec2 center = 0.5 * (from + to);
  Object duct;
  duct.name = "duct";
  for (int i = 0; i < boards; ++i) {
    const double low = -radius * std::cos(pi * i / boards);
    const double high = -radius * std::cos(pi * (i + 1) / boards);
    const double half_width = radius * std::sin(pi * (i + 0.5) / boards);
    duct.boxes.push_back({lifted(center, top - radius + 0.5 * (low + high)),
                          {length(along), 2.0 * half_width, high - low},
                          std::atan2(along.y, along.x)});
  }
  return duct;
}

Object
makeStairs(const Spot& spot, const Flight& flight)
{
  constexpr double thickness = 0.15; // metres below the inner corners of the steps
  Assembly stairs(kStairs, spot);
  for (std::size_t i = 0; i < flight.steps; ++i) {
    const double y = static_cast<double>(i) * flight.going;
    const double top = static_cast<double>(i + 1) * flight.rise;
    const double bottom =
        flight.is_solid ? 0.0 : std::max(0.0, top - flight.rise - thickness);
    stairs.add({-0.5 * flight.width, y, bottom},
               {0.5 * flight.width, y + flight.going, top});
  }
  return stairs.take();
}

Object
makeTree(const Spot& spot, double height, double crown_radius)
{
  Object tree;
  tree.name = "tree";
  const double trunk = 0.4 * height;
  tree.cylinders.push_back({lifted(spot.center, spot.floor), 0.15, trunk});
  tree.cylinders.push_back(
      {lifted(spot.center, spot.floor + trunk), crown_radius, 0.4 * height});
  tree.cylinders.push_back({lifted(spot.center, spot.floor + trunk + 0.4 * height),
                            0.6 * crown_radius, 0.2 * height});
  return tree;
}

Object
makeCar(const Spot& spot)
{
  Assembly assembly("car", spot);
  constexpr double x = 0.5 * kCarLength;
  constexpr double y = 0.5 * kCarWidth;
  assembly.add({-x, -y, 0.25}, {x, y, 0.85});
  assembly.add({-1.3, -0.8, 0.85}, {1.0, 0.8, 1.45});
  return assembly.take();
}

Object
makeDoorLeaf(Vec2 hinge, double direction, double width, double height, double floor)
{
  constexpr double thickness = 0.04;
  Object leaf;
  leaf.name = "door leaf";
  const Vec2 center = hinge + rotated({0.5 * width, 0.0}, direction);
  leaf.boxes.push_back({lifted(center, floor + 0.5 * height + 0.005),
                        {width, thickness, height - 0.01},
                        direction});
  return leaf;
}

Spot
spotAtWall(const Element& wall, double s, double depth, double gap, double width)
{
  const Vec2 outward = rightNormalAt(wall, s);
  double clearance = gap;
  if (wall.bulge > 0.0) {
    const double reach = arcOf(wall).radius - gap;
    clearance += reach - std::sqrt(reach * reach - 0.25 * width * width);
  }
  Spot spot;
  spot.center = pointAt(wall, s) - (clearance + 0.5 * depth) * outward;
  spot.yaw = std::atan2(outward.y, outward.x) - 0.5 * pi;
  return spot;
}

} // namespace pcl::sedr::sim
