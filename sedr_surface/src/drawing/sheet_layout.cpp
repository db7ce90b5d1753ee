// SPDX-License-Identifier: BSD-3-Clause
#include "sheet_layout.h"

#include "../walls/wall_band.h"
#include "dimension_rows.h"
#include "plan_layers.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_segmentation/src/proposals/main_angles.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::sedr {
namespace {

using namespace sheet_measures;

struct Paper {
  const char* name;
  double across; ///< longer side, millimetres
  double up;
};

/** In the order of PaperSize. */
constexpr std::array<Paper, 5> papers{{{"A4", 297, 210},
                                       {"A3", 420, 297},
                                       {"A2", 594, 420},
                                       {"A1", 841, 594},
                                       {"A0", 1189, 841}}};

/** @brief Returns the k-th usual scale: those of a scale ruler, then 1000, 2000, 5000,
 * ... */
double
usualScale(std::size_t k)
{
  constexpr std::array<double, 12> ruler{10,  20,  25,  50,  75,  100,
                                         125, 200, 250, 300, 400, 500};
  constexpr std::array<double, 3> steps{1000, 2000, 5000};
  if (k < ruler.size())
    return ruler[k];
  k -= ruler.size();
  return steps[k % 3] * std::pow(10.0, static_cast<double>(k / 3));
}

/** @brief Returns the direction of most walls by length, within 45 degrees of x;
 * radians. 0 if it is within half a degree of x, or if there is no common direction, as
 * in a round room. */
double
mainDirection(const Floorplan& plan)
{
  const double along = radians(3);
  const double min_turn = radians(0.5);
  std::vector<double> angles; // of straight walls
  std::vector<double> lengths;
  double whole = 0;
  for (const PlanRoom& room : plan.rooms)
    for (const PlanElement& e : room.boundary.elements) {
      whole += e.length();
      if (e.isArc())
        continue;
      angles.push_back(std::atan2(e.end.y() - e.start.y(), e.end.x() - e.start.x()));
      lengths.push_back(e.length());
    }
  for (const double angle : mainAngles(angles, lengths, 1, 0)) {
    double agreeing = 0;
    for (std::size_t k = 0; k < angles.size(); ++k)
      if (std::abs(std::remainder(angles[k] - angle, M_PI / 2)) <= along)
        agreeing += lengths[k];
    const double turn = std::remainder(angle, M_PI / 2);
    if (agreeing > 0.3 * whole && std::abs(turn) > min_turn)
      return turn;
  }
  return 0;
}

/** @brief Finds the scale and the paper of a plan.
 * @param bounds of what is drawn, turned, metres
 * @param space around it, of dimensions: see spaceOf() */
SheetLayout
layoutOf(double turn,
         Eigen::AlignedBox2d bounds,
         const Eigen::AlignedBox2d& space,
         const DrawingSettings& settings)
{
  constexpr std::size_t scales = 50;
  if (bounds.isEmpty() || !bounds.sizes().allFinite())
    bounds = {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  SheetLayout layout;
  layout.frame.turn = turn;
  const auto setScale = [&](double scale) {
    layout.scale = scale;
    layout.frame.scale = 1000 / scale;
  };
  const auto needed = [&]() -> Eigen::Vector2d {
    return bounds.sizes() * 1000 / layout.scale + space.min() + space.max() +
           Eigen::Vector2d(margin_left + margin, 2 * margin + title_height);
  };
  // Centres the plan with its dimensions in what the title leaves.
  const auto place = [&](const Eigen::Vector2d& size) {
    layout.size = size;
    layout.frame.shift = drawingSpaceOf(layout).center() +
                         (space.min() - space.max()) / 2 -
                         layout.frame.scale * bounds.center();
  };
  // Chooses the first orientation of a paper that the plan fits on.
  const auto takePaper = [&](const Paper& paper) {
    constexpr double hair = 1e-6;
    for (const Eigen::Vector2d& size : {Eigen::Vector2d(paper.across, paper.up),
                                        Eigen::Vector2d(paper.up, paper.across)})
      if ((needed().array() <= size.array() + hair).all()) {
        layout.paper = paper.name;
        place(size);
        return true;
      }
    return false;
  };
  const auto first = static_cast<std::size_t>(settings.paper);
  for (std::size_t k = 0; settings.scale <= 0 && k < scales; ++k) {
    setScale(usualScale(k));
    if (takePaper(papers[first]))
      return layout;
  }
  if (settings.scale > 0)
    setScale(settings.scale);
  for (std::size_t p = first; p < papers.size(); ++p)
    if (takePaper(papers[p]))
      return layout;
  place(needed());
  return layout;
}

} // namespace

PlanElement
PlanFrame::operator()(PlanElement element) const
{
  for (Eigen::Vector2d* p : {&element.start, &element.end, &element.centre})
    *p = (*this)(*p);
  element.radius *= scale;
  return element;
}

PlanLoop
PlanFrame::operator()(PlanLoop loop) const
{
  for (PlanElement& e : loop.elements)
    e = (*this)(e);
  return loop;
}

Eigen::AlignedBox2d
boundsOf(const Floorplan& plan,
         const std::vector<PlanWall>& walls,
         const PlanFrame& frame)
{
  Eigen::AlignedBox2d box;
  for (const PlanWall& wall : walls)
    if (!wall.other)
      box.extend(boundsOf(frame(PlanLoop{{farSideOf(plan, wall)}})));
  for (const PlanRoom& room : plan.rooms) {
    box.extend(boundsOf(frame(room.boundary)));
    for (const PlanNiche& niche : room.niches)
      box.extend(boundsOf(frame(niche.boundary)));
    for (const PlanLoop& column : room.columns)
      box.extend(boundsOf(frame(column)));
  }
  for (const PlanOpening& opening : plan.openings) {
    const Eigen::Vector2d way = (opening.end - opening.start).normalized();
    const Eigen::Vector2d reveal = opening.depth / 2 * leftOf(way);
    for (const Eigen::Vector2d& end : {opening.start, opening.end}) {
      box.extend(frame(Eigen::Vector2d(end + reveal)));
      box.extend(frame(Eigen::Vector2d(end - reveal)));
    }
  }
  return box;
}

SheetLayout
layoutOf(const Floorplan& plan, const DrawingSettings& settings)
{
  PlanFrame frame;
  frame.turn = -mainDirection(plan);
  Eigen::AlignedBox2d space = spaceOf({});
  if (!settings.sections.empty())
    space = {Eigen::Vector2d::Constant(mark_space),
             Eigen::Vector2d::Constant(mark_space)};
  for (const PlanStorey& storey : storeysOf(plan)) {
    const Eigen::AlignedBox2d of_rows =
        spaceOf(rowsAround(partOf(plan, storey), frame.turn, settings.max_wall));
    space.min() = space.min().cwiseMax(of_rows.min()).eval();
    space.max() = space.max().cwiseMax(of_rows.max()).eval();
  }
  const Eigen::AlignedBox2d bounds =
      boundsOf(plan, findWalls(plan, {settings.max_wall}), frame);
  return layoutOf(frame.turn, bounds, space, settings);
}

SheetLayout
layoutOf(const Eigen::AlignedBox2d& bounds,
         const Eigen::AlignedBox2d& space,
         const DrawingSettings& settings)
{
  return layoutOf(0, bounds, space, settings);
}

namespace {

using namespace sheet_measures;

constexpr double row_height = title_height / 3;
constexpr double indent = 1.5;     ///< of texts within their cell
constexpr double north_width = 20; ///< of the cell with the arrow
constexpr SheetColour grey = 0x777777;

/** @brief Draws the strip, row by row from the top. */
class TitleStrip {
public:
  TitleStrip(Sheet& sheet, const SheetLayout& layout)
      : sheet_(sheet)
      , layout_(layout)
      , low_(margin_left, margin)
      , width_(layout.size.x() - margin_left - margin - north_width)
  {
    const Eigen::Vector2d high = layout.size - Eigen::Vector2d::Constant(margin);
    sheet.addBox(looks::frame, {low_, high});
    sheet.addBox(looks::cell, {low_, Eigen::Vector2d(high.x(), margin + title_height)});
  }

