# SPDX-License-Identifier: BSD-3-Clause
# LASzip, which reads LAZ: LASzip::LASzip where its header and its library are found (LASzip_ROOT helps).
find_path(LASzip_INCLUDE_DIR laszip/laszip_api.h)
find_library(LASzip_LIBRARY NAMES laszip laszip3)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LASzip REQUIRED_VARS LASzip_LIBRARY LASzip_INCLUDE_DIR)
mark_as_advanced(LASzip_INCLUDE_DIR LASzip_LIBRARY)
if(LASzip_FOUND AND NOT TARGET LASzip::LASzip)
  add_library(LASzip::LASzip UNKNOWN IMPORTED)
  set_target_properties(LASzip::LASzip PROPERTIES
    IMPORTED_LOCATION "${LASzip_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${LASzip_INCLUDE_DIR}")
endif()
