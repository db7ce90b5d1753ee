// SPDX-License-Identifier: BSD-3-Clause
#include "facet_choice.h"
#include "sheet_fit.h"

#include "../surface/cell_points.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

bool
isLevelFacet(const FacetChoice& choice, std::int32_t facet)
{
  const PlanSlab& slab = choice.facets[static_cast<std::size_t>(facet)].slab;
  return !slab.curve && isLevel(slab);
}

/** @brief A connected part of the cells of a facet, and the sides of cells around it.
 */
struct Piece {
  std::vector<std::size_t> cells;
  double border = 0; ///< sides beside other facets and walls, as far as not hidden
  double closed = 0; ///< those of them that are closed
  double step = 0;   ///< sum of how much higher the facets beside it are, metres
  double sides = 0;  ///< beside other facets
  std::map<std::int32_t, double> beside; ///< facet, what it costs in the piece
  double gain = 0; ///< what the piece costs less than the best of those would
};

class Pieces {
  using Cells = std::vector<std::size_t>;

public:
  Pieces(const FacetEvidence& evidence, FacetChoice& choice)
      : evidence_(evidence)
      , parameters_(evidence.parameters)
      , grid_(evidence.cells.grid())
      , choice_(choice)
      , label_(choice.label)
  {}

  void run()
  {
    joinEven();
    std::vector<std::vector<std::size_t>> pieces = piecesOf(grid_, label_);
    pieces.erase(std::remove_if(pieces.begin(), pieces.end(),
                                [&](const auto& piece) {
                                  return label_[piece.front()] == FacetSheet::none;
                                }),
                 pieces.end());
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const auto& a, const auto& b) { return a.size() < b.size(); });
    if (pieces.empty())
      return;
    main_ = label_[pieces.back().front()];
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const Piece piece = describe(std::move(pieces[k]));
      if (k + 1 < pieces.size() ? isBuiltSo(piece) : isLargeEnough(piece))
        continue;
      const auto best = bestBeside(piece);
      for (const std::size_t cell : piece.cells)
        label_[cell] = best == piece.beside.end() ? FacetSheet::none : best->first;
    }
  }

