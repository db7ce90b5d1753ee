// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_columns.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A free stretch of a column of the plan, between two surfaces. */
struct AirGap {
  std::uint32_t column = 0;
  std::int32_t low = 0;     ///< its lowest free voxel: the floor is below
  std::int32_t high = 0;    ///< one above its highest: where the ceiling begins
  bool floor_seen = true;   ///< else its low end was taken from neighbours
  bool ceiling_seen = true; ///< likewise its high end
};

/** @brief What is believed of air in buildings; lengths in metres. */
struct AirParameters {
  double thinnest = 0.15;       ///< lower gaps are noise between two surfaces
  double thinnest_slab = 0.2;   ///< of what is thinner one face was seen
  double headroom = 1.8;        ///< gaps as high as this are air
  double same_ceiling = 0.15;   ///< a ceiling goes on where it rises by less a cell
  double highest_step = 1.2;    ///< floors farther apart are those of different levels
  double same_surface = 0.2;    ///< a surface goes on where it is no farther off
  double walled_share = 0.25;   ///< of a gap's height that is occupied: a wall
  double largest_unseen = 0.25; ///< area over length of edge, of what a scanner sees
                                ///< neither below nor above itself
  double largest_hole = 1.5;    ///< square metres, of a slab; a larger one is a void
  double veil = 0.6;  ///< of the points of a surface: a layer before it that has fewer
                      ///< is none, see withoutVeils()
  int veil_reach = 2; ///< columns around one, where points are counted for that
  unsigned threads = 0;
};

/** @brief The air of a scan: its gaps, linked across the plan (a height field of
 * several layers), where one walks on before where they overlap most: a void over two
 * storeys goes on into the lower as far as one can stand below the slab, the air over
 * the stairs in it above that into the upper. Gaps are sorted by column, in it from
 * below. */
class AirGaps {
public:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
  using Links = std::array<std::uint32_t, 4>;

  /** @brief Finds the gaps of all columns, fills holes, links, and keeps what is air.
   * O(columns + gaps). The same for any number of threads.
   * @param seen the same columns before holes were closed: ceilings that go on in them,
   * into the wedge between a slope and a wall, end the air there
   * @param fine those half as wide, see withoutVeils(); none: there are no veils */
  AirGaps(const VoxelColumns& columns,
          const VoxelColumns& seen,
          const AirParameters& parameters,
          const VoxelColumns* fine = nullptr);

  const VoxelColumns& columns() const { return columns_; }
  const AirParameters& parameters() const { return parameters_; }

  std::size_t size() const { return gaps_.size(); }
  const AirGap& operator[](std::size_t g) const { return gaps_[g]; }

  /** @brief The gap that goes on in plan_directions[d], or `none`. */
  std::uint32_t link(std::size_t g, int d) const
  {
    return links_[g][static_cast<std::size_t>(d)];
  }

  /** @brief Whether there is a drop between a gap and its link in direction d: on both
   * sides one can stand, but the floors are farther apart than steps, as at the edge of
   * a gallery. */
  bool isDrop(std::size_t g, int d) const;

  /** @brief The gap into which one walks in direction d: the link but for drops. */
  std::uint32_t next(std::size_t g, int d) const
  {
    return isDrop(g, d) ? none : link(g, d);
  }

  /** @brief Returns the gap over stairs that one enters from gap g, below a slab, in
   * direction d, and that goes on above the slab; `none` if there is none. */
  std::uint32_t climb(std::size_t g, int d) const;

  /** @brief The gap into which one walks at the corner between directions d and d + 1:
   * both ways round, or `none`. */
  std::uint32_t diagonal(std::size_t g, int d) const;

  /** @brief The gaps of a column are those from first(column) to first(column + 1). */
  std::size_t first(std::uint32_t column) const { return first_[column]; }

  /** @brief Whether one can stand between two heights, in voxels. */
  bool hasHeadroom(std::int32_t low, std::int32_t high) const
  {
    return high - low >= voxels(parameters_.headroom);
  }

  /** @brief Whether one can stand in a gap. */
  bool isTall(const AirGap& gap) const { return hasHeadroom(gap.low, gap.high); }

  /** @brief Height of a gap, metres. */
  double height(std::size_t g) const
  {
    return (gaps_[g].high - gaps_[g].low) * columns_.voxelHeight();
  }

  /** @brief The gap of a column in which another goes on, `none` where there is none:
   * of those that overlap it by half of the lower of both at least one into which one
   * can walk upright on the same floor, else that which does so most. */
  std::uint32_t goingOnFrom(const AirGap& gap, std::uint32_t column) const;

  /** @brief The middle of a gap in plan. */
  Eigen::Vector2d placeOf(std::uint32_t g) const
  {
    return columns_.grid().centre(columns_.cellOf(gaps_[g].column));
  }

  std::uint32_t columnAt(const Eigen::Vector2d& place) const
  {
    return columns_.columnAt(columns_.grid().at(place.x(), place.y()));
  }

  /** @brief The gap at a place in which another goes on, `none` for none. */
  std::uint32_t gapAt(const Eigen::Vector2d& place, const AirGap& like) const
  {
    return goingOnFrom(like, columnAt(place));
  }

  /** @brief Share of the heights [low, high) of a column at which something is. Heights
   * are counted in voxels, in taller steps where the columns are larger because the
   * scan is sparse. 0 for no heights. */
  double occupiedShare(std::uint32_t column, std::int32_t low, std::int32_t high) const;

  /** @brief Floor area of gaps that are no air: within slabs, above suspended
   * ceilings; square metres. */
  double voidArea() const { return void_area_; }

  int voxels(double metres) const
  {
    return static_cast<int>(std::lround(metres / columns_.voxelHeight()));
  }

private:
  void findGaps();
  void followCeilings(const VoxelColumns& seen);
  void closeSlabs();
  void setGaps(std::vector<AirGap> gaps);
  void linkGaps();
  void keepAir();

  const VoxelColumns& columns_;
  AirParameters parameters_;
  std::vector<AirGap> gaps_;
  std::vector<std::uint32_t> first_;
  std::vector<Links> links_;
  double void_area_ = 0;
};

/** @brief The gaps of a scan with those parted that reach through a hole in what was
 * seen of a slab, with headroom on both sides. A hole larger than
 * AirParameters::largest_hole is a void or a stairwell and stays open. O(gaps) for each
 * storey.
 * @return all gaps, not sorted */
std::vector<AirGap> withHolesClosed(const AirGaps& air);

/** @brief The gaps of a scan, those parted by a single surface moved apart to the faces
 * of a slab: where only the ceiling below it was seen, because furniture hid the floor,
 * the air above would reach down to that ceiling. Such places are taken region by
 * region, as a slab has two faces: the one that was seen is that which goes on along
 * the region's rim; without a rim it is a ceiling if ceilings elsewhere are as high,
 * else the region is a gallery. The other face lies as high as most do above or below
 * such a one. A region without any stays as it is. O(gaps).
 * @param air linked
 * @return all gaps, in their order */
std::vector<AirGap> withBothFaces(const AirGaps& air);

} // namespace pcl::sedr
