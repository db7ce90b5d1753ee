// SPDX-License-Identifier: BSD-3-Clause
#include "opening_search.h"

#include "sedr_filters/src/base/quantiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace pcl::sedr {
namespace {

/** @brief An edge of a rectangle, seen from its inside: positions grow outwards. */
struct EdgeFrame {
  double sign;     ///< 1: positions grow with the coordinate
  bool is_upright; ///< a jamb: its position is along the wall
  double position; ///< expected, of the outward coordinate
  double low;      ///< extent of the edge, of the other coordinate
  double high;
  double farthest; ///< it may be, where the face goes on, of the outward coordinate

  double outward(const SidePoint& p) const
  {
    return sign * (is_upright ? p.along : p.height);
  }
  double across(const SidePoint& p) const { return is_upright ? p.height : p.along; }
};

struct EdgeFit {
  double position;
  double residual;
  double deviation; ///< distance within which 95 % of what shows it lies
};

/** @brief Fits an edge to the positions of what shows it, around their middle.
 * @param accuracy metres: no edge is known better */
EdgeFit
edgeAt(double position,
       const std::vector<double>& shown,
       double middle,
       double accuracy)
{
  std::vector<double> off;
  for (const double at : shown)
    off.push_back(std::abs(at - middle));
  std::sort(off.begin(), off.end());
  const auto n = static_cast<double>(off.size());
  const auto last = static_cast<std::size_t>(std::ceil(0.95 * n)) - 1;
  const double deviation = off[last];
  return {position, 1.48 * middleValue(std::move(off)) / std::sqrt(n) + accuracy,
          deviation};
}

/** @brief Returns which depths behind the face, in steps of edge_bin, something closes
 * beside an edge, within the opening or beyond it: a leaf, a pane, or a back. It is
 * seen near to the edge and farther from it, as no reveal is. */
std::vector<bool>
closedDepths(const WallMap& map,
             const EdgeFrame& edge,
             bool is_within,
             const OpeningSizes& sizes)
{
  const double step = opening_numbers.edge_bin;
  const double stretch = 2 * map.cell();
  const double half = sizes.edge_reach / 2;
  const auto parts = static_cast<std::size_t>((edge.high - edge.low) / stretch) + 1;
  const auto depths = static_cast<std::size_t>(sizes.max_depth / step) + 1;
  std::vector<std::array<double, 2>> shown(depths * parts);
  for (const SidePoint& p : map.points()) {
    const double away = (is_within ? -1 : 1) * (edge.outward(p) - edge.position) - half;
    const double along = edge.across(p) - edge.low;
    if (away > 0 && away < 2 * half && along >= 0 && edge.across(p) < edge.high &&
        p.offset <= 0 && -p.offset < sizes.max_depth)
      ++shown[static_cast<std::size_t>(-p.offset / step) * parts +
              static_cast<std::size_t>(along / stretch)][away < half ? 0 : 1];
  }
  std::vector<bool> is_closed;
  for (auto at = shown.begin(); at != shown.end();
       at += static_cast<std::ptrdiff_t>(parts))
    is_closed.push_back(
        static_cast<double>(std::count_if(
            at, at + static_cast<std::ptrdiff_t>(parts), [](const auto& n) {
              return std::min(n[0], n[1]) > 0 &&
                     n[0] + n[1] >= opening_numbers.cell_points;
            })) >= opening_numbers.sure_reveal * static_cast<double>(parts));
  return is_closed;
}

/** @brief Fits the plane of a reveal: the outermost peak of the points that lie just
 * behind the face, spread over the length of the edge.
 * @param closed depths at which something else is seen beside the edge
 * @param deepest of its points behind the face, metres */
std::optional<EdgeFit>
revealOf(const WallMap& map,
         const EdgeFrame& edge,
         const std::vector<bool>& closed,
         double deepest,
         const OpeningSizes& sizes)
{
  const double inset = std::min(0.05, (edge.high - edge.low) / 4);
  const double low = edge.low + inset;
  const double high = edge.high - inset;
  const auto bins =
      static_cast<std::size_t>(2 * sizes.edge_reach / opening_numbers.edge_bin) + 1;
  const double stretch = 2 * map.cell();
  const auto parts = static_cast<std::size_t>((high - low) / stretch) + 1;
  std::vector<std::vector<bool>> shown(bins, std::vector<bool>(parts));
  const auto offsetOf = [&](const SidePoint& p) {
    return edge.outward(p) - (edge.position - sizes.edge_reach);
  };
  std::vector<bool> is_other(closed.size());
  const auto band =
      static_cast<std::size_t>(std::round(map.tolerance() / opening_numbers.edge_bin));
  for (std::size_t k = 0; k < closed.size(); ++k)
    if (closed[k])
      std::fill(is_other.begin() + static_cast<std::ptrdiff_t>(k - std::min(k, band)),
                is_other.begin() + static_cast<std::ptrdiff_t>(
                                       std::min(k + band + 1, is_other.size())),
                true);
  const auto isReveal = [&](const SidePoint& p) {
    const double at = offsetOf(p);
    return p.offset < -map.tolerance() && p.offset > -deepest &&
           p.offset > -map.depthAt(p.along, p.height) + map.tolerance() && at >= 0 &&
           !is_other[static_cast<std::size_t>(-p.offset / opening_numbers.edge_bin)] &&
           edge.outward(p) < edge.farthest && edge.across(p) >= low &&
           edge.across(p) < high;
  };
  for (const SidePoint& p : map.points())
    if (isReveal(p))
      shown[static_cast<std::size_t>(offsetOf(p) / opening_numbers.edge_bin)]
           [static_cast<std::size_t>((edge.across(p) - low) / stretch)] = true;
  // Noise spreads a plane over bins; windows of a few bins hold it.
  const auto reach = static_cast<std::size_t>(
      std::ceil(std::max(0.5 * map.tolerance(), opening_numbers.edge_bin) /
                opening_numbers.edge_bin));
  const auto shareAround = [&](std::size_t b) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < parts; ++k)
      for (std::size_t o = b - std::min(b, reach); o <= std::min(b + reach, bins - 1);
           ++o)
        if (shown[o][k]) {
          ++count;
          break;
        }
    return static_cast<double>(count) / static_cast<double>(parts);
  };
  for (std::size_t b = bins; b-- > 0;) {
    if (shareAround(b) < opening_numbers.min_reveal)
      continue;
    // To the peak; behind a plane that fills the opening there is none.
    for (std::size_t k = 0; k < reach && b > 0; ++k)
      b -= shareAround(b - 1) > shareAround(b) ? 1 : 0;
    double middle = edge.position - sizes.edge_reach +
                    opening_numbers.edge_bin * (static_cast<double>(b) + 0.5);
    const double half = opening_numbers.edge_bin * (static_cast<double>(reach) + 1);
    std::vector<double> at;
    for (int round = 0; round < 4; ++round) { // from the rim of the peak to its middle
      at.clear();
      for (const SidePoint& p : map.points())
        if (isReveal(p) && std::abs(edge.outward(p) - middle) < half)
          at.push_back(edge.outward(p));
      if (at.size() < 5)
        return std::nullopt;
      middle = middleValue(at);
    }
    EdgeFit fit = edgeAt(middle, at, middle, 0.001);
    if (shareAround(b) < opening_numbers.sure_reveal)
      fit.residual = std::hypot(fit.residual, opening_numbers.end_error);
    return fit;
  }
  return std::nullopt;
}

