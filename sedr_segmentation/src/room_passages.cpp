// SPDX-License-Identifier: BSD-3-Clause
#include "room_passages.h"

#include <pcl/sedr_filters/middle_value.h>
#include <pcl/sedr_segmentation/cell_count.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

namespace {

/** @brief Thickest wall with a passage in it and widest passage, metres. */
constexpr double thickest_wall = 0.6;
constexpr double widest_passage = 3;

/** @brief What is looked at around the end of a wall, metres. */
constexpr double end_radius = 0.6;

/** @brief The end of a wall. */
struct Jamb {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  Eigen::Vector2d outwards = Eigen::Vector2d::Zero(); ///< away from the wall, length 1
};

/** @brief How far a wall reaches to both sides of a line along it, metres. */
struct Faces {
  double right = 0;
  double left = 0;
};

class PassageFinder {
public:
  PassageFinder(const CellMask& core, const CellGrid& grid, double neck)
      : core_(core)
      , grid_(grid)
      , neck_(neck * grid.size())
      , thickest_(thickest_wall + 2 * neck_ + grid.size())
  {}

  CeilingPassages find() const
  {
    CeilingPassages passages{CellMask(core_.box()), CellMask(core_.box())};
    const std::vector<Jamb> jambs = jambsOf(wallEnds());
    for (std::size_t a = 0; a < jambs.size(); ++a)
      for (std::size_t b = a + 1; b < jambs.size(); ++b)
        if (const auto ends = mouth(jambs[a], jambs[b]))
          addPassage(ends->first, ends->second, passages);
    return passages;
  }

private:
  bool isCeiling(const Eigen::Vector2d& p) const
  {
    return core_.at(grid_.at(p.x(), p.y())) != 0;
  }

  /** @brief What is no ceiling around a cell. */
  struct Rest {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero(); ///< as seen from the cell, metres
    double share = 0;
  };

  Rest restAround(Cell cell) const
  {
    const int reach = cellsFor(end_radius, grid_.size());
    Rest rest;
    int all = 0;
    int count = 0;
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx) {
        if (dx * dx + dy * dy > reach * reach)
          continue;
        ++all;
        if (core_.at({cell.x + dx, cell.y + dy}))
          continue;
        ++count;
        rest.mean += Eigen::Vector2d(dx, dy);
      }
    rest.mean *= grid_.size() / std::max(1, count);
    rest.share = static_cast<double>(count) / all;
    return rest;
  }

  bool isAtCeiling(Cell cell) const
  {
    return core_.at({cell.x + 1, cell.y}) || core_.at({cell.x - 1, cell.y}) ||
           core_.at({cell.x, cell.y + 1}) || core_.at({cell.x, cell.y - 1});
  }

  /** @brief Whether what is no ceiling is on one side only, and not all that side. */
  static bool isEnd(const Rest& rest)
  {
    return rest.mean.norm() >= 0.4 * end_radius && rest.share <= 0.45;
  }

  /** @brief Cells at which a partition ends. */
  CellMask wallEnds() const
  {
    const double reach = std::ceil(thickest_ / 2 / grid_.size());
    const CellMask partitions = subtract(eroded(dilated(core_, reach), reach), core_);
    CellMask ends(core_.box());
    for (std::size_t i = 0; i < partitions.values().size(); ++i)
      if (partitions.values()[i]) {
        const Cell cell = partitions.cellAt(i);
        if (isAtCeiling(cell) && isEnd(restAround(cell)))
          ends.values()[i] = 1;
      }
    return ends;
  }

  std::vector<Jamb> jambsOf(const CellMask& ends) const
  {
    const MaskRegions regions = labelRegions(ends, true);
    std::vector<Jamb> jambs(regions.sizes.size());
    for (std::size_t i = 0; i < regions.label.size(); ++i)
      if (regions.label[i] >= 0) {
        const auto r = static_cast<std::size_t>(regions.label[i]);
        const Cell cell = ends.cellAt(i);
        jambs[r].place += grid_.centre(cell) / static_cast<double>(regions.sizes[r]);
        jambs[r].outwards -= restAround(cell).mean;
      }
    for (Jamb& jamb : jambs)
      jamb.outwards.normalize();
    return jambs;
  }