private:
  double heightOf(std::int32_t facet, std::size_t cell) const
  {
    return choice_.costs[static_cast<std::size_t>(facet)].height[cell];
  }

  /** @brief Joins level facets that are less than a step apart, the smaller one with
   * the larger, if that is the largest or lies beside it; and those of a floor that
   * sags: with no step along their border, and no height two steps above another. */
  void joinEven()
  {
    choice_.sortBySize();
    std::vector<Cells> cells(choice_.facets.size());
    std::vector<Eigen::AlignedBox1d> heights(choice_.facets.size());
    for (std::size_t cell = 0; cell < label_.size(); ++cell)
      if (const std::int32_t k = label_[cell]; k != FacetSheet::none) {
        cells[static_cast<std::size_t>(k)].push_back(cell);
        heights[static_cast<std::size_t>(k)].extend(
            Eigen::Matrix<double, 1, 1>(heightOf(k, cell)));
      }
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (!isLevelFacet(choice_, static_cast<std::int32_t>(k)))
        continue;
      bool sags = false;
      const auto same = std::find_if(kept.begin(), kept.end(), [&](std::size_t other) {
        const Cells rim = cellsBeside(cells[k], other);
        sags = isStep(k, other, cells[k], cells[k].size());
        return (other == kept.front() || !rim.empty()) &&
               (!sags ||
                (parameters_.is_floor && !isStep(k, other, rim, cells[k].size()) &&
                 heights[other].merged(heights[k]).sizes()[0] <
                     2 * parameters_.min_step));
      });
      if (same == kept.end()) {
        kept.push_back(k);
        continue;
      }
      for (const std::size_t cell : cells[k])
        label_[cell] = static_cast<std::int32_t>(*same);
      if (!sags)
        continue;
      Cells& both = cells[*same];
      both.insert(both.end(), cells[k].begin(), cells[k].end());
      std::sort(both.begin(), both.end());
      heights[*same].extend(heights[k]);
      choice_.facets[*same] = fitFacet(choice_.facets[*same].kind, evidence_, both);
      choice_.costs[*same] = costsOf(choice_.facets[*same].slab, evidence_);
    }
  }

  /** @brief Whether one facet lies a step from another in some cells, or less by no
   * more than plaster strays over the patches of `count` cells. */
  bool
  isStep(std::size_t k, std::size_t other, const Cells& at, std::size_t count) const
  {
    double off = 0;
    for (const std::size_t cell : at)
      off += choice_.costs[other].height[cell] - choice_.costs[k].height[cell];
    const double error = parameters_.unevenness /
                         std::sqrt(evidence_.weight() * static_cast<double>(count));
    return std::abs(off) >=
           (parameters_.min_step - error) * static_cast<double>(at.size());
  }

  /** @brief The cells of some that share a side with those of a facet. */
  Cells cellsBeside(const Cells& cells, std::size_t facet) const
  {
    Cells beside;
    for (const std::size_t cell : cells)
      grid_.forAllSides(cell, [&](std::size_t next) {
        if (label_[next] == static_cast<std::int32_t>(facet))
          beside.push_back(cell);
      });
    return beside;
  }

  /** @brief Whether risers close the step between two heights at the border of two
   * cells, up to the higher one: a duct ends below it. Low steps are closed. */
  bool isClosed(std::size_t cell, std::size_t next, double height, double other) const
  {
    constexpr double below = 0.15; // metres
    const auto& [low, high] = std::minmax(height, other);
    if (high - low < RiserBins::min_step)
      return true;
    return evidence_.risers && evidence_.risers->share(cell, next, low, high) >= 0.5 &&
           (parameters_.is_floor || high - low < 2 * below ||
            evidence_.risers->share(cell, next, high - below, high) > 0);
  }

  Piece describe(std::vector<std::size_t> cells) const
  {
    Piece piece;
    piece.cells = std::move(cells);
    const std::int32_t own = label_[piece.cells.front()];
    for (const std::size_t cell : piece.cells)
      grid_.forAllSides(cell, [&](std::size_t next) {
        const std::int32_t other = label_[next];
        if (other == own)
          return;
        const double height = heightOf(own, cell);
        const bool is_wall = other == FacetSheet::none;
        if (is_wall && (parameters_.is_floor || !isLevelFacet(choice_, own) ||
                        !isLevelFacet(choice_, main_)))
          return;
        if (is_wall && height < heightOf(main_, cell)) { // which goes on above a shelf
          piece.border += evidence_.isSeenBeyond(cell, height) ||
                                  evidence_.isSeenBeyond(next, height)
                              ? 1
                              : 0;
          return;
        }
        const double beside = heightOf(is_wall ? main_ : other, cell);
        if (!is_wall) {
          piece.beside.emplace(other, 0);
          piece.step += beside - height;
          piece.sides += 1;
        }
        const bool is_closed = isClosed(cell, next, height, beside);
        const bool is_hidden =
            !is_wall && !is_closed && beside > height &&
            evidence_.cells.isEmpty(parameters_.is_floor ? cell : next);
        piece.border += is_hidden ? 0 : 1;
        piece.closed += is_closed ? 1 : 0;
      });
    for (auto& [other, cost] : piece.beside)
      cost = costOver(other, piece.cells);
    if (const auto best = bestBeside(piece); best != piece.beside.end())
      piece.gain = best->second - costOver(own, piece.cells);
    return piece;
  }

  double costOver(std::int32_t facet, const std::vector<std::size_t>& cells) const
  {
    double sum = 0;
    for (const std::size_t cell : cells)
      sum += choice_.costs[static_cast<std::size_t>(facet)].cost[cell];
    return sum;
  }

  static std::map<std::int32_t, double>::const_iterator bestBeside(const Piece& piece)
  {
    return std::min_element(
        piece.beside.begin(), piece.beside.end(),
        [](const auto& a, const auto& b) { return a.second < b.second; });
  }

  double areaOf(const Piece& piece) const
  {
    return static_cast<double>(piece.cells.size()) * grid_.size * grid_.size;
  }

  /** @brief Whether a piece lies at a wall, or less than two cells from it. */
  bool isAtWall(const Piece& piece) const
  {
    bool is_at_wall = false;
    for (const std::size_t cell : piece.cells)
      grid_.forAllSides(cell, [&](std::size_t next) {
        grid_.forAllSides(next, [&](std::size_t beyond) {
          is_at_wall = is_at_wall || label_[beyond] == FacetSheet::none;
        });
      });
    return is_at_wall;
  }

  bool isLargeEnough(const Piece& piece) const
  {
    return areaOf(piece) >= parameters_.min_closed_area;
  }

  bool isBuiltSo(const Piece& piece) const
  {
    // What is deeper behind an open border does not hang: its risers were not seen.
    constexpr double depth = 1; // metres
    const double open = (piece.border - 2 * piece.closed) * grid_.size;
    const double patch = parameters_.patch * parameters_.patch;
    if (!isLargeEnough(piece) ||
        (evidence_.risers && piece.gain * patch < open * depth * parameters_.outlier))
      return false;
    if (!isLevelFacet(choice_, main_) ||
        !isLevelFacet(choice_, label_[piece.cells.front()]))
      return true;
    // How far it stands out into the room: lamps, panels, furniture and rugs do.
    const double out =
        (parameters_.is_floor ? -1 : 1) * piece.step / std::max(1.0, piece.sides);
    const bool is_free = !isAtWall(piece) && piece.beside.size() == 1 &&
                         piece.beside.begin()->first == main_;
    return areaOf(piece) >= parameters_.min_free_area || out <= 0 ||
           !(is_free || out < parameters_.min_clear_step);
  }

  const FacetEvidence& evidence_;
  const SheetParameters& parameters_;
  const SheetGrid& grid_;
  FacetChoice& choice_;
  std::vector<std::int32_t>& label_;
  std::int32_t main_ = FacetSheet::none;
};

} // namespace

