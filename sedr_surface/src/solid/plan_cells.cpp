// SPDX-License-Identifier: BSD-3-Clause
#include "plan_subdivision.h"
#include "sedr_filters/src/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::sedr {
namespace {

/** @brief A triangulated room plan with a region per triangle. Regions that cannot be
 * built are replaced. */
class PlanCells {
public:
  /** @brief Finds the regions by the loops around each triangle of a plan, which must
   * outlive this object. */
  explicit PlanCells(const TriangulatedPlan& plan)
      : plan_(plan)
  {
    using Winding = std::vector<int>;
    const auto inside = [&](std::uint32_t t, std::size_t side, Winding beyond) {
      for (const SegmentUse& use : plan_.usesAt(t, side)) {
        const bool is_left =
            use.forward == (plan_.corner(t, side) < plan_.corner(t, side + 1));
        if (plan_.sources[use.segment].loop != SegmentSource::no_loop)
          beyond[plan_.sources[use.segment].loop] += is_left ? 1 : -1;
      }
      return beyond;
    };
    for (const Winding& winding :
         spread(plan.triangulation, Winding(plan.layers.loops.size(), 0), inside))
      region_.push_back(plan.layers.regionOf(winding));
  }

  /** @brief Merges slivers into neighbouring parts. */
  void mergeSlivers()
  {
    // One by one, the narrowest first, since a merge widens the other part.
    for (;;) {
      const std::vector<Part> parts = regions();
      const Part* narrowest = nullptr;
      for (const Part& part : parts)
        if (!part.is_outside && widthOf(part) < part.tolerance &&
            (!narrowest || widthOf(part) < widthOf(*narrowest)))
          narrowest = &part;
      if (!narrowest)
        return;
      assign(*narrowest, heirOf(*narrowest));
    }
  }

  /** @brief Removes details and niches, then other regions, that leave no height
   * between floor and ceiling or would touch a neighbour. */
  void dropUnbuildable(std::vector<PlanWarning>& warnings)
  {
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      for (Part& part : regions()) {
        const std::string problem = problemOf(part);
        if (problem.empty())
          continue;
        const PlanRegion region = part.region;
        for (const PlanRegion& plain : plan_.layers.plainRegions(region)) {
          part.region = plain;
          if (plain != region && problemOf(part).empty())
            break;
        }
        const bool is_floor = part.region.isRoom() && part.region.floor != region.floor;
        const int slab = is_floor ? region.floor : region.ceiling;
        const std::size_t element =
            plan_.layers.slabs[static_cast<std::size_t>(slab)].element;
        const Eigen::Vector2d at = middleOf(part);
        warnings.push_back(warningOf(
            WarningKind::Contradiction,
            plan_.layers.wordsOf(element) +
                formatText(" around (%.1f, %.1f), %.2f m2, is left out: ", at.x(),
                           at.y(), part.area) +
                problem,
            {part.area}));
        warnings.back().at = at;
        assign(part, part.region);
        is_changed = true;
        break;
      }
    }
  }

