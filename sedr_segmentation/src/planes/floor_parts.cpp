// SPDX-License-Identifier: BSD-3-Clause
#include "floor_parts.h"

#include "../sheets/sheet_fit.h"
#include "../surface/cell_pieces.h"
#include "../surface/riser_bins.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief A grid over some points, and its cells at most 20 cm from one. */
SheetGrid
gridOver(const std::vector<Eigen::Vector3d>& places,
         const SheetParameters& parameters,
         std::vector<std::uint8_t>& domain)
{
  constexpr int reach = 2; // cells
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& p : places)
    box.extend(p.head<2>());
  const SheetGrid grid = sheetGrid(box, parameters);
  domain.assign(grid.count(), 0);
  for (const Eigen::Vector3d& p : places) {
    const std::size_t cell = grid.at(p.head<2>());
    grid.forAllWithin(cell, reach, [&](std::size_t near) { domain[near] = 1; });
  }
  return grid;
}

/** @brief A piece of the surface on which a room's air ends, and its rim in cells. */
struct FloorPiece {
  struct Border {
    double length = 0; ///< metres
    double closed = 0; ///< by risers, or as the step is low
    double rise = 0;   ///< sum over the border, from this piece to the other one
  };

  const PlanSlab* slab = nullptr;
  double area = 0;       ///< seen, square metres
  double depth = 0;      ///< twice the area by the rim, metres: of a strip its width
  double above_main = 0; ///< mean height, metres
  double hides = 0;      ///< share of its cells off the rim with floor below
  double free = 0;       ///< share of these with more room above than below
  double walls = 0;      ///< length of its rim beside walls, metres
  double rim = 0;        ///< metres
  std::map<std::size_t, Border> borders;
  bool is_floor = false;
};

/** @brief Decides which pieces are of the floor, from the main plane outwards. */
class FloorPieces {
public:
  FloorPieces(const FacetSheet& surface,
              const RiserBins& risers,
              const std::vector<std::uint8_t>& floor_seen,
              const std::vector<double>& highest,
              const PlanSlab& main,
              const Priors& priors)
      : priors_(priors)
  {
    const SheetGrid& grid = surface.grid;
    std::vector<std::int32_t> label = surface.label;
    for (std::size_t cell = 0; cell < label.size(); ++cell)
      if (!surface.is_inside[cell])
        label[cell] = FacetSheet::none;
    const std::vector<std::vector<std::size_t>> cells_of = piecesOf(grid, label);
    piece_of_.resize(label.size());
    for (std::size_t k = 0; k < cells_of.size(); ++k)
      for (const std::size_t cell : cells_of[k])
        piece_of_[cell] = k;
    for (const std::vector<std::size_t>& cells : cells_of) {
      FloorPiece& piece = pieces_.emplace_back();
      if (label[cells.front()] == FacetSheet::none)
        continue;
      piece.slab = &surface.facets[static_cast<std::size_t>(label[cells.front()])];
      double within = 0; // cells off the rim
      for (const std::size_t cell : cells) {
        const Eigen::Vector2d place = grid.centre(cell);
        const double height = piece.slab->heightAt(place);
        const double over = height - main.heightAt(place);
        piece.area += surface.is_seen[cell] ? grid.size * grid.size : 0;
        piece.above_main += over / static_cast<double>(cells.size());
        const double rim_before = piece.rim;
        grid.forAllSides(cell, [&](std::size_t next) {
          if (label[next] == label[cell])
            return;
          piece.rim += grid.size;
          if (label[next] == FacetSheet::none) {
            piece.walls += grid.size;
            return;
          }
          const double other =
              surface.facets[static_cast<std::size_t>(label[next])].heightAt(place);
          FloorPiece::Border& border = piece.borders[piece_of_[next]];
          border.length += grid.size;
          border.rise += grid.size * (other - height);
          const auto& [low, high] = std::minmax(height, other);
          border.closed +=
              high - low < RiserBins::min_step ||
                      risers.share(cell, next, low, high) >= priors.share_half
                  ? grid.size
                  : 0;
        });
        if (piece.rim > rim_before)
          continue;
        within += 1;
        piece.hides += floor_seen[cell] && over > priors.min_floor_step ? 1 : 0;
        piece.free += highest[cell] - height >= over ? 1 : 0;
      }
      piece.hides /= std::max(1.0, within);
      piece.free /= std::max(1.0, within);
      piece.depth =
          2 * grid.size * grid.size * static_cast<double>(cells.size()) / piece.rim;
      piece.is_floor = std::abs(piece.above_main) < priors.min_floor_step;
    }
    for (bool has_grown = true; has_grown;) {
      has_grown = false;
      for (FloorPiece& piece : pieces_)
        if (!piece.is_floor && piece.slab && isFloor(piece)) {
          piece.is_floor = true;
          has_grown = true;
        }
    }
    // Beds and desks of one height are alike: two side by side are no platform.
    std::map<const PlanSlab*, double> floor_more;
    for (const FloorPiece& piece : pieces_)
      floor_more[piece.slab] += piece.is_floor ? piece.area : -piece.area;
    for (FloorPiece& piece : pieces_)
      piece.is_floor = piece.is_floor && floor_more[piece.slab] > 0;
  }

