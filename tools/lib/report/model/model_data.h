// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "results/ceiling_rule.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief A mesh as the page's script reads it, a JSON object without any "<":
 *
 * `vertices` and `triangles` are counts; `positions` three unsigned 16-bit numbers a
 * vertex, the shares of `size` from `low` (metres) in 65535ths; `corners` three 32-bit
 * indices a triangle; `labels`, `rooms` and `ceilings` a byte a triangle; `edges`, and
 * `open_edges` without the ceilings, six 16-bit numbers a line. All are little-endian
 * in base64.
 * @param mesh triangles face into the rooms
 * @param with_edges whether edges of elements are in it */
std::string
modelData(const TriangleMesh& mesh, const CeilingRule& rule, bool with_edges);

} // namespace tools
} // namespace sedr
} // namespace pcl