  /** @brief Adds a cell between two shares of the width; its text is made to fit. */
  void addCell(int row,
               double from,
               double to,
               const std::string& caption,
               const std::string& text,
               double font = small_font)
  {
    const Eigen::Vector2d corner = cornerOf(row, from);
    const double width = (to - from) * width_;
    sheet_.addBox(looks::cell, {corner, corner + Eigen::Vector2d(width, row_height)});
    addText(grey, corner + Eigen::Vector2d(indent, row_height - 1.9), smallest_font,
            caption, width);
    addText(ink, corner + Eigen::Vector2d(indent, 3), font, text, width);
  }

  /** @brief Adds a scale bar of 25 to 62.5 mm in four parts. */
  void addScaleBar(int row, double from)
  {
    const double per_metre = 1000 / layout_.scale;
    double length = 0.01;
    for (int k = 0; length * per_metre < 25; ++k)
      length *= k % 3 == 1 ? 2.5 : 2; // 1, 2, 5, 10
    const double part = length * per_metre / 4;
    const Eigen::Vector2d start = cornerOf(row, from) + Eigen::Vector2d(4, 2.2);
    for (int k = 0; k < 4; ++k)
      sheet_.addBox({k % 2 == 0 ? ink : paper_colour, ink, 0.15},
                    {start + Eigen::Vector2d(k * part, 0),
                     start + Eigen::Vector2d((k + 1) * part, 1.3)});
    for (int k = 0; k <= 4; k += 2)
      sheet_.add(SheetText{0x444444, start + Eigen::Vector2d(k * part, 3.6),
                           smallest_font,
                           shortDecimalText(length * k / 4, 3) + (k == 4 ? " m" : "")});
  }

