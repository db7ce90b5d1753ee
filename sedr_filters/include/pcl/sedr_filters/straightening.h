// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/wall_tilts.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A wall face that leans, or one beside it that does not and has to stay. */
struct LeaningFace {
  Eigen::Vector2d start = Eigen::Vector2d::Zero(); ///< in plan, at the height `head`
  Eigen::Vector2d end = Eigen::Vector2d::Zero();   ///< likewise
  double run = 0;  ///< metres to the left of the way for a metre up: tan of the tilt
  double low = 0;  ///< z of its foot: what lies lower stays
  double head = 0; ///< z of its top, above which all stays
  double before_start = 0.1; ///< how far beyond its start it reaches, metres
  double beyond_end = 0.1;   ///< how far beyond its end
};

/** @brief The map between space as it was scanned, with walls that lean, and a frame in
 * which these walls are vertical; heights stay.
 *
 * At every height a wall that leans moves to where it is at its head, and what is
 * between it and the walls parallel to it, or a metre and more off, is stretched or
 * squeezed in between, at its ends along the walls that it meets there: they stay
 * planes. So all that is known of vertical walls holds in that frame.
 *
 * @code
 * const Straightening map(leaningFaces(plan, tilts));
 * const Eigen::Vector3d there = map.straighten(p);
 * assert(map.back(there).isApprox(p));
 * @endcode
 *
 * O(n) a point, n faces; the identity without any. */
class Straightening {
public:
  Straightening() = default;
  explicit Straightening(std::vector<LeaningFace> faces);

  bool isIdentity() const { return groups_.empty(); }

  /** @brief A place of the scan in the frame of vertical walls. */
  Eigen::Vector3d straighten(const Eigen::Vector3d& p) const;

  /** @brief A place of that frame in the scan. */
  Eigen::Vector3d back(const Eigen::Vector3d& p) const;

  /** @brief The unit normal in the scan of a surface that has `normal` at `p` in the
   * frame of vertical walls. */
  Eigen::Vector3d normalBack(const Eigen::Vector3d& p,
                             const Eigen::Vector3d& normal) const;

private:
  /** @brief Faces that lean, all about parallel. */
  using Group = std::vector<std::size_t>;

  /** @brief The way that a face's surroundings give way in at one of its ends. */
  struct End {
    double skew = 0;  ///< metres along the face for a metre to its left
    double along = 0; ///< of the face: from there on outwards
  };

  /** @brief The ways of the walls that a face meets at its start and its end. */
  std::array<End, 2> endsOf(std::size_t face) const;

  Eigen::Vector3d
  move(const Group& group, const Eigen::Vector3d& p, bool is_forth) const;

  std::vector<LeaningFace> faces_;
  std::vector<std::array<End, 2>> ends_; ///< of each face
  std::vector<Group> groups_;
};

/** @brief The plan with its walls vertical, each where it is at headOf() its room, and
 * what reaches to them likewise. */
Floorplan straightened(const Floorplan& plan, const WallTilts& tilts);

/** @brief The walls of a plan that lean, and those parallel to them; none if no wall
 * leans. */
std::vector<LeaningFace> leaningFaces(const Floorplan& plan, const WallTilts& tilts);

} // namespace sedr
} // namespace pcl
