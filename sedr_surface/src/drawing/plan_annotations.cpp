// SPDX-License-Identifier: BSD-3-Clause
#include "plan_annotations.h"

#include "../sheet/sheet_layout.h"
#include "plan_texts.h"

#include <algorithm>

namespace pcl::sedr {
namespace {

using namespace sheet_measures;

/** @brief A row of dimensions and where it is. */
struct ChainRow {
  DimensionChain chain;
  double line = 0; ///< millimetres along wayOff()
};

/** @brief The rows around a plan: by wall, and overall farther out. */
std::vector<ChainRow>
rowsAround(const Floorplan& plan, const PlanFrame& frame, double max_wall)
{
  std::vector<PlanElement> walls;
  const PlanFrame turned{frame.turn};
  for (const PlanRoom& room : plan.rooms)
    for (const PlanElement& e : room.boundary.elements)
      walls.push_back(turned(e));
  const Eigen::AlignedBox2d bounds = boundsOf(plan, frame);
  std::vector<ChainRow> rows;
  const auto addRow = [&](const DimensionChain& chain, double off) {
    const Eigen::Vector2d way = wayOff(chain.side);
    rows.push_back(
        {chain, std::max(bounds.min().dot(way), bounds.max().dot(way)) + off});
  };
  const double room = 2 * small_font * halfSizeOf({"0.00"}).x();
  const std::vector<DimensionChain> chains =
      wallChains(walls, max_wall, min_dimension / frame.scale, room / frame.scale);
  for (const DimensionChain& chain : chains)
    addRow(chain, chain_off);
  for (const DimensionChain& chain : overallChains(boundsOf(plan, turned))) {
    const bool has_row =
        std::any_of(chains.begin(), chains.end(), [&](const DimensionChain& other) {
          return other.side == chain.side;
        });
    addRow(chain, chain_off + (has_row ? chain_step : 0));
  }
  return rows;
}

/** @brief Takes the place at one end of a dimension out of its chain, so that it is
 * joined with the shorter one of its neighbours. */
void
joinWithNeighbour(DimensionChain& chain, std::size_t dimension)
{
  const std::size_t last = chain.places.size() - 1;
  const auto length = [&](std::size_t k) {
    return chain.along(k + 1) - chain.along(k);
  };
  const bool is_before =
      dimension + 1 == last ||
      (dimension > 0 && length(dimension - 1) < length(dimension + 1));
  chain.places.erase(chain.places.begin() + static_cast<std::ptrdiff_t>(
                                                is_before ? dimension : dimension + 1));
}

/** @brief Places the rows with their texts. A dimension whose text has no place is
 * joined with a neighbour, and one that is alone is left out with its row: every one
 * that is drawn can be read. All rows are placed anew each time that one of each was
 * joined: for rows of n dimensions n times at most. */
void
placeRows(std::vector<ChainRow> rows,
          const PlanFrame& to_sheet,
          TextPlaces& places,
          PlanAnnotations& annotations)
{
  while (true) {
    TextPlaces tried = places;
    annotations.rows.clear();
    for (const ChainRow& row : rows) {
      annotations.rows.push_back(linesOf(row.chain, to_sheet, row.line));
      keepOff(tried, annotations.rows.back());
    }
    bool is_complete = true;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      std::vector<PlacedDimension>& row = annotations.rows[r];
      placeTexts(tried, rows[r].chain.side, row);
      const auto without = std::find_if(
          row.begin(), row.end(), [](const PlacedDimension& d) { return !d.text; });
      if (without == row.end())
        continue;
      is_complete = false;
      if (row.size() > 1)
        joinWithNeighbour(rows[r].chain,
                          static_cast<std::size_t>(without - row.begin()));
      else
        rows[r].chain.places.clear();
    }
    rows.erase(
        std::remove_if(rows.begin(), rows.end(),
                       [](const ChainRow& row) { return row.chain.places.empty(); }),
        rows.end());
    if (is_complete) {
      places = tried;
      return;
    }
  }
}

} // namespace

PlanAnnotations
annotationsOf(const Floorplan& plan,
              const std::vector<DrawnElement>& drawn,
              const std::vector<CeilingLines>& ceilings,
              const PlanFrame& frame,
              double max_wall)
{
  PlanAnnotations annotations;
  TextPlaces places;
  placeRows(rowsAround(plan, frame, max_wall), {0, frame.scale, frame.shift}, places,
            annotations);
  for (const PlanRoom& room : plan.rooms) {
    places.keepOff(frame(room.boundary));
    for (const PlanLoop& column : room.columns)
      places.keepOff(frame(column));
  }
  for (const DrawnElement& line : drawn)
    if (line.layer != DrawnLayer::Wall && line.layer != DrawnLayer::Column)
      places.avoid(frame(line.element));
  PlanTexts(annotations, places, frame).place(plan, drawn, ceilings);
  return annotations;
}

} // namespace pcl::sedr