  /** @brief Where the ceiling begins before each of two jambs that are turned to each
   * other, if it is all that is between them but for some cells in which it was not
   * hit. */
  std::optional<std::pair<Eigen::Vector2d, Eigen::Vector2d>> mouth(const Jamb& a,
                                                                   const Jamb& b) const
  {
    constexpr double least_cosine = 0.5; // 60 degrees
    constexpr double end = 0.3;          // metres in which the walls end
    constexpr double least_seen = 0.8;
    const double length = (b.place - a.place).norm();
    if (!(length > 0))
      return {};
    const Eigen::Vector2d along = (b.place - a.place) / length;
    if (length > widest_passage || a.outwards.dot(along) < least_cosine ||
        b.outwards.dot(along) > -least_cosine)
      return {};
    const double step = grid_.size();
    double first = length;
    double last = 0;
    double seen = 0;
    for (double s = 0; s < length; s += step)
      if (isCeiling(a.place + along * s)) {
        first = std::min(first, s);
        last = s;
        seen += step;
      }
    if (!(last > first) || first > end || last < length - end ||
        seen < least_seen * (last - first))
      return {};
    return std::make_pair<Eigen::Vector2d, Eigen::Vector2d>(a.place + along * first,
                                                            a.place + along * last);
  }

  /** @brief The faces of the wall at a place on the line along it; none where it is
   * thicker than a partition. */
  std::optional<Faces> facesAt(const Eigen::Vector2d& place,
                               const Eigen::Vector2d& left) const
  {
    const double step = grid_.size() / 2;
    const auto reach = [&](const Eigen::Vector2d& side) {
      double s = 0;
      while (s <= thickest_ && !isCeiling(place + side * s))
        s += step;
      return s;
    };
    const Faces faces{reach(-left), reach(left)};
    if (faces.left + faces.right > thickest_)
      return {};
    return faces;
  }

  /** @brief The faces of the wall that ends at a place, if it is one: those of a corner
   * run apart.
   * @param along from the end into the wall, length 1 */
  std::optional<Faces> wallBehind(const Eigen::Vector2d& end,
                                  const Eigen::Vector2d& along) const
  {
    constexpr std::size_t least_steps = 3;
    const Eigen::Vector2d left(-along.y(), along.x());
    const double step = grid_.size();
    std::vector<double> to_right;
    std::vector<double> to_left;
    for (double s = step; s <= thickest_; s += step) {
      const Eigen::Vector2d place = end + along * s;
      if (isCeiling(place))
        break;
      if (const std::optional<Faces> faces = facesAt(place, left)) {
        to_right.push_back(faces->right);
        to_left.push_back(faces->left);
      }
    }
    if (to_right.empty())
      return {};
    const Faces faces{middleValue(to_right), middleValue(to_left)};
    std::size_t steady = 0;
    for (std::size_t i = 0; i < to_right.size(); ++i)
      if (std::abs(to_right[i] - faces.right) <= 1.1 * step &&
          std::abs(to_left[i] - faces.left) <= 1.1 * step)
        ++steady;
    if (steady < least_steps)
      return {};
    return faces;
  }

  /** @brief Marks what is between two ends of walls, if these are in line. */
  void addPassage(const Eigen::Vector2d& from,
                  const Eigen::Vector2d& to,
                  CeilingPassages& passages) const
  {
    constexpr double in_line = 0.15; // metres
    const double length = (to - from).norm();
    const Eigen::Vector2d along = (to - from) / length;
    const std::optional<Faces> ahead = wallBehind(to, along);
    const std::optional<Faces> back = wallBehind(from, -along); // turned about
    if (!ahead || !back || std::abs(back->right - ahead->left) > in_line ||
        std::abs(back->left - ahead->right) > in_line)
      return;
    const double right = (back->left + ahead->right) / 2;
    const double left = (back->right + ahead->left) / 2;
    const Eigen::Vector2d middle = (from + to) / 2;
    const double half = length / 2 + neck_ + 0.1;
    const int reach = cellsFor(half + thickest_, grid_.size());
    const Cell centre = grid_.at(middle.x(), middle.y());
    for (int y = centre.y - reach; y <= centre.y + reach; ++y)
      for (int x = centre.x - reach; x <= centre.x + reach; ++x) {
        const Eigen::Vector2d p = grid_.centre({x, y}) - middle;
        const double aside = along.x() * p.y() - along.y() * p.x();
        if (!core_.isInside({x, y}) || std::abs(along.dot(p)) > half ||
            aside < -right || aside > left)
          continue;
        passages.closed.set({x, y}, 1);
        if (aside > neck_ - right && aside < left - neck_)
          passages.cells.set({x, y}, 1);
      }
  }

  const CellMask& core_;
  const CellGrid& grid_;
  const double neck_;     // metres
  const double thickest_; // of what a wall leaves of the eroded ceiling
};

} // namespace

CeilingPassages
passagesThrough(const CellMask& core, const CellGrid& grid, double neck)
{
  return PassageFinder(core, grid, neck).find();
}

} // namespace sedr
} // namespace pcl