  /** @brief Adds an arrow along y of the plan, which is north if the origin belongs to
   * a map grid. */
  void addNorth(const Origin& origin)
  {
    const Eigen::Vector2d middle(layout_.size.x() - margin - north_width / 2,
                                 margin + title_height / 2);
    const Eigen::Rotation2Dd turn(layout_.frame.turn);
    const auto at = [&](double x, double y) -> Eigen::Vector2d {
      return middle + turn * Eigen::Vector2d(x, y);
    };
    sheet_.addLine({ink}, {at(0, 6), at(2.6, -6), at(0, -3.6), at(-2.6, -6)}, true);
    sheet_.add(SheetText{ink, at(0, 9), small_font, origin.isZero() ? "y" : "N"});
  }

private:
  Eigen::Vector2d cornerOf(int row, double share) const
  {
    return low_ + Eigen::Vector2d(share * width_, (2 - row) * row_height);
  }

  void addText(SheetColour colour,
               const Eigen::Vector2d& place,
               double font,
               const std::string& text,
               double width)
  {
    if (text.empty())
      return;
    const double fitting = (width - 2 * indent) / textWidth(text);
    sheet_.add(
        SheetText{colour, place, std::min(font, fitting), text, 0, TextAnchor::Start});
  }

  Sheet& sheet_;
  const SheetLayout& layout_;
  Eigen::Vector2d low_;
  double width_;
};

} // namespace

void
addTitleBlock(Sheet& sheet,
              const SheetLayout& layout,
              const DrawingSettings& settings,
              const TitleTexts& texts)
{
  TitleStrip strip(sheet, layout);
  const SheetTexts& given = settings.texts;
  const bool has_title = !given.title.empty();
  strip.addCell(0, 0, 0.3, has_title ? texts.usual_title : "Title",
                has_title ? given.title : texts.usual_title, large_font);
  strip.addCell(0, 0.3, 0.5, "Project", given.project, large_font);
  strip.addCell(0, 0.5, 0.7, "Client", given.client, large_font);
  strip.addCell(0, 0.7, 0.85, texts.part_caption, texts.part, large_font);
  strip.addCell(0, 0.85, 1, "Scale",
                "1:" + shortDecimalText(layout.scale, 2) + " " + layout.paper,
                large_font);
  strip.addCell(1, 0, 0.3, texts.summary_caption, texts.summary);
  strip.addCell(1, 0.3, 0.4, "Date", given.date);
  strip.addCell(1, 0.4, 0.5, "Drawn", given.drawn_by);
  strip.addCell(1, 0.5, 0.6, "Checked", "");
  strip.addCell(1, 0.6, 1, "", "");
  strip.addScaleBar(1, 0.6);
  const bool has_origin = !settings.origin.isZero();
  strip.addCell(2, 0, has_origin ? 0.65 : 1, "Notes", texts.notes);
  if (has_origin)
    strip.addCell(2, 0.65, 1, "Origin of coordinates, m", settings.origin.text(", "));
  if (texts.has_north)
    strip.addNorth(settings.origin);
}

} // namespace pcl::sedr