/** @brief Fits the end of what is seen of a surface: the median over stretches of where
 * its points end, or begin where it lies outside of the opening.
 * @param isOn tells which points show it */
template <typename IsOn>
std::optional<EdgeFit>
endOf(const WallMap& map,
      const EdgeFrame& edge,
      const OpeningSizes& sizes,
      bool is_outside,
      const IsOn& isOn)
{
  const double stretch = 2 * map.cell();
  const auto parts = static_cast<std::size_t>((edge.high - edge.low) / stretch) + 1;
  const double nothing = 1e9;
  const double way = is_outside ? 1 : -1;
  std::vector<double> first(parts, nothing);
  std::vector<std::size_t> count(parts);
  for (const SidePoint& p : map.points()) {
    const double beyond = way * (edge.outward(p) - edge.position);
    const double k = (edge.across(p) - edge.low) / stretch;
    if (!isOn(p) || std::abs(beyond) > sizes.edge_reach || k < 0 ||
        k >= static_cast<double>(parts))
      continue;
    const auto part = static_cast<std::size_t>(k);
    first[part] = std::min(first[part], beyond);
    ++count[part];
  }
  std::vector<double> ends;
  double spacing = 0;
  for (std::size_t k = 0; k < parts; ++k)
    if (count[k] > 2) {
      ends.push_back(first[k]);
      spacing += (sizes.edge_reach - first[k]) / static_cast<double>(count[k]);
    }
  if (ends.size() < std::max<std::size_t>(3, parts / 4))
    return std::nullopt;
  spacing /= static_cast<double>(ends.size()); // along the line of a stretch
  const double middle = middleValue(ends);
  if (middle < opening_numbers.edge_bin - sizes.edge_reach)
    return std::nullopt; // it goes on
  return edgeAt(edge.position + way * (middle - std::min(spacing, 0.02)), ends, middle,
                0.002);
}

