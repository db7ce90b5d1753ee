# SPDX-License-Identifier: BSD-3-Clause
# The headers of Eigen, PCL and GoogleTest take most of the time of most files: they are compiled
# once for the libraries, once for the programs and once for the tests.

# With its default settings ccache does not keep what was compiled with them.
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
  set(precompiled_by_default OFF)
else()
  set(precompiled_by_default ON)
endif()
option(SEDR_PRECOMPILED_HEADERS "Compile the headers of PCL once: for builds without ccache"
  ${precompiled_by_default})

# sedr_precompile_headers(name HEADERS more... LINK flags...) compiles headers for those who reuse
# them. They are a target without definitions of its own: those must be the same wherever they are used.
function(sedr_precompile_headers name)
  if(NOT SEDR_PRECOMPILED_HEADERS)
    return()
  endif()
  cmake_parse_arguments(ARG "" "" "HEADERS;LINK" ${ARGN})
  add_library(${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/headers.cpp)
  target_include_directories(${name} SYSTEM PRIVATE ${PCL_INCLUDE_DIRS})
  target_link_libraries(${name} PRIVATE ${ARG_LINK})
  target_compile_options(${name} PRIVATE -fPIC)
  sedr_set_warnings(${name})
  target_precompile_headers(${name} PRIVATE
    <algorithm> <cmath> <functional> <map> <memory> <sstream> <string> <vector>
    <Eigen/Core> <Eigen/Geometry> <pcl/point_cloud.h> <pcl/point_types.h> ${ARG_HEADERS})
endfunction()

# sedr_reuse_headers(target FROM name)
function(sedr_reuse_headers target from name)
  if(SEDR_PRECOMPILED_HEADERS)
    target_compile_options(${target} PRIVATE -fPIC)
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()
