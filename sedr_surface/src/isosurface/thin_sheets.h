// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../solver/surface_samples.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Sets the signs of nodes within thin sheets. Where samples less than two cells
 * apart face away from each other, e.g. at a panel between two niches, their
 * contributions cancel in the solved function and leave holes. The nodes near the
 * middle are set to form a sheet without holes, of values below zero. Gaps between
 * samples that face each other are set likewise, with values above zero.
 *
 * The position of the surface follows from the planes of the samples:
 * extractDualSurface().
 *
 * @param samples in blocks of cells of `grid`
 * @param spacing typical distance of neighbouring samples, cells
 * @return the number of nodes whose sign changed
 *
 * O(samples) for a bounded number per block; independent of the number of threads. */
std::size_t keepThinSheets(const BandGrid& grid,
                           const SortedSamples& samples,
                           double spacing,
                           unsigned threads,
                           std::vector<float>& values);

} // namespace pcl::sedr
