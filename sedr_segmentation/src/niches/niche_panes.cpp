// SPDX-License-Identifier: BSD-3-Clause
#include "niche_panes.h"

#include "../scan/scan_excerpt.h"
#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/grids/place_table.h"
#include "wall_cells.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <numeric>

namespace pcl::sedr {

namespace {

/** @brief Of a larger scan, every so-manieth point is taken. */
constexpr std::size_t max_points = 2000000;

/** @brief A niche, the wall around its mouth, and their cells along and up the wall. */
class NicheView {
public:
  /** @brief What was seen of its back, and of the wall around its mouth. */
  struct Counts {
    WallCells back;
    WallCells wall;
  };

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

  Counts noCounts() const
  {
    const WallCells none(-around_, width_ + around_, -around_, height_ + around_,
                         cell_);
    return {none, none};
  }

  const PlanElement& mouth() const { return mouth_; }

  /** @brief Returns how far from the mouth points may count, metres. */
  double reach() const { return around_ + depth_ + reach_; }

  /** @brief Counts a point, if it is on the back or on the wall around the mouth. */
  void count(const Eigen::Vector3f& point, Counts& counts) const
  {
    const WallPoint p = seenFrom(mouth_, bottom_, point);
    const double near = std::min(reach_, depth_ / 3);
    // How far it is from the edges of the mouth, inside.
    const double inside = std::min({p.along, width_ - p.along, p.up, height_ - p.up});
    if (std::abs(p.behind - depth_) <= near && inside >= reach_)
      counts.back.add(p.along, p.up);
    else if (std::abs(p.behind) <= near && inside <= -reach_)
      counts.wall.add(p.along, p.up);
  }

  /** @brief Whether the back is hit far less often than the wall. */
  bool isPane(const Counts& counts) const
  {
    std::vector<double> wall;
    for (const std::size_t points : counts.wall.counts())
      if (points > 0)
        wall.push_back(static_cast<double>(points));
    if (static_cast<double>(wall.size()) < 2 * priors_.min_points)
      return false;
    std::vector<std::size_t> back = counts.back.counts();
    std::sort(back.begin(), back.end(), std::greater<>());
    const double cells =
        std::max(1.0, priors_.share_half / 2 * std::floor(width_ / cell_) *
                          std::floor(height_ / cell_));
    const auto best =
        std::accumulate(back.begin(), back.begin() + static_cast<std::ptrdiff_t>(cells),
                        std::size_t{0});
    return static_cast<double>(best) <
           priors_.share_part * std::floor(cells) * middleValue(std::move(wall));
  }

private:
  double cell_;   ///< along the wall and up, metres
  double around_; ///< the mouth, where the wall is looked at, metres
  double reach_;  ///< of the points of wall and back; of sides, from the edges
  const Priors& priors_;
  PlanElement mouth_;
  PlanSlab bottom_;
  double width_ = 0;
  double height_ = 0;
  double depth_ = 0;
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

/** @brief The counts of each niche. */
std::vector<NicheView::Counts>
countsOf(const std::vector<NicheView>& views,
         const PointView& raw,
         const std::vector<int>& indices,
         unsigned threads)
{
  std::vector<NicheView::Counts> sums;
  PlaceTable views_near(0.5); // metres
  for (const NicheView& view : views) {
    views_near.addAlong(view.mouth(), view.reach(),
                        static_cast<std::uint32_t>(sums.size()));
    sums.push_back(view.noCounts());
  }
  views_near.finish();
  const std::size_t all = indices.empty() ? raw.size() : indices.size();
  const std::size_t step = rawStep(all, max_points);
  std::mutex adding;
  parallelBlocks(
      all / step, points_a_block, threads, [&](std::size_t begin, std::size_t end) {
        std::vector<NicheView::Counts> counts;
        for (const NicheView& view : views)
          counts.push_back(view.noCounts());
        for (std::size_t k = begin; k < end; ++k) {
          const std::size_t i = k * step;
          const Eigen::Vector3f p =
              raw[indices.empty() ? i : static_cast<std::size_t>(indices[i])];
          for (const std::uint32_t v : views_near.at(p.head<2>().cast<double>()))
            views[v].count(p, counts[v]);
        }
        const std::lock_guard<std::mutex> lock(adding);
        for (std::size_t v = 0; v < views.size(); ++v) {
          sums[v].back.add(counts[v].back);
          sums[v].wall.add(counts[v].wall);
        }
      });
  return sums;
}

} // namespace

std::size_t
leaveOutPanes(Floorplan& plan,
              const PointView& raw,
              const std::vector<int>& indices,
              unsigned threads,
              const Priors& priors)
{
  std::vector<NicheView> views;
  for (const PlanRoom& room : plan.rooms)
    for (const PlanNiche& niche : room.niches)
      if (isAsked(niche))
        views.emplace_back(niche, priors);
  if (views.empty())
    return 0;
  const std::vector<NicheView::Counts> counts = countsOf(views, raw, indices, threads);
  std::size_t asked = 0;
  std::size_t taken_out = 0;
  for (PlanRoom& room : plan.rooms) {
    std::vector<PlanNiche> kept;
    for (PlanNiche& niche : room.niches) {
      const bool is_pane = isAsked(niche) && views[asked].isPane(counts[asked]);
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
