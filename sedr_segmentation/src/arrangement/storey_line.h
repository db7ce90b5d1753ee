// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../curves/plan_points.h"
#include "../faces/storeys.h"
#include "../proposals/face_proposals.h"

#include "sedr_filters/src/grids/cell_mask.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace pcl::sedr {

/** @brief A line or a circle on which walls of a storey may lie, and where its surface
 * was seen. Lengths in metres, along the curve. */
struct StoreyLine : FaceCurve {
  /** @brief What is on a line where no surface was seen. */
  enum class Between : std::uint8_t {
    Partly, ///< below or above it goes on, as at a window or a door
    Gap,    ///< between two parts of the surface: a passage, a cupboard before it
    Beyond, ///< past an end of the surface
    Nothing ///< none of these: an edge away from the ends of its faces
  };

  bool is_end = false; ///< no surface: a face ends there
  double parameters = 1;
  double near = 0.03; ///< maximum distance of its surfaces
  std::map<std::uint32_t, std::vector<float>>
      seen;                     ///< share explained, by room and bin
  std::vector<float> any;       ///< the most of them
  std::vector<float> height;    ///< share of the height at which it was seen
  std::vector<float> tall;      ///< the same where it reaches up to the ceiling
  std::vector<float> part;      ///< 1 where a sill or lintel lies on it
  std::vector<Between> between; ///< of each bin where it does not reach up
  std::vector<double> edges;    ///< where the surface begins or ends, along the curve

  /** @brief Returns how well a surface is explained at a place; -1 beyond the ends. */
  double seenAt(const Eigen::Vector2d& p) const;

  /** @brief Returns the length on which a surface was seen. */
  double support() const;

  /** @brief Returns the box around it and its surfaces. */
  Eigen::AlignedBox2d box() const;
};

/** @brief The rooms of a storey and what is known of them. */
struct StoreyEvidence {
  const Storey& storey;
  const std::vector<RoomCells>& cells;
  const CellGrid& grid;
  double max_wall;    ///< thickness, metres
  double near = 0.03; ///< distance of surfaces from their line, metres
  RadiusRange radii;  ///< of arcs
  unsigned threads = 1;
};

/** @brief What the rooms of a storey saw, asked line by line. */
class LineEvidence {
public:
  /** @param faces RoomCells::wall_points of the storey's rooms, one after the other;
   * must outlive this. O(cells of the storey + points). */
  LineEvidence(const StoreyEvidence& storey, const FacePlaces& faces);

  /** @brief Finds where each room saw the surface of a line. O(its length + points near
   * it). */
  void observe(StoreyLine& line) const;

  /** @brief Lets a line that was observed go on up to the nearest corners with surfaces
   * of others, hidden for at most 5 m, and observes it again. O(lines). */
  void extendToCorners(const std::vector<StoreyLine>& lines, StoreyLine& line) const;

  /** @brief Finds what is on a line where no surface reaches up to the ceiling. */
  void findBetween(StoreyLine& line) const;

private:
  /** @brief Calls `visit(point, bin of the line, way along it, distance as a share of
   * the line's maximum)` for points on a line, some more
   * than once. */
  template <typename Visitor>
  void forEachOn(const StoreyLine& line, const PlanPoints& points, Visitor visit) const;

  void findHeights(StoreyLine& line) const;
  Cell cellAt(const StoreyLine& line, std::size_t bin) const;
  static bool isIn(const std::vector<CellMask>& masks, Cell cell);

  const StoreyEvidence& storey_;
  const FacePlaces& faces_;
  std::vector<std::uint32_t> wall_rooms_; ///< by place as it was given
  PlanPoints parts_{{}, 1};               ///< RoomCells::part_points of all rooms
  PlanPoints height_points_{{}, 1};       ///< RoomCells::height_points of all rooms
  std::vector<float> heights_;            ///< of them, as they were given
  std::vector<CellMask> opaque_; ///< beside opaque surfaces up to ceilings or beams
  std::vector<CellMask> part_;   ///< beside surfaces below a window or above it
};

} // namespace pcl::sedr