  /** @brief Removes small pieces cut off by columns or crossing walls, and warns of
   * larger ones. */
  void checkPieces(std::vector<PlanWarning>& warnings)
  {
    std::vector<Part> pieces = partsOf([](const PlanRegion& a, const PlanRegion& b) {
      return a.isRoom() == b.isRoom(); // regardless of regions
    });
    pieces.erase(std::remove_if(pieces.begin(), pieces.end(),
                                [](const Part& part) { return !part.region.isRoom(); }),
                 pieces.end());
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const Part& a, const Part& b) { return a.area > b.area; });
    constexpr double crumb = 0.01; // square metres
    while (pieces.size() > 1 && pieces.back().area < crumb) {
      assign(pieces.back(), PlanRegion());
      pieces.pop_back();
    }
    if (pieces.size() > 1)
      warnings.push_back(
          warningOf(WarningKind::Contradiction,
                    formatText("its plan falls into %zu pieces, the largest of %.2f m2 "
                               "and %.2f m2",
                               pieces.size(), pieces[0].area, pieces[1].area),
                    {pieces[1].area}));
  }

  /** @brief Gives a square the region that most of it has. */
  void unify(const PlanSquare& square)
  {
    const double reach =
        square.half + 2 * solidSeparation(plan_.grid) / plan_.grid.unit();
    const auto isIn = [&](std::uint32_t v) {
      const GridPoint& p = plan_.arrangement.vertices[v];
      return std::max(std::abs(static_cast<double>(p.x) - square.middle.x),
                      std::abs(static_cast<double>(p.y) - square.middle.y)) <= reach;
    };
    Part part;
    std::map<PlanRegion, double> areas;
    for (std::uint32_t t = 0; t < region_.size(); ++t)
      if (isIn(plan_.corner(t, 0)) && isIn(plan_.corner(t, 1)) &&
          isIn(plan_.corner(t, 2))) {
        part.triangles.push_back(t);
        areas[region_[t]] += plan_.areaOf(t);
      }
    if (!areas.empty())
      assign(part, std::max_element(
                       areas.begin(), areas.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; })
                       ->first);
  }

  /** @brief Returns the edges between different regions. */
  std::vector<SubdivisionEdge> edges() const
  {
    std::vector<SubdivisionEdge> edges;
    for (std::uint32_t t = 0; t < region_.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const PlanRegion beyond = across(t, i);
        const std::vector<SegmentUse>& uses = plan_.usesAt(t, i);
        if (uses.empty() || beyond == region_[t] ||
            plan_.triangulation.neighbours[t][i] < t) // seen from there
          continue;
        SubdivisionEdge e{plan_.corner(t, i),
                          plan_.corner(t, i + 1),
                          region_[t],
                          beyond,
                          {}};
        for (const SegmentUse& use : uses)
          if (plan_.sources[use.segment].loop != SegmentSource::no_loop)
            e.elements.push_back(plan_.sources[use.segment].element);
        std::sort(e.elements.begin(), e.elements.end());
        e.elements.erase(std::unique(e.elements.begin(), e.elements.end()),
                         e.elements.end());
        edges.push_back(std::move(e));
      }
    return edges;
  }

  /** @brief Returns the visible creases of curved slabs. */
  std::vector<SubdivisionCrease> creases() const
  {
    std::vector<SubdivisionCrease> creases;
    for (std::uint32_t t = 0; t < region_.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t n = plan_.triangulation.neighbours[t][i];
        const int slab = region_[t].ceiling;
        if (n == none || n < t || slab == PlanRegion::nothing ||
            region_[n] != region_[t])
          continue;
        const std::vector<SegmentUse>& uses = plan_.usesAt(t, i);
        const std::size_t element =
            plan_.layers.slabs[static_cast<std::size_t>(slab)].element;
        if (std::any_of(uses.begin(), uses.end(), [&](const SegmentUse& use) {
              return plan_.sources[use.segment].loop == SegmentSource::no_loop &&
                     plan_.sources[use.segment].element == element;
            }))
          creases.push_back({plan_.corner(t, i), plan_.corner(t, i + 1), slab});
      }
    return creases;
  }

