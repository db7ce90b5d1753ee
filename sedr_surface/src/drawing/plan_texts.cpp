// SPDX-License-Identifier: BSD-3-Clause
#include "plan_texts.h"

#include "../formats/decimal_text.h"
#include "../overhead/eaves.h"
#include "../sheet/sheet_layout.h"
#include "../walls/plan_walls.h"
#include "doorway_drawing.h"
#include "level_notes.h"

#include <cmath>

namespace pcl::sedr {
namespace {

using namespace sheet_measures;

constexpr double smallest_font = 1.8;
constexpr double beside_line = 0.95; ///< distance from a line over the font size

SheetText
textIn(const std::string& look,
       const TextBox& box,
       double font,
       const std::string& text)
{
  return {look, box.middle, font, text, box.degrees, TextAnchor::Middle, true};
}

} // namespace

PlanTexts::PlanTexts(PlanAnnotations& annotations,
                     TextPlaces& places,
                     const PlanFrame& frame)
    : annotations_(annotations)
    , places_(places)
    , frame_(frame)
{}

void
PlanTexts::place(const Floorplan& plan,
                 const std::vector<DrawnElement>& drawn,
                 const std::vector<CeilingLines>& ceilings)
{
  std::vector<TextSpot> spots; // then circles around the rooms' texts
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    const PlanRoom& room = plan.rooms[r];
    spots.push_back(textSpotIn(room.boundary, room.columns));
    spots.back().radius = writeRoom(room, ceilings[r], spots.back());
  }
  for (const StairNote& note : stairNotes(plan))
    writeAt("stair", {note.place, 0}, {note.text}, small_font);
  for (std::size_t r = 0; r < plan.rooms.size(); ++r)
    for (const LevelNote& note : levelNotes(plan.rooms[r], ceilings[r], spots[r]))
      writeAt(note.layer == DrawnLayer::FloorDetail ? "floor_level" : "level",
              note.spot, {note.text}, small_font);
  for (const DrawnElement& line : drawn)
    if (!line.note.empty())
      writeAlong(line.element,
                 line.layer == DrawnLayer::Headroom ? "headroom" : "level", line.note);
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    const PlanRoom& room = plan.rooms[r];
    for (const PlanElement& wall : room.boundary.elements)
      writeAlong(wall, "level", eavesText(room, ceilings[r], wall));
    for (const PlanLoop& column : room.columns)
      if (!isIsland(room, column))
        writeColumn(column);
  }
  writeWays(plan);
  for (const WallFace& face : wallFaces(plan))
    writeSize(elementOf(plan, face));
}

double
PlanTexts::writeRoom(const PlanRoom& room,
                     const CeilingLines& ceiling,
                     const TextSpot& spot)
{
  std::vector<std::string> lines = roomTexts(room, ceiling, spot.place, "m²");
  auto box = writeAt("name", spot, lines, large_font);
  lines.pop_back();
  if (!box)
    box = writeAt("name", spot, lines, large_font);
  if (!box)
    box = writeAt("name", spot, {std::to_string(room.id)}, large_font);
  return box ? ((box->middle - frame_(spot.place)).norm() + box->half_size.norm()) /
                   frame_.scale
             : 0;
}

std::optional<TextBox>
PlanTexts::writeAt(const std::string& look,
                   const TextSpot& spot,
                   const std::vector<std::string>& lines,
                   double font)
{
  constexpr double smaller = 0.9; // than the font that does not fit
  constexpr int most_steps = 48;  // up and down by turns: to six lines off
  constexpr double step = 0.25;   // lines
  const Eigen::Vector2d place = frame_(spot.place);
  const double radius = spot.radius * frame_.scale;
  for (; font >= smallest_font; font *= smaller) {
    const double line_height = 1.3 * font;
    const Eigen::Vector2d half = font * halfSizeOf(lines);
    std::vector<TextBox> boxes;
    for (const double across : {0.0, 1.0, -1.0, 2.0, -2.0}) // halves of its width
      for (int k = 0; k <= most_steps; ++k) {
        const int steps = (k + 1) / 2;
        const double lines_up = (k % 2 == 0 ? -step : step) * steps;
        const Eigen::Vector2d off(across * half.x(), lines_up * line_height);
        if (off.norm() <= radius)
          boxes.push_back({place + off, half, 0});
      }
    const auto box = places_.takeFirst(boxes);
    if (!box)
      continue;
    Eigen::Vector2d at = box->middle;
    at.y() += line_height * static_cast<double>(lines.size() - 1) / 2;
    for (const std::string& line : lines) {
      add(textIn(look, {at, {}, 0}, font, line));
      at.y() -= line_height;
    }
    return box;
  }
  return std::nullopt;
}