void
dropPieces(const FacetEvidence& evidence, FacetChoice& choice)
{
  Pieces(evidence, choice).run();
}

void
extendBeams(const FacetEvidence& evidence, FacetChoice& choice)
{
  const CellPoints& cells = evidence.cells;
  const auto row = static_cast<std::size_t>(cells.grid().columns);
  std::vector<std::size_t> sizes(choice.facets.size(), 0);
  for (const std::size_t cell : cells.seen())
    ++sizes[static_cast<std::size_t>(choice.label[cell])];
  const auto main = static_cast<std::int32_t>(
      std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  const auto isHidden = [&](std::size_t cell) {
    return cells.isInside(cell) && cells.isEmpty(cell);
  };
  std::vector<std::int32_t> extended = choice.label;
  for (const std::size_t stride : {std::size_t{1}, -std::size_t{1}, row, -row})
    for (const std::size_t last : cells.seen()) {
      const std::int32_t facet = choice.label[last];
      if (facet == main || !isLevelFacet(choice, facet) || !isHidden(last + stride))
        continue;
      std::size_t length = 0;
      for (std::size_t cell = last; cells.isInside(cell) && choice.label[cell] == facet;
           cell -= stride)
        ++length;
      std::size_t gap = 0;
      std::size_t next = last + stride;
      for (; isHidden(next); next += stride)
        ++gap;
      if (2 * gap <= length && (!cells.isInside(next) || choice.label[next] != main))
        for (std::size_t cell = last + stride; cell != next; cell += stride)
          extended[cell] = facet;
    }
  choice.label = std::move(extended);
}

} // namespace pcl::sedr