private:
  static constexpr std::uint32_t none = PlanTriangulation::none;

  /** @brief Connected triangles of one region. */
  struct Part {
    PlanRegion region;
    std::vector<std::uint32_t> triangles;
    double area = 0;                     ///< square metres
    double perimeter = 0;                ///< metres
    double tolerance = 0;                ///< maximum of the elements around it, metres
    bool is_outside = false;             ///< adjacent to the hull, in no room
    std::map<PlanRegion, double> beside; ///< shared length with other regions
  };

  /** @brief Returns the region beyond a side of a triangle. */
  PlanRegion across(std::uint32_t t, std::size_t side) const
  {
    const std::uint32_t n = plan_.triangulation.neighbours[t][side];
    return n == none ? PlanRegion() : region_[n];
  }

  /** @brief Returns the minimum distance of ceiling and floor: a millimetre, more only
   * on a coarse grid. */
  double minClearance() const { return 20 * solidSeparation(plan_.grid); }

  /** @brief Returns sets of triangles connected by sides with `alike(t, u)`. */
  template <typename Alike>
  std::vector<Part> partsOf(Alike alike) const
  {
    std::vector<Part> parts;
    std::vector<bool> is_taken(region_.size(), false);
    for (std::uint32_t first = 0; first < region_.size(); ++first) {
      if (is_taken[first])
        continue;
      Part part;
      part.region = region_[first];
      part.triangles.push_back(first);
      is_taken[first] = true;
      for (std::size_t k = 0; k < part.triangles.size(); ++k) {
        const std::uint32_t t = part.triangles[k];
        part.area += plan_.areaOf(t);
        for (std::size_t i = 0; i < 3; ++i) {
          const std::uint32_t n = plan_.triangulation.neighbours[t][i];
          if (n == none || !alike(region_[t], region_[n]))
            measure(part, t, i);
          else if (!is_taken[n]) {
            is_taken[n] = true;
            part.triangles.push_back(n);
          }
        }
      }
      parts.push_back(std::move(part));
    }
    return parts;
  }

  std::vector<Part> regions() const
  {
    return partsOf([](const PlanRegion& a, const PlanRegion& b) { return a == b; });
  }

  void measure(Part& part, std::uint32_t t, std::size_t side) const
  {
    const double length =
        plan_.grid.unit() *
        distance(plan_.arrangement.vertices[plan_.corner(t, side)],
                 plan_.arrangement.vertices[plan_.corner(t, side + 1)]);
    part.perimeter += length;
    part.beside[across(t, side)] += length;
    if (plan_.triangulation.neighbours[t][side] == none)
      part.is_outside = !part.region.isRoom();
    for (const SegmentUse& use : plan_.usesAt(t, side))
      part.tolerance =
          std::max(part.tolerance, plan_.tolerance[plan_.sources[use.segment].element]);
  }

  /** @brief Returns the region that absorbs a sliver: the room region with the longest
   * common edge; `nothing` if there is none. */
  static PlanRegion heirOf(const Part& part)
  {
    PlanRegion heir;
    double longest = 0;
    for (const auto& [region, length] : part.beside)
      if (region.isRoom() && length > longest) {
        heir = region;
        longest = length;
      }
    return heir;
  }

  /** @brief Returns the shorter side of the rectangle of the same area and perimeter.
   */
  static double widthOf(const Part& part)
  {
    const double sides = part.perimeter / 2;
    return (sides - std::sqrt(std::max(sides * sides - 4 * part.area, 0.0))) / 2;
  }

  void assign(const Part& part, const PlanRegion& region)
  {
    for (const std::uint32_t t : part.triangles)
      region_[t] = region;
  }

  /** @brief Returns the mean of the corners of a part's triangles, in plan. */
  Eigen::Vector2d middleOf(const Part& part) const
  {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const std::uint32_t t : part.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        sum += plan_.grid.toPlan(plan_.arrangement.vertices[plan_.corner(t, i)]);
    return sum / (3 * static_cast<double>(part.triangles.size()));
  }

  /** @brief Returns the minimum height of a part's ceiling above its floor, metres. */
  double clearance(const Part& part) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t t : part.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        least =
            std::min(least, plan_.heightOf(part.region.ceiling, plan_.corner(t, i)) -
                                plan_.heightOf(part.region.floor, plan_.corner(t, i)));
    return least;
  }

  /** @brief Returns whether `holds(region, vertex)` is true at both ends of a side of a
   * part for the part of the room beyond it. */
  template <typename Holds>
  bool holdsBeside(const Part& part, Holds holds) const
  {
    for (const std::uint32_t t : part.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        if (const PlanRegion other = across(t, i); other.isRoom() &&
                                                   holds(other, plan_.corner(t, i)) &&
                                                   holds(other, plan_.corner(t, i + 1)))
          return true;
    return false;
  }

  /** @brief Returns whether a part's floor meets a neighbour's ceiling along an edge,
   * or vice versa. */
  bool touchesBeside(const Part& part) const
  {
    const auto meets = [&](int PlanRegion::*slab, int PlanRegion::*beyond) {
      return holdsBeside(part, [&](const PlanRegion& other, std::uint32_t v) {
        return std::abs(plan_.heightOf(part.region.*slab, v) -
                        plan_.heightOf(other.*beyond, v)) < minClearance();
      });
    };
    return meets(&PlanRegion::floor, &PlanRegion::ceiling) ||
           (plan_.layers.isNiche(part.region) &&
            meets(&PlanRegion::ceiling, &PlanRegion::floor));
  }

  /** @brief Returns whether a part is open to a neighbouring part of the room. */
  bool isOpen(const Part& part) const
  {
    return holdsBeside(part, [&](const PlanRegion& other, std::uint32_t v) {
      // An earlier niche is open itself, or is left out before the next round.
      return (!plan_.layers.isNiche(other) || other.floor < part.region.floor) &&
             std::min(plan_.heightOf(part.region.ceiling, v),
                      plan_.heightOf(other.ceiling, v)) -
                     std::max(plan_.heightOf(part.region.floor, v),
                              plan_.heightOf(other.floor, v)) >
                 minClearance();
    });
  }

  /** @brief Returns why a part cannot be built, or empty. */
  std::string problemOf(const Part& part) const
  {
    if (!part.region.isRoom())
      return {};
    const double height = clearance(part);
    if (height < minClearance())
      return formatText("the ceiling there would lie %.3f m %s the floor",
                        std::abs(height), height < 0 ? "below" : "above");
    if (plan_.layers.isNiche(part.region) && !isOpen(part))
      return "it is not open to the room";
    if (part.region != plan_.layers.plainRegions(part.region).front() &&
        touchesBeside(part))
      return "floor and ceiling would meet beside it";
    return {};
  }

  const TriangulatedPlan& plan_;
  std::vector<PlanRegion> region_; ///< per triangle
};

} // namespace

void
findRegions(const TriangulatedPlan& plan,
            PlanSubdivision& subdivision,
            std::vector<PlanWarning>& warnings)
{
  PlanCells cells(plan);
  cells.mergeSlivers();
  cells.dropUnbuildable(warnings);
  cells.checkPieces(warnings);
  for (const PlanSquare& square : plan.squares)
    cells.unify(square);
  subdivision.vertices = plan.arrangement.vertices;
  subdivision.edges = cells.edges();
  subdivision.creases = cells.creases();
}

} // namespace pcl::sedr
