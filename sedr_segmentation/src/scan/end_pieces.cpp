// SPDX-License-Identifier: BSD-3-Clause
#include "end_pieces.h"

#include "sedr_filters/src/grids/disjoint_sets.h"
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <map>

namespace pcl::sedr {

namespace {
constexpr float least_step = 0.2F; // metres, of pieces
} // namespace

EndPieces
piecesOf(const std::vector<ColumnGap>& gaps,
         const GapBorders& borders,
         float ColumnGap::*end,
         const Priors& priors)
{
  const float into_air = end == &ColumnGap::low ? 1 : -1;
  float ColumnGap::*const other =
      end == &ColumnGap::low ? &ColumnGap::high : &ColumnGap::low;
  DisjointSets<> sets(gaps.size());
  for (const auto& [a, b] : borders)
    if (std::abs(gaps[a].*end - gaps[b].*end) < least_step)
      sets.join(a, b);
  EndPieces pieces;
  pieces.large = 2 * priors.min_slab_area;
  for (auto* sums :
       {&pieces.areas, &pieces.rises, &pieces.borders, &pieces.even_borders})
    sums->assign(gaps.size(), 0);
  for (std::uint32_t i = 0; i < gaps.size(); ++i) {
    pieces.of.push_back(sets.find(i));
    pieces.areas[pieces.of[i]] += air_columns::size * air_columns::size;
  }
  for (const auto& [a, b] : borders) {
    const double step = into_air * (gaps[a].*end - gaps[b].*end);
    const bool is_even = std::abs(gaps[a].*other - gaps[b].*other) < least_step / 2;
    if (pieces.of[a] == pieces.of[b])
      continue;
    for (const auto& [gap, rise] : {std::pair(a, step), std::pair(b, -step)}) {
      pieces.rises[pieces.of[gap]] += rise;
      pieces.borders[pieces.of[gap]] += 1;
      pieces.even_borders[pieces.of[gap]] += is_even ? 1 : 0;
    }
  }
  return pieces;
}

namespace {

/** @brief Returns the place of a column, in cells. */
Eigen::Vector2d
cellOfColumn(std::uint64_t column)
{
  constexpr std::uint64_t mask = (std::uint64_t{1} << air_columns::bits) - 1;
  return {static_cast<double>(column >> air_columns::bits),
          static_cast<double>(column & mask)};
}

/** @brief Returns the column at a place in cells. */
std::uint64_t
columnAtCell(const Eigen::Vector2d& place)
{
  return static_cast<std::uint64_t>(std::lround(place.x())) << air_columns::bits |
         static_cast<std::uint64_t>(std::lround(place.y()));
}

/** @brief The box about a piece along its main axes, in cells. */
struct PieceBox {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  Eigen::Matrix2d axes;        ///< columns: across the piece, along it
  Eigen::AlignedBox2d extents; ///< along the axes

  explicit PieceBox(const std::vector<ColumnGap>& gaps)
  {
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const ColumnGap& gap : gaps)
      middle += cellOfColumn(gap.column) / static_cast<double>(gaps.size());
    for (const ColumnGap& gap : gaps) {
      const Eigen::Vector2d place = cellOfColumn(gap.column) - middle;
      spread += place * place.transpose();
    }
    axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors();
    for (const ColumnGap& gap : gaps)
      extents.extend(axes.transpose() * (cellOfColumn(gap.column) - middle));
  }

