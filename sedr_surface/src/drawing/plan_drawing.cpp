// SPDX-License-Identifier: BSD-3-Clause
#include "plan_drawing.h"

#include "../mesh/mesh_outlines.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_geometry.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <set>
#include <utility>

namespace pcl::sedr {
namespace {

using namespace sheet_measures;

/** @brief Draws on a sheet, from the ground up. */
class DrawingPainter {
public:
  DrawingPainter(Sheet& sheet, const Drawing& drawing)
      : sheet_(sheet)
      , drawing_(drawing)
      , frame_(drawing.layout.frame)
  {}

  /** @brief Fills walls and slabs, lightly where their thickness was assumed. */
  void addBodies()
  {
    for (const Drawing::Body& body : drawing_.bodies) {
      std::vector<PlanLoop> loops = body.area.holes;
      loops.push_back(body.area.boundary);
      addArea(body.is_assumed ? looks::assumed_body : looks::wall_body, loops);
    }
  }

  /** @brief Draws what is of a room, or with 0 of none; faces of walls over all that
   * ends at them. */
  void addRoom(std::uint32_t room)
  {
    for (const Drawing::Ground& ground : drawing_.grounds)
      if (ground.room == room)
        addArea(ground.look, ground.loops);
    for (const bool are_walls : {false, true})
      addLines(room, are_walls);
  }

  /** @brief Draws a gap in the walls, over both faces. */
  void addOpening(const OpeningGap& opening)
  {
    std::vector<Eigen::Vector2d> c;
    for (const Eigen::Vector2d& corner : opening.corners)
      c.push_back(frame_(corner));
    sheet_.addLine(looks::room, {c[0], c[1], c[2], c[3], c[0]}, true);
    const SheetLook gap{no_colour, looks::room_colour,
                        1.6 * styleOf(PlanLayer::Wall).line.width};
    sheet_.addLine(gap, {c[0], c[1]});
    sheet_.addLine(gap, {c[2], c[3]});
    for (const GapLine& line : linesOf(opening))
      addLine(line.look, line.element);
  }

  void addLine(const SheetLook& look, const PlanElement& element)
  {
    sheet_.add(SheetPath{look, {{{frame_(element)}}}});
  }

private:
  void addArea(const SheetLook& look, const std::vector<PlanLoop>& loops)
  {
    SheetPath path{look, {}, true};
    for (const PlanLoop& loop : loops)
      path.chains.push_back(frame_(loop));
    sheet_.add(path);
  }

  /** @brief Draws the lines of a room, connected where one starts at the end of the
   * last one. */
  void addLines(std::uint32_t room, bool are_walls)
  {
    std::vector<SheetPath> paths;
    const PlanLine* last = nullptr;
    for (const PlanLine& line : drawing_.lines) {
      if (line.room != room || isWall(line.layer) != are_walls)
        continue;
      if (!last || last->layer != line.layer || last->element.end != line.element.start)
        paths.push_back({styleOf(line.layer, drawing_.view).line, {{}}});
      paths.back().chains.front().elements.push_back(frame_(line.element));
      last = &line;
    }
    for (SheetPath& path : paths) {
      const std::vector<PlanElement>& elements = path.chains.front().elements;
      path.is_closed = elements.front().start == elements.back().end;
      sheet_.add(path);
    }
  }

