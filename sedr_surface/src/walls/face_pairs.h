// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_walls.h"

#include <map>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A stretch of a face with a face of another room, or of the same one, behind
 * it. */
struct FacePair {
  WallFace face;
  WallFace other;
  Stretch stretch; ///< of the first face
  double thickness = 0;
};

/** @brief A stretch of a face with nothing seen behind it. */
struct FreeFace {
  WallFace face;
  Stretch stretch;
};

/** @brief Which faces of a plan are the two sides of one wall. */
class FacePairs {
public:
  FacePairs(const Floorplan& plan, const WallParameters& parameters);

  /** @brief The pairs with a wall between them. */
  const std::vector<FacePair>& walls() const { return walls_; }

  /** @brief What no face is behind, in the order of the faces. */
  std::vector<FreeFace> freeFaces() const;

private:
  void consider(const WallFace& face, const WallFace& other);
  void pairNearestFirst();

  /** @brief Takes what is free of a stretch of both faces. */
  void take(const FacePair& candidate);

  /** @brief How deep the reveal of a doorway with a lintel is that a face is at the end
   * of, as the rooms were parted at one side of their wall; 0 where it is none. */
  double revealDepth(const WallFace& face, const WallFace& other) const;

  /** @brief Adds the wall of a doorway whose reveal is part of one of two rooms that
   * touch. */
  void addWallOfReveal(FacePair pair);

  /** @brief What a stretch of a face is on the other one. */
  Stretch
  mapped(const WallFace& from, const Stretch& stretch, const WallFace& to) const;

  const Floorplan& plan_;
  WallParameters parameters_;
  std::map<WallFace, std::vector<Stretch>> free_; ///< what is of no wall yet
  std::vector<FacePair> candidates_;
  std::vector<FacePair> walls_;
};

} // namespace sedr
} // namespace pcl
