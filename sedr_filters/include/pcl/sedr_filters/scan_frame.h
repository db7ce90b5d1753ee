// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The place that the coordinates of a scan or a model are counted from, in the
 * frame that the scan was given in, such as that of a national grid; metres. It is
 * subtracted in double precision before coordinates become floats, which 5,000 km from
 * 0 resolve no finer than 0.5 m.
 * @code
 * const pcl::sedr::Origin origin{{691600, 5335900, 0}};
 * const Eigen::Vector3f p = origin.toLocal({691612.25, 5335907.5, 1.2}).cast<float>();
 * @endcode
 */
struct Origin {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();

  /** @brief Whether coordinates are those of the scan as it was given. */
  bool isZero() const { return place.isZero(0); }

  /** @brief A place of the given frame, counted from here. */
  Eigen::Vector3d toLocal(const Eigen::Vector3d& p) const { return p - place; }

  /** @brief A place counted from here, in the given frame. */
  Eigen::Vector3d toGiven(const Eigen::Vector3d& p) const { return p + place; }

  /** @brief "691600 5335900 0", to the micrometre. */
  std::string text(const std::string& separator = " ") const;

  /** @brief Reads three finite numbers, parted by blanks or commas.
   * @return whether the text is that and no more */
  static bool fromText(const std::string& text, Origin& origin);

  /** @brief "sedr_origin 691600 5335900 0": what the comments of PCD, PLY, OBJ and DXF
   * files say. */
  std::string comment() const { return "sedr_origin " + text(); }

  /** @brief Reads comment() from a line, whatever stands before it.
   * @return whether the line ends in one */
  static bool fromComment(const std::string& line, Origin& origin);
};

inline bool
operator==(const Origin& a, const Origin& b)
{
  return a.place == b.place;
}

inline bool
operator!=(const Origin& a, const Origin& b)
{
  return !(a == b);
}

/** @brief The turn that makes a tilted scan level, about a place of it, so that far
 * from the origin nothing moves far; metres. */
struct Levelling {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d about = Eigen::Vector3d::Zero();

  /** @brief The least turn that brings the direction `up` to z. */
  static Levelling of(const Eigen::Vector3d& up, const Eigen::Vector3d& about);

  /** @brief A place of the scan in the levelled frame. */
  Eigen::Vector3d level(const Eigen::Vector3d& p) const
  {
    return rotation * (p - about) + about;
  }

  /** @brief A place of the levelled frame in that of the scan. */
  Eigen::Vector3d back(const Eigen::Vector3d& p) const
  {
    return rotation.transpose() * (p - about) + about;
  }

  /** @brief Between the scan's up and z, radians. */
  double angle() const { return std::acos(std::clamp(rotation(2, 2), -1.0, 1.0)); }

  /** @brief Direction in plan in which the scan's up is tilted, radians from x. */
  double direction() const { return std::atan2(rotation(2, 1), rotation(2, 0)); }
};

/** @brief A place that some points of a scan were taken from. */
struct ScanPosition {
  /// Number of the first of these points; the last is before that of the next position.
  std::size_t first_row = 0;
  /// Metres, in the frame of the points; NaN where the place is not known.
  Eigen::Vector3f place = Eigen::Vector3f::Zero();

  bool isKnown() const { return place.allFinite(); }
};

/** @brief Where all points of a scan were taken from, by increasing `first_row`; empty
 * where nothing is known. */
using ScanPositions = std::vector<ScanPosition>;

/** @brief Number of the position that a row was taken from; of rows before the first
 * position it is positions.size(). O(log n) for n positions. */
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

} // namespace sedr
} // namespace pcl
