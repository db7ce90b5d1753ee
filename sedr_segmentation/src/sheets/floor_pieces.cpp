// SPDX-License-Identifier: BSD-3-Clause
#include "floor_pieces.h"
#include "sheet_fit.h"

#include "../surface/cell_points.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace pcl::sedr {

namespace {

/** @brief A piece of the surface on which a room's air ends, and its rim. */
struct FloorPiece {
  struct Border {
    double length = 0; ///< metres
    double rise = 0;   ///< sum over the border, from this piece to the other one
  };

  std::int32_t facet = FacetSheet::none;
  double area = 0;  ///< seen, square metres
  double depth = 0; ///< twice the area by the rim, metres: of a strip its width
  double over = 0;  ///< mean height above the main plane, metres
  double hides = 0; ///< of the area, off the rim: main plane seen below
  double spare = 0; ///< area with more room above than below, less that with less
  double walls = 0; ///< length of its rim beside walls, metres
  double rim = 0;   ///< metres
  std::map<std::size_t, Border> borders; ///< with other pieces
  bool is_floor = false;
};

bool
isFloor(const FloorPiece& piece,
        const std::vector<FloorPiece>& pieces,
        const FacetEvidence& evidence,
        const Priors& priors)
{
  double held = piece.walls; // by what furniture has not beside it
  bool is_reached = false;
  bool is_beside = false; // without a step up, as a pit or the landing of a ramp
  for (const auto& [other, border] : piece.borders) {
    const double rise = border.rise / border.length;
    const bool is_step = std::abs(rise) <= priors.max_step_height;
    const bool is_known = pieces[other].is_floor;
    const bool is_no_lower = is_known && rise > -priors.min_floor_step;
    if (is_no_lower || (rise > priors.min_floor_step && is_step))
      held += border.length;
    is_reached = is_reached || (is_known && is_step);
    is_beside = is_beside || is_no_lower;
  }
  const double least =
      is_beside ? evidence.parameters.min_closed_area : priors.min_platform_area;
  return piece.area >= least && piece.hides <= priors.share_unseen * piece.area &&
         ((piece.spare >= 0 &&
           !isAsFurniture(piece.area, piece.depth, piece.over, priors)) ||
          (is_reached && held >= priors.share_little * piece.rim));
}

} // namespace

bool
isAsFurniture(double area, double depth, double height, const Priors& priors)
{
  constexpr double riser = 0.2; // metres: no furniture is as low as a step
  return area <= priors.max_furniture_area * std::min(1.0, height / riser) ||
         (height > priors.max_platform_height && depth <= priors.max_furniture_depth);
}

