// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_walls.h"

#include <map>
#include <vector>

namespace pcl::sedr {

/** @brief A stretch of a face that has a face of another room, or of the same one,
 * behind it. */
struct FacePair {
  WallFace face;
  WallFace other;
  Stretch stretch; ///< on the first face
  double thickness = 0;
};

/** @brief A stretch of a face without a known face behind it. */
struct FreeFace {
  WallFace face;
  Stretch stretch;
};

/** @brief Pairs the faces of a plan that are the two sides of one wall. */
class FacePairs {
public:
  FacePairs(const Floorplan& plan, const WallParameters& parameters);

  /** @brief Returns the pairs with a wall between them. */
  const std::vector<FacePair>& walls() const { return walls_; }

  /** @brief Returns the unpaired stretches, in the order of the faces. */
  std::vector<FreeFace> freeFaces() const;

private:
  void consider(const WallFace& face, const WallFace& other);
  /** @brief Returns whether a doorway leads from one face of a pair to the other. */
  bool isOpen(const FacePair& pair) const;

  void pairNearestFirst();

  /** @brief Pairs the free parts of a stretch of both faces. */
  void take(const FacePair& candidate);

  /** @brief Maps a stretch of a face to the other face. */
  Stretch
  mapped(const WallFace& from, const Stretch& stretch, const WallFace& to) const;

  const Floorplan& plan_;
  WallParameters parameters_;
  std::map<WallFace, std::vector<Stretch>> free_; ///< stretches without a wall yet
  std::vector<FacePair> candidates_;
  std::vector<FacePair> walls_;
};

} // namespace pcl::sedr