  double length() const { return air_columns::size * (extents.sizes().y() + 1); }
};

/** @brief Returns whether the air goes on beyond an end of a piece, deeper than above
 * it: within 0.25 m of more than half of the end's width. */
bool
isFreeAt(const std::vector<ColumnGap>& gaps,
         const ColumnGap& piece,
         const PieceBox& box,
         bool at_far_end,
         float ColumnGap::*end)
{
  const double last = at_far_end ? box.extents.max().y() : box.extents.min().y();
  int free = 0;
  int all = 0;
  for (double across = box.extents.min().x(); across <= box.extents.max().x();
       ++across, ++all) {
    bool is_free = false;
    for (const double beyond : {1.5, 2.5}) {
      const Eigen::Vector2d place =
          box.middle +
          box.axes * Eigen::Vector2d(across, last + (at_far_end ? beyond : -beyond));
      const std::uint64_t column = columnAtCell(place);
      for (auto gap = std::lower_bound(gaps.begin(), gaps.end(), column, isBefore);
           gap != gaps.end() && gap->column == column; ++gap)
        is_free = is_free || (gap->low < piece.high && piece.low < gap->high &&
                              std::abs((*gap).*end - piece.*end) >= least_step &&
                              ((*gap).*end < piece.*end) == (end == &ColumnGap::low));
    }
    free += is_free ? 1 : 0;
  }
  return 2 * free > all;
}

/** @brief Returns the mean step of a piece into the air from what is beside it. */
double
stepOf(const EndPieces& pieces, std::uint32_t piece)
{
  return pieces.rises[piece] / std::max(1.0, pieces.borders[piece]);
}

/** @brief Returns whether a piece may be furniture, a beam or the like. Where the other
 * end of the air has steps as well, it is a window, or a place outdoors. */
bool
isThing(const EndPieces& pieces, std::uint32_t piece, const Priors& priors)
{
  const double step = stepOf(pieces, piece);
  return step > 0 && step < priors.min_headroom &&
         pieces.areas[piece] < priors.max_furniture_area &&
         2 * pieces.even_borders[piece] >= pieces.borders[piece];
}

/** @brief Counts a thing as one that stands free, or as a bar from wall to wall. What
 * leaves the headroom of a doorway may hang as well, lower things do not; a bar above
 * the head of a doorway may be a desk or a kerb below a high ceiling: a third each. */
void
addThing(const std::vector<ColumnGap>& gaps,
         const EndPieces& pieces,
         const std::vector<std::uint32_t>& members,
         float ColumnGap::*end,
         const Priors& priors,
         ThingCounts& counts)
{
  constexpr double whole_thing = 0.2; // square metres; smaller ones count less
  constexpr double high_lintel = 2.3; // metres
  std::vector<ColumnGap> things;
  for (const std::uint32_t i : members)
    things.push_back(gaps[i]);
  const auto middle = things.begin() + static_cast<std::ptrdiff_t>(things.size() / 2);
  std::nth_element(
      things.begin(), middle, things.end(),
      [end](const ColumnGap& a, const ColumnGap& b) { return a.*end < b.*end; });
  const PieceBox box(things);
  const std::uint32_t piece = pieces.of[members.front()];
  const double count = std::min(1.0, std::pow(pieces.areas[piece] / whole_thing, 2));
  const double headroom = middle->high - middle->low;
  const bool has_headroom = headroom >= priors.min_headroom;
  const bool is_free = isFreeAt(gaps, *middle, box, false, end) ||
                       isFreeAt(gaps, *middle, box, true, end);
  if (is_free && stepOf(pieces, piece) >= priors.max_step_height)
    counts.things += has_headroom ? count / 3 : count;
  else if (!is_free && has_headroom &&
           pieces.areas[piece] <= priors.max_wall * box.length())
    counts.bars += headroom > high_lintel ? count / 3 : count;
}

} // namespace

ThingCounts
thingsOf(const std::vector<ColumnGap>& gaps,
         const EndPieces& pieces,
         float ColumnGap::*end,
         const Priors& priors)
{
  std::map<std::uint32_t, std::vector<std::uint32_t>> members;
  for (std::uint32_t i = 0; i < gaps.size(); ++i)
    if (isThing(pieces, pieces.of[i], priors))
      members[pieces.of[i]].push_back(i);
  ThingCounts counts;
  for (const auto& of_piece : members)
    addThing(gaps, pieces, of_piece.second, end, priors, counts);
  return counts;
}

} // namespace pcl::sedr
