// SPDX-License-Identifier: BSD-3-Clause
#include "square_surfaces.h"

#include <pcl/sedr_filters/cell_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>

namespace pcl::sedr {

namespace {

using OfSides = std::array<bool, 2>; ///< right and left of a face

/** @brief A cell of a face. */
struct FaceCell {
  Cell at;
  OfSides beside{}; ///< whether there are points beside the face
};

/** @brief A row or a column of cells, and what there is on one side of the face. */
struct FaceStrip {
  double seen = 0;                ///< cells with points
  double filled = 0;              ///< cells with points beside the face
  double across = 0;              ///< sum of the shares of the strips across these
  std::array<double, 3> depths{}; ///< points at each depth

  /** @brief Share of its cells with points beside the face; at a corner of what was
   * seen, where it has next to none, of half a strip. */
  double share(double half) const { return filled / std::max(half, seen); }

  /** @brief Whether there are points at every depth, along a decimetre at least, and
   * half as many across it at most. */
  bool isSquare(double decimetre, double half, const Priors& priors) const
  {
    return *std::min_element(depths.begin(), depths.end()) >= priors.min_evidence &&
           filled >= decimetre && across <= priors.share_half * share(half) * filled;
  }
};

/** @brief The cells of a face with points. */
class FaceCells {
public:
  FaceCells(const std::vector<FacePlace>& places, double farthest, const Priors& priors)
      : places_(places)
      , farthest_(farthest)
      , priors_(priors)
      , grid_(priors.evidence_cell / 5) // the noise of a surface
      , decimetre_(priors.evidence_cell / grid_.size())
      , of_strip_(static_cast<std::int32_t>(std::ceil(priors.patch / grid_.size())))
  {
    for (const FacePlace& p : places) {
      const Cell at = grid_.at(p.x(), p.y());
      const auto number =
          numbers_.emplace(keyOf(at), static_cast<std::uint32_t>(cells_.size()));
      if (number.second) {
        cells_.emplace_back();
        cells_.back().at = at;
      }
      of_place_.push_back(number.first->second);
      if (isBeside(p))
        cells_[of_place_.back()].beside[p.z() < 0 ? 0 : 1] = true;
    }
  }

  /** @brief One of each place: whether something stands square to its cell. */
  std::vector<std::uint8_t> areSquare() const
  {
    std::vector<std::uint8_t> are_cells(cells_.size(), 0);
    for (const std::size_t side : {0, 1}) {
      Strips rows = stripsOf(side, true);
      Strips columns = stripsOf(side, false);
      for (const FaceCell& cell : cells_)
        if (cell.beside[side]) {
          FaceStrip& row = rows.at(keyIn(cell.at, true));
          FaceStrip& column = columns.at(keyIn(cell.at, false));
          row.across += column.share(half());
          column.across += row.share(half());
        }
      mark(rows, side, true, are_cells);
      mark(columns, side, false, are_cells);
    }
    std::vector<std::uint8_t> are;
    are.reserve(of_place_.size());
    for (const std::uint32_t cell : of_place_)
      are.push_back(are_cells[cell]);
    return are;
  }

private:
  using Strips = std::unordered_map<CellKey, FaceStrip>;

  double half() const { return of_strip_ / 2.0; } ///< cells of half a strip

  bool isBeside(const FacePlace& p) const
  {
    return std::abs(p.z()) >= priors_.wall_band && std::abs(p.z()) < farthest_;
  }

  CellKey keyIn(const Cell& at, bool is_row) const
  {
    const auto stripOf = [&](std::int32_t cell) {
      return cell < 0 ? (cell + 1) / of_strip_ - 1 : cell / of_strip_;
    };
    return is_row ? keyOf({stripOf(at.x), at.y}) : keyOf({at.x, stripOf(at.y)});
  }

  Strips stripsOf(std::size_t side, bool is_row) const
  {
    Strips strips;
    for (const FaceCell& cell : cells_) {
      FaceStrip& strip = strips[keyIn(cell.at, is_row)];
      strip.seen += 1;
      strip.filled += cell.beside[side] ? 1 : 0;
    }
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const FacePlace& p = places_[i];
      if (!isBeside(p) || (p.z() < 0) != (side == 0))
        continue;
      auto& depths = strips[keyIn(cells_[of_place_[i]].at, is_row)].depths;
      const double share =
          (std::abs(p.z()) - priors_.wall_band) / (farthest_ - priors_.wall_band);
      depths[std::min(
          depths.size() - 1,
          static_cast<std::size_t>(share * static_cast<double>(depths.size())))] += 1;
    }
    return strips;
  }

  /** @brief Marks the cells of square strips within half a decimetre, along the strip,
   * of one with points beside the face. */
  void mark(const Strips& strips,
            std::size_t side,
            bool is_row,
            std::vector<std::uint8_t>& are_cells) const
  {
    const auto near = static_cast<std::int32_t>(decimetre_ / 2);
    for (const FaceCell& cell : cells_)
      if (cell.beside[side] &&
          strips.at(keyIn(cell.at, is_row)).isSquare(decimetre_, half(), priors_))
        for (std::int32_t off = -near; off <= near; ++off) {
          const auto other =
              numbers_.find(keyOf(is_row ? Cell{cell.at.x + off, cell.at.y}
                                         : Cell{cell.at.x, cell.at.y + off}));
          if (other != numbers_.end())
            are_cells[other->second] = 1;
        }
  }

  const std::vector<FacePlace>& places_;
  double farthest_;
  const Priors& priors_;
  CellGrid grid_;
  double decimetre_;      ///< cells of an evidence cell
  std::int32_t of_strip_; ///< cells of a strip
  std::unordered_map<CellKey, std::uint32_t> numbers_;
  std::vector<FaceCell> cells_;
  std::vector<std::uint32_t> of_place_;
};

} // namespace

std::vector<std::uint8_t>
areOnSquareSurfaces(const std::vector<FacePlace>& places,
                    double farthest,
                    const Priors& priors)
{
  return FaceCells(places, farthest, priors).areSquare();
}

} // namespace pcl::sedr
