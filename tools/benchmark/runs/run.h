// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_row.h"

#include "simulator/scene/scene.h"

#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace pcl::sedr::benchmark {

/** @brief Settings of a run. */
struct RunSettings {
  double noise = 0.001; ///< metres along the ray, for all scanners
  std::uint64_t seed = 1;
  bool with_mesh = true; ///< false: only the structure, which is quicker
  std::size_t rays = 0;  ///< per station; 0: the scene's own number
  unsigned threads = 0;  ///< 0: one per core
  std::filesystem::path
      keep; ///< folder to keep the files of every run in; may be empty
  Priors priors;
  bool tells_positions = false; ///< whether the scanner's positions are known
};

/** @brief Returns the row of a run before it starts: scene, noise, seed and kind. */
RunRow rowOf(const sim::Scene& scene, const RunSettings& settings);

/** @brief Simulates the scene, reconstructs it with the chain's defaults and the given
 * priors, and compares the result with the truth. Nothing is thrown: any failure is
 * recorded in the row. */
RunRow runScene(const sim::Scene& scene, const RunSettings& settings);

} // namespace pcl::sedr::benchmark
