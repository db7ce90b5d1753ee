// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <string>

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

} // namespace sedr
} // namespace pcl