  Sheet& sheet_;
  const Drawing& drawing_;
  const PlanFrame& frame_;
};

/** @brief Returns what the title block tells of a plan. */
TitleTexts
titleTextsOf(const PlanDrawing& drawing)
{
  const std::vector<PlanStorey> storeys = storeysOf(drawing.plan);
  const std::size_t rooms = drawing.plan.rooms.size();
  const bool is_floor = drawing.view == DrawingView::Floor;
  const auto explains = [&drawing](PlanLayer layer, const char* words) {
    return std::any_of(drawing.lines.begin(), drawing.lines.end(),
                       [layer](const PlanLine& line) { return line.layer == layer; })
               ? words
               : "";
  };
  const bool are_assumed =
      std::any_of(drawing.walls.begin(), drawing.walls.end(),
                  [](const PlanWall& wall) { return wall.isAssumed(); });
  return {
      is_floor ? "Floor plan" : "Reflected ceiling plan",
      "Storey",
      storeys.size() == 1 ? storeys[0].name : "all",
      is_floor ? "Rooms, floor area" : "Rooms, area of ceilings",
      std::to_string(rooms) + (rooms == 1 ? " room, " : " rooms, ") +
          decimalText(drawing.area, 2) + " m²",
      (is_floor
           ? "Metres, face to face, at the floor; openings of any height. Dashed: "
             "overhead. h: ceiling height. ▼: floor level."
           : "Metres. Blue: heights above the floor of the room. Not drawn: lamps; "
             "glass of skylights, which are recesses here.") +
          std::string(explains(PlanLayer::Headroom, " Dotted: headroom.")) +
          explains(PlanLayer::Slope, " Arrows lead up.") +
          explains(PlanLayer::Contour, " Thin: contour lines.") +
          explains(PlanLayer::Guess, " Grey, dashed: walls inferred, not measured.") +
          explains(PlanLayer::Outside,
                   " Grey, dashed outside: outer faces, not seen; walls are at least "
                   "as thick as their reveals.") +
          (are_assumed ? " Light: thickness of the wall assumed." : "") +
          (drawing.texts.unplaced.empty()
               ? ""
               : " No space for the number of " + drawing.texts.unplaced + ".")};
}

} // namespace

void
Drawing::addBodies(const std::vector<PlanArea>& areas,
                   std::vector<PlanArea> open,
                   bool is_assumed)
{
  for (const OpeningGap& gap : openings)
    open.push_back({loopOf({gap.corners.begin(), gap.corners.end()})});
  for (const PlanArea& part : partsOutside(areas, open))
    bodies.push_back({part, is_assumed});
}

PlanDrawing::PlanDrawing(const Floorplan& whole,
                         const DrawingSettings& settings,
                         double finest)
{
  view = settings.view;
  layout = layoutOf(whole, settings);
  Floorplan numbered = whole;
  numberOpenings(numbered);
  plan = settings.storey ? partOf(numbered, *settings.storey) : std::move(numbered);
  if (plan.rooms.empty()) {
    title = titleTextsOf(*this);
    return;
  }
  walls = findWalls(plan, {settings.max_wall});
  openings = openingGaps(plan, walls, view);
  std::vector<PlanArea> rooms;
  for (const PlanRoom& room : plan.rooms)
    rooms.push_back({room.boundary, room.columns});
  for (const bool is_assumed : {false, true}) {
    std::vector<PlanArea> bands;
    for (const PlanWall& wall : walls)
      if (wall.isAssumed() == is_assumed)
        bands.push_back(bandOf(plan, wall));
    addBodies(bands, rooms, is_assumed);
  }
  for (const PlanRoom& room : plan.rooms) {
    grounds.push_back({looks::room, wallLoops(room), room.id});
    for (const PlanNiche& niche : room.niches)
      grounds.push_back({looks::room, {niche.boundary}, room.id});
    for (const PlanLoop& column : room.columns)
      if (!isIsland(room, column))
        grounds.push_back({looks::column, {column}, room.id});
    const RoomFaces& ceiling = surfaces_.emplace_back(room).faces;
    area += view == DrawingView::Floor ? ceiling.room.area() : ceiling.area();
    if (view == DrawingView::Floor)
      outlines.push_back(ceiling.room.boundary);
    else
      for (const std::vector<std::size_t>& face : ceiling.faces)
        for (const PlanLoop& loop : outlinesOf(ceiling.solid, face))
          outlines.push_back(loop);
  }
  const PlanFrame& frame = layout.frame;
  const Eigen::AlignedBox2d box = boundsOf(plan, walls, frame);
  around_ = TextPlaces(layout.size);
  for (const SectionLine& section : settings.sections)
    if (view == DrawingView::Floor)
      addMark(section, box);
  dimensions =
      placedRows(rowsAround(plan, frame.turn, settings.max_wall), box, frame, around_);
  text_settings_ = {view, usualFloor(whole, storeysOf(whole).front()),
                    settings.is_numbered};
  draw(finest);
}

/** @brief Adds the marks at both ends of a section, beside the plan: a stroke along its
 * line, an arrow the way one looks, and the letter. */
void
PlanDrawing::addMark(const SectionLine& section, const Eigen::AlignedBox2d& box)
{
  constexpr double stroke = 5; // millimetres, as are the next ones
  constexpr double arrow = 4;
  constexpr double head = 1.5;
  constexpr double to_letter = 2.5;
  const PlanFrame& frame = layout.frame;
  const SectionLine drawn{frame(section.from), frame(section.to)};
  const auto ranges = rangesIn(loopAround(box), drawn);
  if (ranges.empty())
    return;
  const Eigen::Vector2d way = (drawn.to - drawn.from).normalized();
  const Eigen::Vector2d look = leftOf(way);
  const auto add = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    around_.keepOff(from, to);
    mark_lines_.push_back(
        {segment(frame.toPlan(from), frame.toPlan(to)), PlanLayer::Section});
  };
  for (const auto& [along, out] :
       {std::pair<double, Eigen::Vector2d>(ranges.front().first, -way),
        {ranges.back().second, way}}) {
    const Eigen::Vector2d edge = drawn.from + along * way;
    const Eigen::Vector2d end = edge + (stroke + 1) * out;
    const Eigen::Vector2d tip = end + arrow * look;
    std::vector<TextBox> boxes;
    for (const auto& [along_look, outwards] : {std::pair(arrow + to_letter, 0.0),
                                               {0.0, to_letter},
                                               {-to_letter, 0.0},
                                               {arrow + 2 * to_letter, 0.0}})
      boxes.push_back({end + along_look * look + outwards * out,
                       large_font * halfSizeOf({section.letter}), 0});
    if (const auto box = around_.takeFirst(boxes))
      mark_letters_.push_back(
          {PlanLayer::Section, {ink, box->middle, large_font, section.letter}});
    add(end - stroke * out, end);
    add(end, tip);
    for (const double side : {-1.0, 1.0})
      add(tip, tip - head * (look + side / 2 * way));
  }
}

