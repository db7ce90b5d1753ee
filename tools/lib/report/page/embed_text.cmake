# SPDX-License-Identifier: BSD-3-Clause
# Writes OUTPUT, a C++ source with the files page.css and page.js of FOLDER as string literals.
file(READ ${FOLDER}/page.css css)
file(READ ${FOLDER}/page.js js)
file(WRITE ${OUTPUT} "// Made from tools/lib/report/page/page.css and page.js by embed_text.cmake.
#include \"report/page/page_files.h\"

namespace pcl {
namespace sedr {
namespace tools {

const char* const page_style = R\"sedr_page(${css})sedr_page\";

const char* const page_script = R\"sedr_page(${js})sedr_page\";

} // namespace tools
} // namespace sedr
} // namespace pcl
")
