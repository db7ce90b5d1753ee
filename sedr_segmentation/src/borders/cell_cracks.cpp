// SPDX-License-Identifier: BSD-3-Clause
#include "cell_cracks.h"

#include "../surface/cell_pieces.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief The four ways along the sides of cells, counter-clockwise from that of x. */
constexpr std::array<CrackVertex, 4> ways{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/** @brief Walks along the sides of cells between pieces. */
class CrackTracer {
public:
  CrackTracer(const SheetGrid& grid, CellCracks& cracks)
      : grid_(grid)
      , cracks_(cracks)
  {}

  void run()
  {
    cracks_.loops.resize(cracks_.first_cell.size());
    for (int y = 0; y <= grid_.rows; ++y)
      for (int x = 0; x <= grid_.columns; ++x)
        for (std::size_t way = 0; way < ways.size(); ++way)
          if (isCrack({x, y}, way) && leftOf({x, y}, way) >= 0 &&
              !isWalked({x, y}, way))
            walk({x, y}, way);
  }

private:
  using Step = std::pair<CrackVertex, std::size_t>; ///< a vertex and the way from it

  std::int32_t pieceAt(int x, int y) const
  {
    return grid_.holds(x, y) ? cracks_.piece[grid_.indexOf(x, y)] : -1;
  }

  std::int32_t leftOf(const CrackVertex& v, std::size_t way) const
  {
    constexpr std::array<CrackVertex, 4> left{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
    return pieceAt(v.x + left[way].x, v.y + left[way].y);
  }

  std::int32_t rightOf(const CrackVertex& v, std::size_t way) const
  {
    return leftOf(v, (way + 3) % 4);
  }

  bool isCrack(const CrackVertex& v, std::size_t way) const
  {
    return leftOf(v, way) != rightOf(v, way);
  }

  bool isWalked(const CrackVertex& v, std::size_t way) const
  {
    return walked_.count({v, way}) > 0;
  }

  bool isNode(const CrackVertex& v) const
  {
    int cracks = 0;
    for (std::size_t way = 0; way < ways.size(); ++way)
      cracks += isCrack(v, way) ? 1 : 0;
    return cracks != 2;
  }

  /** @brief Goes once round a piece, which is on the left: at a corner of two pieces
   * that touch there only, it stays with its own. */
  void walk(CrackVertex v, std::size_t way)
  {
    const std::int32_t own = leftOf(v, way);
    std::vector<Step> steps;
    while (!isWalked(v, way)) {
      walked_[{v, way}] = true;
      steps.emplace_back(v, way);
      v = {v.x + ways[way].x, v.y + ways[way].y};
      for (const std::size_t turn : {1U, 0U, 3U}) {
        const std::size_t next = (way + turn) % 4;
        if (leftOf(v, next) == own && isCrack(v, next)) {
          way = next;
          break;
        }
      }
    }
    // From a node on, if there is one.
    const auto node = std::find_if(steps.begin(), steps.end(), [&](const Step& step) {
      return isNode(step.first);
    });
    if (node != steps.end())
      std::rotate(steps.begin(), node, steps.end());
    std::vector<ChainUse> loop;
    for (std::size_t first = 0; first < steps.size();) {
      std::size_t last = first + 1;
      while (last < steps.size() && !isNode(steps[last].first))
        ++last;
      loop.push_back(useOf(steps, first, last));
      first = last;
    }
    cracks_.loops[static_cast<std::size_t>(own)].push_back(std::move(loop));
  }

  /** @brief The chain of some steps, which is new or that of the piece beyond. */
  ChainUse useOf(const std::vector<Step>& steps, std::size_t first, std::size_t last)
  {
    CrackChain chain;
    for (std::size_t k = first; k < last; ++k) {
      chain.vertices.push_back(steps[k].first);
      // The same side of cells, walked from its other end.
      const CrackVertex end{steps[k].first.x + ways[steps[k].second].x,
                            steps[k].first.y + ways[steps[k].second].y};
      const auto known = chain_of_.find({end, (steps[k].second + 2) % 4});
      if (known != chain_of_.end())
        return {known->second, false};
    }
    const Step& final = steps[last - 1];
    chain.vertices.push_back(
        {final.first.x + ways[final.second].x, final.first.y + ways[final.second].y});
    chain.left = leftOf(steps[first].first, steps[first].second);
    chain.right = rightOf(steps[first].first, steps[first].second);
    for (std::size_t k = first; k < last; ++k)
      chain_of_[steps[k]] = cracks_.chains.size();
    cracks_.chains.push_back(std::move(chain));
    return {cracks_.chains.size() - 1, true};
  }

  const SheetGrid& grid_;
  CellCracks& cracks_;
  std::map<Step, bool> walked_;
  std::map<Step, std::size_t> chain_of_;
};

} // namespace

CellCracks
cracksOf(const SheetGrid& grid, const std::vector<std::int32_t>& label)
{
  CellCracks cracks;
  cracks.piece.assign(grid.count(), -1);
  for (const std::vector<std::size_t>& cells : piecesOf(grid, label)) {
    for (const std::size_t cell : cells)
      cracks.piece[cell] = static_cast<std::int32_t>(cracks.first_cell.size());
    cracks.first_cell.push_back(cells.front());
  }
  CrackTracer(grid, cracks).run();
  return cracks;
}

} // namespace pcl::sedr