void
dropFurniture(const FacetEvidence& evidence,
              const std::vector<Eigen::Vector3d>& around,
              const FurnishedFloor& floor,
              FacetChoice& choice)
{
  const SheetGrid& grid = evidence.cells.grid();
  const double cell_area = grid.size * grid.size;
  std::vector<double> highest(grid.count(), -std::numeric_limits<double>::infinity());
  std::vector<std::uint8_t> shows_main(grid.count(), 0);
  for (const Eigen::Vector3d& p : around)
    if (const std::size_t cell = grid.at(p.head<2>()); cell < highest.size()) {
      highest[cell] = std::max(highest[cell], p.z());
      if (std::abs(p.z() - floor.main.heightAt(p.head<2>())) <
          floor.priors.min_floor_step)
        shows_main[cell] = 1;
    }
  const std::vector<std::int32_t> label = choice.label;
  const std::vector<std::vector<std::size_t>> cells_of = piecesOf(grid, label);
  std::vector<std::size_t> piece_of(label.size());
  for (std::size_t k = 0; k < cells_of.size(); ++k)
    for (const std::size_t cell : cells_of[k])
      piece_of[cell] = k;
  std::vector<FloorPiece> pieces(cells_of.size());
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    FloorPiece& piece = pieces[k];
    piece.facet = label[cells_of[k].front()];
    if (piece.facet == FacetSheet::none)
      continue;
    const auto heightOf = [&](std::int32_t facet, std::size_t cell) {
      return choice.costs[static_cast<std::size_t>(facet)].height[cell];
    };
    const auto size = static_cast<double>(cells_of[k].size());
    for (const std::size_t cell : cells_of[k]) {
      const double height = heightOf(piece.facet, cell);
      const double over = height - floor.main.heightAt(grid.centre(cell));
      piece.over += over / size;
      const double rim = piece.rim;
      grid.forAllSides(cell, [&](std::size_t next) {
        if (label[next] == piece.facet)
          return;
        piece.rim += grid.size;
        if (label[next] == FacetSheet::none) {
          piece.walls += grid.size;
          return;
        }
        FloorPiece::Border& border = piece.borders[piece_of[next]];
        border.length += grid.size;
        border.rise += grid.size * (heightOf(label[next], cell) - height);
      });
      if (!choice.explains(cell, evidence))
        continue;
      piece.area += cell_area;
      piece.spare += highest[cell] - height >= over ? cell_area : -cell_area;
      if (piece.rim == rim && over > RiserBins::min_step && shows_main[cell])
        piece.hides += cell_area;
    }
    piece.depth = 2 * cell_area * size / piece.rim;
    piece.is_floor = std::abs(piece.over) < floor.priors.min_floor_step;
  }
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (FloorPiece& piece : pieces)
      if (!piece.is_floor && piece.facet != FacetSheet::none &&
          isFloor(piece, pieces, evidence, floor.priors))
        piece.is_floor = has_grown = true;
  }
  // Beds and desks of one height are alike: two side by side are no platform.
  std::map<std::int32_t, double> floor_more;
  for (const FloorPiece& piece : pieces)
    floor_more[piece.facet] += piece.is_floor ? piece.area : -piece.area;
  for (std::size_t cell = 0; cell < label.size(); ++cell)
    if (!pieces[piece_of[cell]].is_floor || floor_more[label[cell]] <= 0)
      choice.label[cell] = FacetSheet::none;
}

std::vector<int>
floorPoints(const PointView& points,
            const std::vector<int>& ends,
            const std::vector<int>& around,
            const PlanSlab& main,
            double tolerance,
            const Priors& priors)
{
  constexpr int reach = 2; // cells beside a point that are of the room
  const auto isOn = [&](int i, const PlanSlab& slab) {
    return std::abs(distanceAbove(slab, points[static_cast<std::size_t>(i)])) <=
           tolerance;
  };
  std::vector<int> floor;
  std::copy_if(ends.begin(), ends.end(), std::back_inserter(floor),
               [&](int i) { return isOn(i, main); });
  const std::vector<Eigen::Vector3d> places = placesOf(points, ends);
  if (places.size() == floor.size())
    return floor;
  const SheetParameters parameters = SheetParameters::of(priors, true);
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& p : places)
    box.extend(p.head<2>());
  const SheetGrid grid = sheetGrid(box, parameters);
  std::vector<std::uint8_t> domain(grid.count(), 0);
  for (const Eigen::Vector3d& p : places)
    grid.forAllWithin(grid.at(p.head<2>()), reach,
                      [&](std::size_t near) { domain[near] = 1; });
  const FurnishedFloor furnished{main, priors};
  const FacetSheet sheet = fitSheet(places, grid, domain, {}, parameters,
                                    placesOf(points, around), &furnished);
  if (sheet.facets.empty())
    return floor;
  const auto isOnFacet = [&](int i, const Eigen::Vector3f& p) {
    const std::size_t cell = grid.nearest(p.head<2>().cast<double>());
    return sheet.is_inside[cell] &&
           isOn(i, sheet.facets[static_cast<std::size_t>(sheet.label[cell])]);
  };
  floor.clear();
  for (const int i : ends)
    if (const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
        p.allFinite() && (isOn(i, main) || isOnFacet(i, p)))
      floor.push_back(i);
  return floor;
}

} // namespace pcl::sedr