/** @brief Moves an edge to the plane of its reveal, else to where the face of the wall
 * begins or a leaf ends, the outer one of them. */
void
fitEdge(const WallMap& map,
        const EdgeFrame& edge,
        const OpeningSizes& sizes,
        double& value,
        OpeningEdge& seen,
        double& deviation)
{
  const std::vector<bool> within = closedDepths(map, edge, true, sizes);
  std::vector<bool> closed = closedDepths(map, edge, false, sizes);
  for (std::size_t k = 0; k < closed.size(); ++k)
    closed[k] = closed[k] || within[k];
  const double strip = map.tolerance() + opening_numbers.reveal_strip;
  const auto last = std::find(closed.rbegin(), closed.rend(), true);
  std::optional<EdgeFit> found = revealOf(map, edge, closed, strip, sizes);
  if (!found && last != closed.rend()) // it may lie behind what closes the opening
    found = revealOf(map, edge, closed,
                     strip + opening_numbers.edge_bin *
                                 static_cast<double>(closed.rend() - last),
                     sizes);
  seen = {found ? EdgeSeen::Reveal : EdgeSeen::Nothing, opening_numbers.unseen_error};
  if (!found) {
    // The half of the noise that reveals do not reach.
    found = endOf(map, edge, sizes, true, [&](const SidePoint& p) {
      return p.offset >= 0 && p.offset <= map.tolerance();
    });
    seen.seen = found ? EdgeSeen::Rim : EdgeSeen::Nothing;
    const auto leaf = endOf(map, edge, sizes, false, [&](const SidePoint& p) {
      const double k = -p.offset / opening_numbers.edge_bin;
      return p.offset < -map.tolerance() && k < static_cast<double>(within.size()) &&
             within[static_cast<std::size_t>(k)];
    });
    if (leaf && (!found || leaf->position > found->position)) {
      found = leaf;
      seen.seen = EdgeSeen::Leaf;
    }
  }
  if (!found)
    return;
  value = edge.sign * found->position;
  seen.error = seen.seen == EdgeSeen::Reveal
                   ? found->residual
                   : std::hypot(found->residual, opening_numbers.end_error);
  deviation = std::max(deviation, found->deviation);
}

} // namespace

WallRectangle
fittedEdges(const WallMap& map, const WallRectangle& cells, const OpeningSizes& sizes)
{
  WallRectangle fit = cells;
  const auto move = [&](std::size_t k, double& value, double sign, bool is_upright,
                        double low, double high) {
    EdgeFrame edge{sign, is_upright, sign * value,
                   low,  high,       sign * value + sizes.edge_reach};
    // Behind the wall beside it, a bar or a pier, lies the reveal of another one.
    for (double out = 0; out < sizes.edge_reach; out += map.cell()) {
      const auto [from, to] =
          std::minmax({value + sign * out, value + sign * (out + map.cell())});
      if ((is_upright ? map.shareOf(WallCell::Seen, from, to, low, high)
                      : map.shareOf(WallCell::Seen, low, high, from, to)) > 0.5) {
        edge.farthest =
            std::min(edge.farthest, sign * value + out + map.cell() + map.tolerance());
        break;
      }
    }
    fitEdge(map, edge, sizes, value, fit.edges[k], fit.deviation);
  };
  const double head = cells.top - cells.rise;
  move(0, fit.from, -1, true, cells.bottom, head);
  move(1, fit.to, 1, true, cells.bottom, head);
  move(2, fit.bottom, -1, false, cells.from, cells.to);
  fit.edges[3].error = opening_numbers.unseen_error; // of an arched head
  if (cells.rise == 0)
    move(3, fit.top, 1, false, cells.from, cells.to);
  if (fit.to - fit.from < sizes.min_width / 2 ||
      fit.top - fit.bottom < sizes.min_height / 2) {
    fit = cells;
    fit.edges.fill({EdgeSeen::Nothing, opening_numbers.unseen_error});
  }
  return fit;
}

} // namespace pcl::sedr
