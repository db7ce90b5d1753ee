// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../solver/surface_samples.h"

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Gives the nodes within thin sheets their sign. Where samples face away from
 * each other less than two cells apart, a panel between two niches say, what they say
 * cancels out in the solved function and leaves a sieve; the nodes about the middle
 * between them become as a sheet without a hole, of values below zero. So do those in
 * gaps as thin, between samples that face each other, of values above zero.
 *
 * Where the surface runs is for the planes of the samples to say: extractDualSurface().
 *
 * @param samples in blocks of cells of `grid`
 * @param spacing typical distance of neighbouring samples, cells
 * @return the number of nodes whose sign changed
 *
 * O(samples), for a bounded number of them in a block; the same for any number of
 * threads. */
std::size_t keepThinSheets(const BandGrid& grid,
                           const SortedSamples& samples,
                           double spacing,
                           unsigned threads,
                           std::vector<float>& values);

} // namespace sedr
} // namespace pcl