void
PlanDrawing::draw(double finest)
{
  if (plan.rooms.empty() || finest == finest_)
    return;
  finest_ = finest;
  const PlanFrame& frame = layout.frame;
  for (DrawnSurfaces& room : surfaces_)
    room.findLines(finest > 0 ? finest : 1 / frame.scale);
  lines = planLines(plan, walls, surfaces_, view);
  TextPlaces places = around_;
  for (const PlanLine& line : lines) {
    const bool is_solid = isWall(line.layer) || line.layer == PlanLayer::Column;
    is_solid ? places.keepOff(frame(line.element)) : places.avoid(frame(line.element));
  }
  texts = placedTexts(plan, surfaces_, lines, openings, frame, text_settings_, places);
  lines.insert(lines.end(), mark_lines_.begin(), mark_lines_.end());
  texts.texts.insert(texts.texts.end(), mark_letters_.begin(), mark_letters_.end());
  title = titleTextsOf(*this);
}

Sheet
sheetOf(const Drawing& drawing, const DrawingSettings& settings)
{
  const TitleTexts& texts = drawing.title;
  Sheet sheet;
  sheet.size = drawing.layout.size;
  sheet.title =
      (settings.texts.title.empty() ? texts.usual_title : settings.texts.title) +
      " 1:" + shortDecimalText(drawing.layout.scale, 2) +
      (texts.part == "all" ? "" : ", " + texts.part);
  if (!settings.origin.isZero())
    sheet.description = settings.origin.comment();
  if (drawing.grounds.empty())
    return sheet;
  DrawingPainter painter(sheet, drawing);
  sheet.add(SheetGroup{"walls"});
  painter.addBodies();
  std::set<std::uint32_t> rooms{0};
  for (const PlanLine& line : drawing.lines)
    rooms.insert(line.room);
  for (const std::uint32_t room : rooms) {
    if (room != 0)
      sheet.add(SheetGroup{"room_" + std::to_string(room)});
    painter.addRoom(room);
  }
  sheet.add(SheetGroup{"openings"});
  for (const OpeningGap& opening : drawing.openings)
    painter.addOpening(opening);
  sheet.add(SheetGroup{"texts"});
  for (const PlanText& text : drawing.texts.texts)
    sheet.add(text.text);
  for (const SheetDimension& wall : drawing.texts.walls)
    sheet.add(*wall.text);
  for (const PlanElement& leader : drawing.texts.leaders)
    painter.addLine(styleOf(PlanLayer::Dimension).line, leader);
  sheet.add(SheetGroup{"dimensions"});
  addDimensions(sheet, drawing.dimensions);
  sheet.add(SheetGroup{"title"});
  addTitleBlock(sheet, drawing.layout, settings, texts);
  return sheet;
}

Eigen::Affine2d
drawingPlaces(const Floorplan& plan, const DrawingSettings& settings)
{
  const SheetLayout layout = layoutOf(plan, settings);
  const Eigen::Array2d size = layout.size;
  return Eigen::Translation2d(0, 1) *
         Eigen::Scaling((Eigen::Array2d(1, -1) / size).matrix()) *
         Eigen::Translation2d(layout.frame.shift) *
         Eigen::Rotation2Dd(layout.frame.turn) * Eigen::Scaling(layout.frame.scale);
}

} // namespace pcl::sedr