  /** @brief Returns the slab of the floor in a cell; null where it is none. */
  const PlanSlab* slabIn(std::size_t cell) const
  {
    const FloorPiece& piece = pieces_[piece_of_[cell]];
    return piece.is_floor ? piece.slab : nullptr;
  }

private:
  bool isFloor(const FloorPiece& piece) const
  {
    constexpr double steepest = radians(15); // of a ramp
    if (piece.hides > priors_.share_unseen || piece.slab->plane[2] < std::cos(steepest))
      return false;
    const bool is_no_furniture =
        piece.free >= priors_.share_half &&
        !isAsFurniture(piece.area, piece.depth, piece.above_main, priors_);
    double closed = piece.walls;
    double held = piece.walls; // by what furniture has not beside it
    bool is_reached = false;
    bool is_below_floor = false;
    bool goes_on = false; // without a step, as a landing of a ramp
    for (const auto& [other, border] : piece.borders) {
      const double rise = border.rise / border.length;
      const bool is_step = std::abs(rise) <= priors_.max_step_height;
      const bool is_known = pieces_[other].is_floor;
      closed += border.closed;
      if (is_known || (rise > priors_.min_floor_step && is_step))
        held += rise > -priors_.min_floor_step ? border.length : 0;
      is_reached = is_reached || (is_known && is_step);
      goes_on = goes_on || (is_known && std::abs(rise) < priors_.min_floor_step);
      is_below_floor = is_below_floor || (is_known && rise > priors_.min_floor_step);
    }
    // A group of desks or shelves is as large as a stage, but not as closed.
    const double min_closed = std::abs(piece.above_main) <= priors_.max_platform_height
                                  ? priors_.share_closed
                                  : priors_.share_most;
    const double least = is_below_floor || goes_on ? SheetParameters().min_closed_area
                                                   : priors_.min_platform_area;
    return piece.area >= least && closed >= min_closed * piece.rim &&
           (is_no_furniture ||
            (is_reached && held >= priors_.share_little * piece.rim));
  }

  const Priors& priors_;
  std::vector<std::size_t> piece_of_; ///< of each cell
  std::vector<FloorPiece> pieces_;
};

} // namespace

bool
isAsFurniture(double area, double depth, double height, const Priors& priors)
{
  constexpr double riser = 0.2; // metres: no furniture is as low as a step
  return area <= priors.max_furniture_area * std::min(1.0, height / riser) ||
         (height > priors.max_platform_height && depth <= priors.max_furniture_depth);
}

std::vector<int>
floorPoints(const PointView& points,
            const std::vector<int>& ends,
            const std::vector<int>& around,
            const PlanSlab& main,
            double tolerance,
            const Priors& priors)
{
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
  std::vector<std::uint8_t> domain;
  const SheetGrid grid = gridOver(places, parameters, domain);
  const std::vector<Eigen::Vector3d> all = placesOf(points, around);
  const FacetSheet surface = fitSheet(places, grid, domain, {}, parameters, all);
  if (surface.facets.empty())
    return floor;
  std::vector<std::uint8_t> floor_seen(grid.count(), 0);
  std::vector<double> highest(grid.count(), -1e9);
  for (const Eigen::Vector3d& p : all)
    if (const std::size_t cell = grid.at(p.head<2>()); cell < floor_seen.size()) {
      highest[cell] = std::max(highest[cell], p.z());
      if (std::abs(distanceAbove(main, p.cast<float>())) <= tolerance / 2)
        floor_seen[cell] = 1;
    }
  const auto [low, high] =
      std::minmax_element(places.begin(), places.end(),
                          [](const auto& a, const auto& b) { return a.z() < b.z(); });
  const FloorPieces pieces(surface,
                           RiserBins(grid, std::vector<std::uint8_t>(grid.count(), 1),
                                     all, low->z(), high->z()),
                           floor_seen, highest, main, priors);
  floor.clear();
  for (const int i : ends) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    const std::size_t cell =
        p.allFinite() ? grid.at(p.head<2>().cast<double>()) : grid.count();
    const PlanSlab* slab = cell < grid.count() ? pieces.slabIn(cell) : nullptr;
    if (isOn(i, main) || (slab && isOn(i, *slab)))
      floor.push_back(i);
  }
  return floor;
}

} // namespace pcl::sedr
