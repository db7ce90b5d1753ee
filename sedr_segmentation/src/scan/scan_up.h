// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_tilt.h"
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Evidence that another direction than z is up, or that the scan is inclined.
 */
struct UpDoubt {
  static constexpr double doubtful = 1.3;  ///< nats; few right scans reach it
  static constexpr double certain = 2.303; ///< nats, odds of 10 to 1: it is refused
  static constexpr double max_tilt = 3 * M_PI / 180; ///< of a level scan, radians

  double nats = 0;         ///< log-likelihood of that direction less that of z
  std::string reason;      ///< a sentence with what mends it; empty if none
  ScanTilt tilt;           ///< of the scan, refused above `max_tilt`
  bool is_in_feet = false; ///< as the air along the likeliest direction is
  double feet_nats = 0;    ///< log-likelihood of feet less that of metres
  std::string unit_reason; ///< a sentence with what mends the unit

  bool isDoubtful() const { return nats > doubtful; }
  bool isCertain() const { return nats > certain; }
  bool isInclined() const { return tilt.angle > max_tilt; }
};

/** @brief What of a scan needs no doubt. */
struct KnownOfScan {
  bool up = false;   ///< that z is up, but for a tilt
  bool unit = false; ///< that the unit is the metre
};

/** @brief Returns which of six directions, along the axes of the scan or of its
 * inclination, is most likely up, in metres or in feet, if it is not z.
 *
 * The air along an axis, 1.2 to 12 m of it in columns of 0.1 m, ends at two surfaces.
 * Those across the true axis lie at few heights (each nat of the entropy of heights
 * counts one, storey by storey), in large pieces without steps of 0.2 m (log-odds of
 * the share of pieces of at least 2 square metres), about 2.8 m apart, and show most of
 * the air. Of the two, floors have things on them: small pieces that stand out into the
 * air and do not reach from wall to wall; those that leave no headroom cannot hang.
 * Beams and lintels reach from wall to wall and leave headroom: they are a ceiling's.
 * Smooth relief that things do not explain, such as slopes, vaults and ribs, is that of
 * a ceiling.
 * Scanners stand some 1.6 m above a floor. None of these is certain. Feet are tried as
 * well, unless the unit is known. An inclined scan is certain, see tiltOf(). For
 * thinned points; O(n log n).
 * @param stations where scanners stood, if known
 * @param threads 0: all processors; the result does not depend on it */
UpDoubt doubtOfUp(const PointView& points,
                  const std::vector<int>& indices,
                  const std::vector<Eigen::Vector3d>& stations,
                  unsigned threads = 1,
                  const Priors& priors = {},
                  const KnownOfScan& known = {});

} // namespace pcl::sedr
