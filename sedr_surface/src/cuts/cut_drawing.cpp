// SPDX-License-Identifier: BSD-3-Clause
#include "cut_drawing.h"

#include "../drawing/plan_drawing.h"
#include "sedr_filters/src/plan/plan_geometry.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace pcl::sedr {
namespace {

// Millimetres from the drawing to its dimensions.
constexpr double first = 9;
constexpr double second = 17;

/** @brief Returns the chain of places along a side, without those that are nearly the
 * same. */
DimensionChain
chainOf(const Eigen::Vector2d& side, const std::set<double>& at, double off)
{
  DimensionChain chain{side, {}};
  for (const double place : at)
    chain.places.push_back(side.y() != 0 ? Eigen::Vector2d(place, off)
                                         : Eigen::Vector2d(off, place));
  dropSmallSteps(chain, min_step);
  return chain;
}

/** @brief Returns the dimensions of outlines: of their faces, and overall. */
std::vector<DimensionRow>
dimensionsOf(const std::vector<PlanLoop>& outlines)
{
  constexpr double min_face = 0.5; // metres; less has no dimension
  std::set<double> along;
  std::set<double> heights;
  Eigen::AlignedBox2d rooms;
  for (const PlanLoop& outline : outlines) {
    rooms.extend(sedr::boundsOf(outline));
    for (const PlanElement& e : outline.elements) {
      if (e.length() < min_face)
        continue;
      if (isUpright(e))
        along.insert({e.start.x(), e.end.x()});
      else if (std::abs(e.end.y() - e.start.y()) < 0.01)
        heights.insert(e.start.y());
    }
  }
  std::vector<DimensionRow> rows;
  const auto addRows = [&](const Eigen::Vector2d& side, const std::set<double>& at,
                           const std::set<double>& overall, double off) {
    if (const DimensionChain chain = chainOf(side, at, off); chain.places.size() > 2)
      rows.push_back({chain, first});
    if (!rooms.isEmpty())
      rows.push_back({chainOf(side, overall, off), second});
  };
  addRows({0, -1}, along, {rooms.min().x(), rooms.max().x()}, rooms.min().y());
  addRows({-1, 0}, heights, {rooms.min().y(), rooms.max().y()}, rooms.min().x());
  return rows;
}

} // namespace

bool
isUpright(const PlanElement& e)
{
  constexpr double cosine = 0.1; // 84 degrees
  return std::abs(e.end.x() - e.start.x()) < cosine * e.length();
}

PlanLoop
rectangleOf(double left, double right, double bottom, double top)
{
  return loopAround({Eigen::Vector2d(left, bottom), Eigen::Vector2d(right, top)});
}

Eigen::AlignedBox2d
dimensionSpace()
{
  return spaceOf({{{{0, -1}, {}}, second}, {{{-1, 0}, {}}, second}});
}

void
complete(const std::vector<std::vector<PlanLoop>>& rows,
         const DrawingSettings& settings,
         CutDrawing& drawing)
{
  for (const PlanLoop& outline : drawing.outlines)
    drawing.grounds.push_back({looks::room, {outline}});
  Eigen::AlignedBox2d bodies;
  for (const Drawing::Body& body : drawing.bodies)
    bodies.extend(sedr::boundsOf(body.area.boundary));
  Eigen::AlignedBox2d all = bodies;
  for (const PlanLine& line : drawing.lines)
    all.extend(sedr::boundsOf({{line.element}}));
  drawing.layout = layoutOf(all, dimensionSpace(), settings);
  const PlanFrame& frame = drawing.layout.frame;
  TextPlaces places(drawing.layout.size);
  for (const std::vector<PlanLoop>& outlines : rows) {
    Eigen::AlignedBox2d box = bodies;
    for (const PlanLoop& outline : outlines)
      box.extend(sedr::boundsOf(outline));
    for (const SheetDimension& d :
         placedRows(dimensionsOf(outlines), {frame(box.min()), frame(box.max())}, frame,
                    places))
      drawing.dimensions.push_back(d);
  }
  for (const PlanLine& line : drawing.lines)
    line.layer == PlanLayer::Unseen ? places.avoid(frame(line.element))
                                    : places.keepOff(frame(line.element));
  drawing.texts = placedLabels(drawing.labels, drawing.lines, frame, places);
}

std::vector<std::string>
written(const CutDrawing& drawing,
        const std::vector<DrawingFormat>& formats,
        const DrawingSettings& settings)
{
  std::vector<std::string> files;
  for (const DrawingFormat format : formats)
    files.push_back(format == DrawingFormat::Dxf
                        ? dxfOf(drawing, settings)
                        : sheetText(sheetOf(drawing, settings), format));
  return files;
}

} // namespace pcl::sedr
