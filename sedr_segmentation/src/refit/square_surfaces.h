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
 * face, in a decimetre or more of the cells of 2 cm of a strip of them along it or up,
 * and half as densely across it at most. The cells within 4 cm of these points along
 * the strip are meant, not the face between them. What is parallel to the face is as
 * dense across, and is none of it. O(n)
 * @param farthest metres off the face up to which all points are known
 * @return one of each place; 1: it does not tell where the face is */
std::vector<std::uint8_t> areOnSquareSurfaces(const std::vector<FacePlace>& places,
                                              double farthest,
                                              const Priors& priors);

} // namespace pcl::sedr
