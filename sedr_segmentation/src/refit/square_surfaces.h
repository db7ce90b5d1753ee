// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A point near a face, unrolled: metres along it, up, and off it. */
using FacePlace = Eigen::Vector3f;

/** @brief Which points lie where something stands square to a face: the reveal of an
 * opening, the ceiling of a niche, a shelf. There, points are at every depth beside the
 * face, in a narrow strip along it or up; on the face they are at one depth. O(n)
 * @return one of each place; 1: it does not tell where the face is */
std::vector<std::uint8_t> areOnSquareSurfaces(const std::vector<FacePlace>& places,
                                              const Priors& priors = {});

} // namespace pcl::sedr
