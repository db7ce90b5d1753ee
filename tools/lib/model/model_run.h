// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colours/scan_colours.h"
#include "model_settings.h"

#include <cstddef>
#include <functional>

namespace pcl::sedr::tools {

/** @brief Makes a model folder from a scan: reads, reconstructs, measures and writes.
 * Throws ToolError on failure.
 * @param open passes the scan to the chain and returns its number of points
 * @param colours returns those of the surfaces, in the frame of the chain's results;
 * null: those of labels
 * @return the exit code */
int makeModel(const ModelSettings& settings,
              Reconstruction& chain,
              const std::function<std::size_t()>& open,
              const std::function<SurfaceColours()>& colours = nullptr);

/** @brief Does the same without writing, for a process that shares the work of
 * another. */
void helpModel(const ModelSettings& settings,
               Reconstruction& chain,
               const std::function<std::size_t()>& open);

} // namespace pcl::sedr::tools
