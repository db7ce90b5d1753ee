// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model_settings.h"

#include <cstddef>
#include <functional>
#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Reads, reconstructs, measures and writes: from a scan to the folder of its
 * model. What fails is a ToolError.
 * @param open gives the chain its scan, and returns how many points that has
 * @return the exit code */
int makeModel(const ModelSettings& settings,
              Reconstruction& chain,
              const std::function<std::size_t()>& open);

} // namespace tools
} // namespace sedr
} // namespace pcl
