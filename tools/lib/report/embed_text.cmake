# SPDX-License-Identifier: BSD-3-Clause
# Writes OUTPUT, a C++ source with the page's FILES of FOLDER as string literals: page.html becomes page_html.
set(source "#include \"report/page_parts.h\"\n\nnamespace pcl::sedr::tools {\n")
foreach(file ${FILES})
  file(READ ${FOLDER}/${file} text)
  string(REPLACE "." "_" name ${file})
  string(APPEND source "\nconst char* const ${name} = R\"sedr_page(${text})sedr_page\";\n")
endforeach()
file(WRITE ${OUTPUT} "${source}\n} // namespace pcl::sedr::tools\n")
