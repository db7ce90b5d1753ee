// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_row.h"

#include "simulator/scene/scene.h"

#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace pcl {
namespace sedr {
namespace benchmark {

/** @brief How a scene is run. */
struct RunSettings {
  double noise = 0.001; ///< metres along the ray, for all scanners
  std::uint64_t seed = 1;
  bool with_mesh = true; ///< false: the structure alone, which is quicker
  std::size_t rays = 0;  ///< a station; 0: the scene's own
  unsigned threads = 0;  ///< 0: all processors
  std::filesystem::path
      keep; ///< folder to keep the files of every run in; may be empty
  Priors priors;
};

/** @brief What a run is, before it has run: scene, noise, seed and kind. */
RunRow rowOf(const sim::Scene& scene, const RunSettings& settings);

/** @brief Simulates the scene, reconstructs it with the chain's defaults, but for
 * the priors, and compares the result with the truth. Whatever goes wrong is the row's
 * failure; nothing is thrown. */
RunRow runScene(const sim::Scene& scene, const RunSettings& settings);

} // namespace benchmark
} // namespace sedr
} // namespace pcl
