// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl::sedr::tools {

extern const char* const page_style;  ///< page.css
extern const char* const page_script; ///< page.js

} // namespace pcl::sedr::tools
