// SPDX-License-Identifier: BSD-3-Clause
#include "dxf_texts.h"

#include "../drawing/doorway_drawing.h"
#include "../drawing/roof_lines.h"
#include "../sheet/plan_frame.h"
#include "../sheet/text_places.h"

#include <algorithm>

namespace pcl {
namespace sedr {

using namespace dxf_layers;

namespace {

/** @brief A height of text that fits, but may still be read. */
double
fitting(double usual, double space)
{
  return std::clamp(space, usual / 2, usual);
}

} // namespace

const char*
nameOf(DrawnLayer layer)
{
  switch (layer) {
  case DrawnLayer::Wall:
    return "A-WALL";
  case DrawnLayer::Column:
    return "A-COLS";
  case DrawnLayer::Detail:
    return "A-CLNG";
  case DrawnLayer::Ridge:
    return "A-CLNG-RIDG";
  case DrawnLayer::FloorDetail:
    return "A-FLOR-LEVL";
  case DrawnLayer::Niche:
    return "A-WALL-NICH";
  default:
    return "A-CLNG-HEAD";
  }
}

void
DxfTexts::writeRoom(const PlanRoom& room)
{
  const TextSpot spot = textSpotIn(room.boundary, room.columns);
  const double height = fitting(name_height_, spot.radius / 4);
  Eigen::Vector2d place = spot.place + Eigen::Vector2d(0, 1.5 * height);
  for (const std::string& line : roomTexts(room, spot.place, "m2")) {
    dxf_.label(name_layer, place, height, line);
    place.y() -= 1.5 * height;
  }
  for (const LevelNote& note : levelNotes(room, spot))
    dxf_.label(note.layer == DrawnLayer::FloorDetail ? nameOf(note.layer)
                                                     : height_layer,
               note.spot.place, fitting(height_, note.spot.radius / 2), note.text);
  for (const PlanElement& wall : room.boundary.elements) {
    writeAlong(height_layer, wall, eavesText(room, wall), 2.5);
    if (wall.isArc())
      writeAlong(size_layer, wall, sizeText(wall), 1);
  }
  for (const PlanLoop& column : room.columns)
    writeColumn(column);
}

void
DxfTexts::writeAlong(const char* layer,
                     const PlanElement& line,
                     const std::string& text,
                     double off)
{
  if (text.empty() || line.length() < height_ * static_cast<double>(text.size()))
    return;
  const double middle = line.length() / 2;
  const Eigen::Vector2d normal = line.normalAt(middle);
  dxf_.label(layer, line.pointAt(middle) + off * height_ * normal, height_, text,
             readableAngle({normal.y(), -normal.x()}));
}

void
DxfTexts::writeWays(const Floorplan& plan)
{
  for (const DrawnDoorway& doorway : drawnDoorways(plan))
    for (std::size_t k = 0; k < 4; ++k)
      dxf_.line(door_layer, doorway.corners[k], doorway.corners[(k + 1) % 4]);
  for (const StairNote& note : stairNotes(plan))
    dxf_.label(text_layer, note.place, height_, note.text);
}

void
DxfTexts::writeBelow(const Eigen::AlignedBox2d& bounds, std::string text, double rows)
{
  for (char& c : text)
    c = c >= ' ' && c <= '~' ? c : '?';
  dxf_.label(text_layer,
             {bounds.center().x(), bounds.min().y() - 2 * rows * name_height_},
             name_height_, text);
}

void
DxfTexts::writeColumn(const PlanLoop& column)
{
  const Eigen::AlignedBox2d box = boundsOf(column);
  std::string text = columnText(column);
  if (text.empty())
    return;
  if (text.compare(0, 2, "Ø") == 0)
    text = "%%c" + text.substr(2); // the sign of a diameter in DXF
  dxf_.label(size_layer,
             {box.max().x() + 0.4 * height_ * static_cast<double>(text.size()),
              box.center().y()},
             height_, text);
}

} // namespace sedr
} // namespace pcl
