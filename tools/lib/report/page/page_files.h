// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl {
namespace sedr {
namespace tools {

extern const char* const page_style;  ///< page.css
extern const char* const page_script; ///< page.js

} // namespace tools
} // namespace sedr
} // namespace pcl
