// SPDX-License-Identifier: BSD-3-Clause
#include "niche_panes.h"

#include "../scan/scan_excerpt.h"
#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/grids/place_table.h"
#include "wall_recess.h"
#include <pcl/sedr_filters/cell_grid.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

namespace pcl::sedr {

namespace {

/** @brief Of a larger scan, every so-manieth point is taken. */
constexpr std::size_t max_points = 2000000;

/** @brief A niche, the wall around its mouth, and how often their cells along and up
 * the wall were hit. */
class NicheView {
public:
  NicheView(const PlanNiche& niche, const Priors& priors)
      : cell_(priors.evidence_cell)
      , around_(priors.min_recess)
      , reach_(priors.wall_band)
      , priors_(priors)
  {
    const std::vector<PlanElement>& sides = niche.boundary.elements;
    mouth_ = sides.back();
    std::swap(mouth_.start, mouth_.end);
    width_ = mouth_.length();
    const Eigen::Vector2d middle = (mouth_.start + mouth_.end) / 2;
    bottom_ = niche.bottom;
    height_ = niche.top.heightAt(middle) - bottom_.heightAt(middle);
    depth_ = mouth_.distance(sides[1].start);
  }

  const PlanElement& mouth() const { return mouth_; }

  /** @brief Returns how far from the mouth points may count, metres. */
  double reach() const { return around_ + depth_ + reach_; }

  /** @brief Counts a point, if it is on the back or on the wall around the mouth. */
  void count(const Eigen::Vector3f& point)
  {
    const WallPoint p = seenFrom(mouth_, bottom_, point);
    const double near = std::min(reach_, depth_ / 3);
    // How far it is from the edges of the mouth, inside.
    const double inside = std::min({p.along, width_ - p.along, p.up, height_ - p.up});
    if (std::abs(p.behind - depth_) <= near && inside >= reach_)
      ++back_[cellAt(p)];
    else if (std::abs(p.behind) <= near && inside <= -reach_ && inside >= -around_)
      ++wall_[cellAt(p)];
  }

  /** @brief Whether the back is hit far less often than the wall. */
  bool isPane() const
  {
    if (static_cast<double>(wall_.size()) < 2 * priors_.min_points)
      return false;
    std::vector<double> back = countsOf(back_);
    std::sort(back.begin(), back.end(), std::greater<>());
    const double cells =
        std::max(1.0, std::floor(priors_.share_half / 2 * std::floor(width_ / cell_) *
                                 std::floor(height_ / cell_)));
    back.resize(static_cast<std::size_t>(cells), 0);
    return std::accumulate(back.begin(), back.end(), 0.0) <
           priors_.share_part * cells * middleValue(countsOf(wall_));
  }

private:
  using Counts = std::map<CellKey, double>;

  CellKey cellAt(const WallPoint& p) const
  {
    return keyOf(CellGrid(cell_).at(p.along, p.up));
  }

  static std::vector<double> countsOf(const Counts& cells)
  {
    std::vector<double> counts;
    for (const auto& entry : cells)
      counts.push_back(entry.second);
    return counts;
  }

  double cell_;   ///< along the wall and up, metres
  double around_; ///< the mouth, where the wall is looked at, metres
  double reach_;  ///< of the points of wall and back; of sides, from the edges
  const Priors& priors_;
  PlanElement mouth_;
  PlanSlab bottom_;
  double width_ = 0;
  double height_ = 0;
  double depth_ = 0;
  Counts back_;
  Counts wall_;
};

/** @brief Whether a niche is no deeper than half of its mouth's width and height:
 * further in, its sides hide its back from most places in the room. */
bool
isAsked(const PlanNiche& niche)
{
  const std::vector<PlanElement>& sides = niche.boundary.elements;
  if (sides.size() != 4) // left, back, right, mouth
    return false;
  const Eigen::Vector2d place = sides[3].start;
  const double height = niche.top.heightAt(place) - niche.bottom.heightAt(place);
  return 2 * sides[0].length() <= std::min(height, sides[3].length());
}

/** @brief Counts the points of a scan on and around the niches. */
void
countHits(const PointView& raw,
          const std::vector<int>& indices,
          std::vector<NicheView>& views)
{
  PlaceTable views_near(0.5); // metres
  for (std::size_t v = 0; v < views.size(); ++v)
    views_near.addAlong(views[v].mouth(), views[v].reach(),
                        static_cast<std::uint32_t>(v));
  views_near.finish();
  const std::size_t all = indices.empty() ? raw.size() : indices.size();
  const std::size_t step = rawStep(all, max_points);
  for (std::size_t k = 0; k < all; k += step) {
    const Eigen::Vector3f p =
        raw[indices.empty() ? k : static_cast<std::size_t>(indices[k])];
    for (const std::uint32_t v : views_near.at(p.head<2>().cast<double>()))
      views[v].count(p);
  }
}

} // namespace

std::size_t
leaveOutPanes(Floorplan& plan,
              const PointView& raw,
              const std::vector<int>& indices,
              const Priors& priors)
{
  std::vector<NicheView> views;
  for (const PlanRoom& room : plan.rooms)
    for (const PlanNiche& niche : room.niches)
      if (isAsked(niche))
        views.emplace_back(niche, priors);
  if (views.empty())
    return 0;
  countHits(raw, indices, views);
  std::size_t asked = 0;
  std::size_t taken_out = 0;
  for (PlanRoom& room : plan.rooms) {
    std::vector<PlanNiche> kept;
    for (PlanNiche& niche : room.niches) {
      const bool is_pane = isAsked(niche) && views[asked].isPane();
      asked += isAsked(niche) ? 1 : 0;
      if (is_pane)
        ++taken_out;
      else
        kept.push_back(std::move(niche));
    }
    room.niches = std::move(kept);
  }
  return taken_out;
}

} // namespace pcl::sedr