std::optional<SheetText>
PlanTexts::placeAlong(const PlanElement& element,
                      const std::string& look,
                      const std::string& text)
{
  constexpr double clear = 1; // distance of the text from the ends, millimetres
  if (text.empty())
    return std::nullopt;
  const PlanElement drawn = frame_(element);
  const Eigen::Vector2d half = small_font * halfSizeOf({text});
  std::vector<TextBox> boxes;
  for (const double share : {1.0 / 2, 1.0 / 3, 2.0 / 3, 1.0 / 5, 4.0 / 5}) {
    const double s = share * drawn.length();
    const Eigen::Vector2d normal = drawn.normalAt(s);
    if (std::min(s, drawn.length() - s) >= half.x() + clear)
      boxes.push_back({drawn.pointAt(s) + beside_line * small_font * normal, half,
                       readableAngle({normal.y(), -normal.x()})});
  }
  const auto box = places_.takeFirst(boxes);
  return box ? std::make_optional(textIn(look, *box, small_font, text)) : std::nullopt;
}

void
PlanTexts::writeAlong(const PlanElement& element,
                      const std::string& look,
                      const std::string& text)
{
  if (const auto placed = placeAlong(element, look, text))
    add(*placed);
}

void
PlanTexts::writeSize(const PlanElement& wall)
{
  const auto text = placeAlong(wall, "size", sizeText(wall));
  if (text && wall.isArc())
    add(*text);
  else if (text) {
    const PlanElement drawn = frame_(wall);
    annotations_.walls.push_back(
        {drawn.start, drawn.end, drawn.start, drawn.end, wall.length(), text});
  }
}

void
PlanTexts::writeColumn(const PlanLoop& column)
{
  const std::string text = columnText(column);
  if (text.empty())
    return;
  constexpr double gap = 0.6;
  constexpr double font = 2.1;
  const Eigen::Vector2d half = font * halfSizeOf({text});
  Eigen::AlignedBox2d around;
  for (const Eigen::Vector2d& corner : frame_(column).polygon(0.05))
    around.extend(corner);
  const Eigen::Vector2d reach =
      around.sizes() / 2 + half + Eigen::Vector2d::Constant(gap);
  std::vector<TextBox> boxes;
  for (const Eigen::Vector2d& way :
       {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1), Eigen::Vector2d(0, -1),
        Eigen::Vector2d(-1, 0), Eigen::Vector2d(1, 1), Eigen::Vector2d(1, -1),
        Eigen::Vector2d(-1, 1), Eigen::Vector2d(-1, -1)})
    boxes.push_back({around.center() + reach.cwiseProduct(way), half, 0});
  if (const auto box = places_.takeFirst(boxes))
    add(textIn("size", *box, font, text));
}

void
PlanTexts::writeWays(const Floorplan& plan)
{
  constexpr double font = 2.1;
  for (const DrawnDoorway& doorway : drawnDoorways(plan)) {
    const std::string text =
        decimalText(doorway.width, 2) + " x " + decimalText(doorway.height, 2);
    const Eigen::Vector2d half = font * halfSizeOf({text});
    std::vector<TextBox> boxes;
    for (const auto& [from, to] :
         {std::make_pair(doorway.corners[2], doorway.corners[3]),
          std::make_pair(doorway.corners[0], doorway.corners[1])}) {
      const Eigen::Vector2d a = frame_(from);
      const Eigen::Vector2d b = frame_(to);
      const Eigen::Vector2d way = (b - a).normalized();
      const Eigen::Vector2d off(way.y(), -way.x());
      for (const double rows : {1.2, 2.6})
        boxes.push_back({(a + b) / 2 + rows * font * off, half, readableAngle(way)});
    }
    if (const auto box = places_.takeFirst(boxes))
      add(textIn("size", *box, font, text));
  }
}

} // namespace pcl::sedr
