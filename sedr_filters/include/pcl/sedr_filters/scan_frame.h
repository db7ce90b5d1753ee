// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief The origin of the coordinates of a scan or model, given in the frame of the
 * input, such as a national grid; metres. It is subtracted in double precision before
 * coordinates become floats, which resolve only 0.5 m at 5,000 km from 0.
 * @code
 * const pcl::sedr::Origin origin{{691600, 5335900, 0}};
 * const Eigen::Vector3f p = origin.toLocal({691612.25, 5335907.5, 1.2}).cast<float>();
 * @endcode */
struct Origin {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();

  /** @brief Checks whether coordinates are those of the scan as given. */
  bool isZero() const;

  /** @brief Converts a place of the given frame to local coordinates. */
  Eigen::Vector3d toLocal(const Eigen::Vector3d& p) const;

  /** @brief Converts a place in local coordinates to the given frame. */
  Eigen::Vector3d toGiven(const Eigen::Vector3d& p) const;

  /** @brief Returns text such as "691600 5335900 0", to the micrometre. */
  std::string text(const std::string& separator = " ") const;

  /** @brief Reads three finite numbers, separated by blanks or commas.
   * @return whether the text is that and nothing else */
  static bool fromText(const std::string& text, Origin& origin);

  /** @brief Returns the comment line written to PCD, PLY, OBJ and DXF files:
   * "sedr_origin 691600 5335900 0". */
  std::string comment() const { return "sedr_origin " + text(); }

  /** @brief Reads the text of comment() from the end of a line.
   * @return whether the line ends in one */
  static bool fromComment(const std::string& line, Origin& origin);
};

bool operator==(const Origin& a, const Origin& b);

inline bool
operator!=(const Origin& a, const Origin& b)
{
  return !(a == b);
}

/** @brief A level frame of a building's own: what is found on grids in it does not
 * depend on where and how a scan lies. A rigid transformation from the frame of the
 * scan; metres. See findBuildingFrame(). */
struct BuildingFrame {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< the place that becomes 0

  Eigen::Vector3d toBuilding(const Eigen::Vector3d& p) const;
  Eigen::Vector3d toScan(const Eigen::Vector3d& p) const;

  /** @brief Returns the transformation from this frame to another one of the same scan.
   */
  BuildingFrame to(const BuildingFrame& other) const;

  /** @brief Returns the angle about z by which a level frame turns plans, radians. */
  double yaw() const { return std::atan2(rotation(1, 0), rotation(0, 0)); }
};

/** @brief The rotation that makes a tilted scan level. Its centre `about` is a place of
 * the scan, so points far from the origin do not move far; metres. */
struct Levelling {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d about = Eigen::Vector3d::Zero();

  /** @brief Returns the smallest rotation that turns the direction `up` to z. */
  static Levelling of(const Eigen::Vector3d& up, const Eigen::Vector3d& about);

  /** @brief Maps a place of the scan into the levelled frame. */
  Eigen::Vector3d level(const Eigen::Vector3d& p) const;

  /** @brief Maps a place of the levelled frame back into the scan. */
  Eigen::Vector3d back(const Eigen::Vector3d& p) const;

  /** @brief Returns the same as a rigid transformation. */
  BuildingFrame frame() const { return {rotation, back(Eigen::Vector3d::Zero())}; }

  /** @brief Returns the angle between the scan's vertical and z, radians. */
  double angle() const { return std::acos(std::clamp(rotation(2, 2), -1.0, 1.0)); }

  /** @brief Returns the direction of the tilt in plan, radians from x. */
  double direction() const { return std::atan2(rotation(2, 1), rotation(2, 0)); }
};

/** @brief A scanner position and the first of the points measured from it. */
struct ScanPosition {
  /// First of these points; they end before `first_row` of the next position.
  std::size_t first_row = 0;
  /// Metres, in the frame of the points; NaN if the position is unknown.
  Eigen::Vector3f place = Eigen::Vector3f::Zero();

  bool isKnown() const;
};

/** @brief The scanner positions of all points of a scan, by increasing `first_row`;
 * empty if nothing is known. */
using ScanPositions = std::vector<ScanPosition>;

/** @brief Returns the index of the scanner position of a row; positions.size() for rows
 * before the first position. O(log n) for n positions. */
inline std::size_t
positionOfRow(const ScanPositions& positions, std::size_t row)
{
  const auto after = std::upper_bound(positions.begin(), positions.end(), row,
                                      [](std::size_t r, const ScanPosition& position) {
                                        return r < position.first_row;
                                      });
  return after == positions.begin()
             ? positions.size()
             : static_cast<std::size_t>(after - positions.begin()) - 1;
}

} // namespace pcl::sedr
