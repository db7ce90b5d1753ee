// SPDX-License-Identifier: BSD-3-Clause
#include "plan_annotations.h"

#include "../sheet/sheet_layout.h"
#include "plan_texts.h"

#include <algorithm>

namespace pcl {
namespace sedr {
namespace {

using namespace sheet_measures;

/** @brief Places dimensions around the plan: by wall, and overall farther out. */
void
placeRows(const Floorplan& plan,
          const PlanFrame& frame,
          TextPlaces& places,
          PlanAnnotations& annotations)
{
  std::vector<PlanElement> walls;
  const PlanFrame turned{frame.turn};
  for (const PlanRoom& room : plan.rooms)
    for (const PlanElement& e : room.boundary.elements)
      walls.push_back(turned(e));
  const PlanFrame to_sheet{0, frame.scale, frame.shift};
  const Eigen::AlignedBox2d bounds = boundsOf(plan, frame);
  const auto addRow = [&](const DimensionChain& chain, double off) {
    const Eigen::Vector2d way = wayOff(chain.side);
    const double edge = std::max(bounds.min().dot(way), bounds.max().dot(way));
    annotations.rows.push_back(placedChain(places, chain, to_sheet, edge + off));
  };
  const double room = 2 * small_font * halfSizeOf({"0.00"}).x();
  const std::vector<DimensionChain> chains =
      wallChains(walls, min_dimension / frame.scale, room / frame.scale);
  for (const DimensionChain& chain : chains)
    addRow(chain, chain_off);
  for (const DimensionChain& chain : overallChains(boundsOf(plan, turned))) {
    const bool has_row =
        std::any_of(chains.begin(), chains.end(), [&](const DimensionChain& other) {
          return other.side == chain.side;
        });
    addRow(chain, chain_off + (has_row ? chain_step : 0));
  }
}

} // namespace

PlanAnnotations
annotationsOf(const Floorplan& plan,
              const std::vector<DrawnElement>& drawn,
              const PlanFrame& frame)
{
  PlanAnnotations annotations;
  TextPlaces places;
  placeRows(plan, frame, places, annotations);
  for (const PlanRoom& room : plan.rooms) {
    places.keepOff(frame(room.boundary));
    for (const PlanLoop& column : room.columns)
      places.keepOff(frame(column));
  }
  PlanTexts(annotations, places, frame).place(plan, drawn);
  return annotations;
}

} // namespace sedr
} // namespace pcl
