// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../walls/wall_band.h"
#include "plan_drawing.h"
#include "plan_layers.h"

#include <vector>

namespace pcl::sedr {

/** @brief Draws a plan on a sheet, from the ground up. */
class PlanPainter {
public:
  PlanPainter(Sheet& sheet, const Drawing& drawing)
      : sheet_(sheet)
      , drawing_(drawing)
      , frame_(drawing.layout.frame)
  {}

  void addRoom(const PlanRoom& room)
  {
    addArea(looks::room, wallLoops(room));
    for (const PlanNiche& niche : room.niches)
      addArea(styleOf(PlanLayer::Niche).line, {niche.boundary});
    for (const PlanLine& line : drawing_.lines)
      if (line.room == room.id && isOpen(line.layer))
        sheet_.add(SheetPath{styleOf(line.layer).line, {{{frame_(line.element)}}}});
    for (const PlanLoop& column : room.columns)
      if (!isIsland(room, column))
        addArea(styleOf(PlanLayer::Column).line, {column});
    addWalls(room);
  }

  /** @brief Fills a wall, lightly if its thickness was assumed. */
  void addBody(const Floorplan& plan, const PlanWall& wall)
  {
    const PlanArea band = bandOf(plan, wall);
    std::vector<PlanLoop> loops = band.holes;
    loops.push_back(band.boundary);
    addArea(wall.isAssumed() ? looks::assumed_body : looks::wall_body, loops);
  }

  /** @brief Draws the far sides of walls, over all bodies. */
  void addFarSides()
  {
    for (const PlanLine& line : drawing_.lines)
      if (line.room == 0)
        sheet_.add(SheetPath{styleOf(line.layer).line, {{{frame_(line.element)}}}});
  }

  /** @brief Draws the outline of a room, guesses in their own look over it. */
  void addWalls(const PlanRoom& room)
  {
    const SheetLook& wall = styleOf(PlanLayer::Wall).line;
    const SheetLook gap{no_colour, looks::room_colour, 1.2 * wall.width};
    addArea(wall, wallLoops(room));
    for (const SheetLook& look : {gap, styleOf(PlanLayer::Guess).line})
      for (const PlanLine& line : drawing_.lines)
        if (line.room == room.id && line.layer == PlanLayer::Guess)
          sheet_.add(SheetPath{look, {{{frame_(line.element)}}}});
  }

  /** @brief Draws a gap in the walls, over both faces. */
  void addOpening(const OpeningGap& opening)
  {
    std::vector<Eigen::Vector2d> c;
    for (const Eigen::Vector2d& corner : opening.corners)
      c.push_back(frame_(corner));
    SheetLook gap = styleOf(PlanLayer::Door).line;
    sheet_.addLine(gap, {c[0], c[1], c[2], c[3], c[0]}, true);
    gap = {no_colour, gap.fill, 1.6 * styleOf(PlanLayer::Wall).line.width};
    sheet_.addLine(gap, {c[0], c[1]});
    sheet_.addLine(gap, {c[2], c[3]});
    sheet_.addLine(looks::jamb, {c[0], c[3]});
    sheet_.addLine(looks::jamb, {c[1], c[2]});
    if (opening.kind == OpeningKind::Window) { // both faces go on below it
      sheet_.addLine(looks::thin, {c[0], c[1]});
      sheet_.addLine(looks::thin, {c[2], c[3]});
    }
    for (const PlanElement& line : fillingOf(opening))
      sheet_.addLine(opening.kind == OpeningKind::Door ? looks::leaf : looks::thin,
                     {frame_(line.start), frame_(line.end)});
    for (const PlanElement& line : opening.leaf)
      sheet_.add(SheetPath{looks::thin, {{{frame_(line)}}}});
  }

  void addArea(const SheetLook& look, const std::vector<PlanLoop>& loops)
  {
    SheetPath path{look, {}, true};
    for (const PlanLoop& loop : loops)
      path.chains.push_back(frame_(loop));
    sheet_.add(path);
  }

  void addLine(const SheetLook& look, const PlanElement& element)
  {
    sheet_.add(SheetPath{look, {{{frame_(element)}}}});
  }

private:
  /** @brief Returns whether the lines of a layer are no outlines of areas. */
  static bool isOpen(PlanLayer layer)
  {
    return layer == PlanLayer::Ceiling || layer == PlanLayer::Ridge ||
           layer == PlanLayer::Headroom || layer == PlanLayer::Floor ||
           layer == PlanLayer::Stair;
  }

  Sheet& sheet_;
  const Drawing& drawing_;
  const PlanFrame& frame_;
};

} // namespace pcl::sedr
