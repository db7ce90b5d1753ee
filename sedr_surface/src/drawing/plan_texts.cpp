// SPDX-License-Identifier: BSD-3-Clause
#include "plan_drawing.h"

#include "../sheet/text_places.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/walls/plan_walls.h"

#include "sedr_filters/src/plan/plan_geometry.h"
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {
namespace {

constexpr double detail_font = 2.1; ///< of columns and openings

/** @brief Places texts one after the other. */
class TextWriter {
public:
  TextWriter(const PlanFrame& frame, TextPlaces& places)
      : frame_(frame)
      , places_(places)
  {}

  /** @brief Writes the texts of a room.
   * @return a circle around them, metres */
  TextSpot writeRoom(const PlanRoom& room, const std::vector<std::string>& lines)
  {
    TextSpot spot = textSpotIn(room.boundary, room.columns);
    auto box = writeAt(PlanLayer::Room, room.boundary, spot, lines, large_font);
    if (!box)
      box = writeAt(PlanLayer::Room, room.boundary, spot, {lines[0], lines[1]},
                    large_font);
    if (!box)
      box = writeAt(PlanLayer::Room, room.boundary, spot, {std::to_string(room.id)},
                    large_font);
    spot.radius =
        box ? ((box->middle - frame_(spot.place)).norm() + box->half_size.norm()) /
                  frame_.scale
            : 0;
    return spot;
  }

  /** @brief Writes the height of a level part, where nothing else is and off the room's
   * text: of ceilings above the room's floor, of floors as a level above @p zero. */
  void writeLevel(const PlanRoom& room,
                  const NotedPart& part,
                  const TextSpot& room_text,
                  PlanLayer layer,
                  double zero)
  {
    if (!isLevel(part.slab))
      return;
    std::vector<PlanLoop> others = part.others;
    others.push_back(circleAbout(room_text));
    TextSpot spot = textSpotIn(part.outline, others);
    if (spot.radius <= 0 || !room.contains(spot.place))
      return;
    spot.radius = std::min(spot.radius, room.boundary.distance(spot.place));
    const double z = part.slab.heightAt(spot.place);
    const std::string text = layer == PlanLayer::Floor
                                 ? "▼ " + levelText(z - zero)
                                 : decimalText(z - room.floor.heightAt(spot.place), 2);
    writeAt(layer, room.boundary, spot, {text}, small_font);
  }

  /** @brief Writes lines about a place in a loop in the largest font that fits there.
   */
  std::optional<TextBox> writeAt(PlanLayer layer,
                                 const PlanLoop& within,
                                 const TextSpot& spot,
                                 const std::vector<std::string>& lines,
                                 double font)
  {
    constexpr double smaller = 0.9; // than the font that does not fit
    constexpr int most_steps = 48;  // up and down by turns: to six lines off
    constexpr double step = 0.25;   // lines
    const Eigen::Vector2d place = frame_(spot.place);
    for (; font >= smallest_font; font *= smaller) {
      const double line_height = 1.3 * font;
      const Eigen::Vector2d half = font * halfSizeOf(lines);
      std::vector<TextBox> boxes;
      for (const double across : {0.0, 1.0, -1.0, 2.0, -2.0}) // halves of its width
        for (int k = 0; k <= most_steps; ++k) {
          const double up = (k % 2 == 0 ? -step : step) * ((k + 1) / 2);
          const Eigen::Vector2d off(across * half.x(), up * line_height);
          if (off.norm() <= spot.radius * frame_.scale &&
              within.contains(frame_.toPlan(place + off)))
            boxes.push_back({place + off, half, 0});
        }
      const auto box = places_.takeFirst(boxes);
      if (!box)
        continue;
      Eigen::Vector2d at = box->middle;
      at.y() += line_height * static_cast<double>(lines.size() - 1) / 2;
      for (const std::string& line : lines) {
        add(layer, {at, {}, 0}, font, line);
        at.y() -= line_height;
      }
      return box;
    }
    return std::nullopt;
  }

  /** @brief Writes a text beside a line, of slopes also on its other side, or else on
   * one of contours, if there is space.
   * @return its box */
  std::optional<TextBox> writeAlong(PlanLayer layer,
                                    const PlanElement& element,
                                    const std::string& text,
                                    double font = small_font)
  {
    constexpr double clear = 1;          // distance of the text from the ends
    constexpr double beside_line = 0.95; // distance from the line over the font size
    if (text.empty())
      return std::nullopt;
    const PlanElement drawn = frame_(element);
    const Eigen::Vector2d half = font * halfSizeOf({text});
    std::vector<TextBox> boxes;
    const auto addBoxes = [&](double side, double ends) {
      for (const double share : {1.0 / 2, 1.0 / 3, 2.0 / 3, 1.0 / 5, 4.0 / 5}) {
        const double s = share * drawn.length();
        const Eigen::Vector2d normal = drawn.normalAt(s);
        if (std::min(s, drawn.length() - s) >= ends)
          boxes.push_back({drawn.pointAt(s) + side * font * normal, half,
                           readableAngle({normal.y(), -normal.x()})});
      }
    };
    addBoxes(beside_line, half.x() + clear);
    if (layer == PlanLayer::Slope)
      addBoxes(-beside_line, half.x() + clear);
    if (layer == PlanLayer::Contour)
      addBoxes(0, 0);
    return addFirst(layer, boxes, font, text);
  }

  void writeColumn(const PlanLoop& column)
  {
    const std::string text = columnText(column);
    if (text.empty())
      return;
    constexpr double gap = 0.6;
    const Eigen::Vector2d half = detail_font * halfSizeOf({text});
    const Eigen::AlignedBox2d around = boundsOf(frame_(column));
    const Eigen::Vector2d reach =
        around.sizes() / 2 + half + Eigen::Vector2d::Constant(gap);
    std::vector<TextBox> boxes;
    for (const auto& [x, y] : {std::pair(1, 0),
                               {0, 1},
                               {0, -1},
                               {-1, 0},
                               {1, 1},
                               {1, -1},
                               {-1, 1},
                               {-1, -1}})
      boxes.push_back(
          {around.center() + reach.cwiseProduct(Eigen::Vector2d(x, y)), half, 0});
    addFirst(PlanLayer::Dimension, boxes, detail_font, text);
  }

  void writeOpening(const OpeningGap& opening)
  {
    const std::string text = textOf(opening);
    const Eigen::Vector2d half = detail_font * halfSizeOf({text});
    const Eigen::Vector2d middle =
        (frame_(opening.corners[0]) + frame_(opening.corners[2])) / 2;
    std::vector<TextBox> boxes;
    for (const std::size_t k : {2U, 0U}) {
      const Eigen::Vector2d a = frame_(opening.corners[k]);
      const Eigen::Vector2d b = frame_(opening.corners[k + 1]);
      const Eigen::Vector2d way = (b - a).normalized();
      Eigen::Vector2d off(way.y(), -way.x());
      if (off.dot((a + b) / 2 - middle) < 0)
        off = -off;
      for (const double rows : {1.2, 2.6})
        boxes.push_back(
            {(a + b) / 2 + rows * detail_font * off, half, readableAngle(way)});
    }
    if (addFirst(PlanLayer::Dimension, boxes, detail_font, text))
      return;
    const Eigen::Vector2d half_mark = detail_font * halfSizeOf({opening.mark});
    for (TextBox& box : boxes)
      box.half_size = half_mark;
    if (addFirst(PlanLayer::Dimension, boxes, detail_font, opening.mark))
      return;
    boxes.clear();
    for (double off = 4; off <= 20; off += 2) // millimetres
      for (int turn = 0; turn < 8; ++turn)
        boxes.push_back(
            {middle + Eigen::Rotation2Dd(turn * M_PI_4) * Eigen::Vector2d(off, 0),
             half_mark, 0});
    if (const auto box =
            addFirst(PlanLayer::Dimension, boxes, detail_font, opening.mark)) {
      const Eigen::Vector2d low = box->middle - half_mark;
      const Eigen::Vector2d end =
          middle.cwiseMax(low).cwiseMin(box->middle + half_mark);
      places_.keepOff(middle, end);
      found.leaders.push_back(segment(frame_.toPlan(middle), frame_.toPlan(end)));
    }
    else
      found.unplaced += (found.unplaced.empty() ? "" : ", ") + opening.mark;
  }

  /** @brief Writes the length of a segment, as a dimension, or the radius of an arc. */
  void writeSize(const PlanElement& wall)
  {
    if (wall.length() < min_step)
      return;
    if (wall.isArc()) {
      writeAlong(PlanLayer::Dimension, wall, "R " + decimalText(wall.radius, 2));
      return;
    }
    if (!writeAlong(PlanLayer::Dimension, wall, decimalText(wall.length(), 2)))
      return;
    const PlanElement drawn = frame_(wall);
    found.walls.push_back({drawn.start, drawn.end, drawn.start, drawn.end,
                           wall.length(), found.texts.back().text});
    found.texts.pop_back();
  }

  PlanTexts found;

private:
  /** @brief Writes a text in the first box that has space. */
  std::optional<TextBox> addFirst(PlanLayer layer,
                                  const std::vector<TextBox>& boxes,
                                  double font,
                                  const std::string& text)
  {
    const auto box = places_.takeFirst(boxes);
    if (box)
      add(layer, *box, font, text);
    return box;
  }

  void add(PlanLayer layer, const TextBox& box, double font, const std::string& text)
  {
    found.texts.push_back(
        {layer, SheetText{styleOf(layer).text, box.middle, font, text, box.degrees,
                          TextAnchor::Middle, looks::room_colour}});
  }

  const PlanFrame& frame_;
  TextPlaces& places_;
};

/** @brief Where one stands in a room before a stair, at its foot or at its head. */
Eigen::Vector2d
entryOf(const PlanStair& stair, bool is_foot, const PlanRoom& room)
{
  constexpr double before = 0.5; // metres
  if (stair.flights.empty())
    return stair.at;
  const PlanFlight& flight = is_foot ? stair.flights.front() : stair.flights.back();
  const std::size_t last = flight.steps() - 1;
  const Eigen::Vector2d at = flight.middle(is_foot ? 0 : last);
  const std::size_t one = std::min<std::size_t>(1, last);
  const Eigen::Vector2d next = flight.middle(is_foot ? one : last - one);
  const Eigen::Vector2d entry = at + before * (at - next).normalized();
  return room.contains(entry) ? entry : at;
}

/** @brief Writes where the stairs of a plan, or of a part of it, lead. */
void
writeStairs(const Floorplan& plan, TextWriter& writer)
{
  constexpr double reach = 1; // metres from there
  for (const PlanStair& stair : plan.stairs) {
    const PlanRoom* room = findRoom(plan, stair.rooms[0]);
    const bool is_up = room != nullptr;
    if (!is_up)
      room = findRoom(plan, stair.rooms[1]);
    if (!room)
      continue;
    const TextSpot spot{entryOf(stair, is_up, *room), reach};
    const std::string way = is_up ? "up" : "down";
    const std::uint32_t other = stair.rooms[is_up ? 1 : 0];
    if (other == 0 ||
        !writer.writeAt(PlanLayer::Note, room->boundary, spot,
                        {way + " to room " + std::to_string(other)}, small_font))
      writer.writeAt(PlanLayer::Note, room->boundary, spot, {way}, small_font);
  }
}

} // namespace

PlanTexts
placedTexts(const Floorplan& plan,
            const std::vector<DrawnSurfaces>& surfaces,
            const std::vector<PlanLine>& lines,
            const std::vector<OpeningGap>& openings,
            const PlanFrame& frame,
            const PlanTextSettings& settings,
            TextPlaces& places)
{
  const bool is_floor = settings.view == DrawingView::Floor;
  TextWriter writer(frame, places);
  std::vector<TextSpot> room_texts;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r)
    room_texts.push_back(writer.writeRoom(
        plan.rooms[r], roomTexts(surfaces[r].faces, settings.view, settings.zero)));
  if (is_floor)
    writeStairs(plan, writer);
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    const PlanRoom& room = plan.rooms[r];
    for (const NotedPart& part : surfaces[r].ceiling.noted(room, SurfaceSide::Ceiling))
      if (&part.slab != &room.ceiling || (!is_floor && surfaces[r].faces.area(0) > 0))
        writer.writeLevel(room, part, room_texts[r], PlanLayer::Height, settings.zero);
    for (const NotedPart& part : surfaces[r].floor.noted(room, SurfaceSide::Floor))
      if (&part.slab != &room.floor && is_floor)
        writer.writeLevel(room, part, room_texts[r], PlanLayer::Floor, settings.zero);
  }
  for (const PlanLine& line : lines)
    writer.writeAlong(
        line.layer == PlanLayer::Headroom || line.layer == PlanLayer::Floor ||
                line.layer == PlanLayer::Slope || line.layer == PlanLayer::Contour
            ? line.layer
            : PlanLayer::Height,
        line.element, line.note);
  for (const PlanRoom& room : plan.rooms)
    for (const PlanElement& wall : room.boundary.elements)
      writer.writeAlong(PlanLayer::Height, wall, eavesText(room, wall));
  if (!is_floor)
    return std::move(writer.found);
  for (const PlanRoom& room : plan.rooms)
    for (const PlanLoop& column : room.columns)
      if (!isIsland(room, column))
        writer.writeColumn(column);
  for (const OpeningGap& opening : openings)
    writer.writeOpening(opening);
  for (const PlanRoom& room : plan.rooms)
    for (std::size_t e = 0; settings.is_numbered && e < room.boundary.elements.size();
         ++e)
      if (settings.is_numbered(room.id, e))
        for (const char* const what :
             {"wall ", "#"}) // so that it is not read as a length
          if (writer.writeAlong(PlanLayer::Number, room.boundary.elements[e],
                                what + std::to_string(room.id) + "." +
                                    std::to_string(e + 1),
                                smallest_font))
            break;
  for (const WallFace& face : wallFaces(plan))
    if (!isGuess(plan, face))
      writer.writeSize(elementOf(plan, face));
  return std::move(writer.found);
}

PlanTexts
placedLabels(const std::vector<DrawingLabel>& labels,
             const std::vector<PlanLine>& lines,
             const PlanFrame& frame,
             TextPlaces& places)
{
  TextWriter writer(frame, places);
  for (const DrawingLabel& label : labels) {
    const TextSpot spot = textSpotIn(label.within, label.off);
    std::vector<std::string> texts = label.lines;
    while (!texts.empty() &&
           !writer.writeAt(label.layer, label.within, spot, texts, large_font))
      texts.pop_back();
  }
  for (const PlanLine& line : lines)
    writer.writeAlong(PlanLayer::Height, line.element, line.note);
  return std::move(writer.found);
}

} // namespace pcl::sedr
