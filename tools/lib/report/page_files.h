// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl::sedr::tools {

// The files of the same names, embedded by embed_text.cmake.
extern const char* const page_html;
extern const char* const page_css;
extern const char* const page_js;
extern const char* const model_js;
extern const char* const texts_js;

} // namespace pcl::sedr::tools
