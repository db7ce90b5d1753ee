# SPDX-License-Identifier: BSD-3-Clause
# A build from nothing: the headers of Eigen, PCL and GoogleTest take most of the time of most
# files. They are compiled once for libraries and programs and once for tests, and sources are
# compiled together: those of a folder, or a number of them.

# With its default settings ccache does not keep what was compiled with precompiled headers: turn
# this off to work with it.
option(SEDR_FAST_BUILD "Compile headers once and folders as one file" ON)

include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=mold SEDR_HAS_MOLD) # it links in a fifth of the time
if(SEDR_FAST_BUILD AND SEDR_BUILD_TESTS AND SEDR_HAS_MOLD)
  add_link_options(-fuse-ld=mold)
endif()

# sedr_precompile_headers(name HEADERS more... LINK ...) compiles headers for those who reuse them.
# They are a target without definitions of its own: those must be the same wherever they are used.
function(sedr_precompile_headers name)
  if(NOT SEDR_FAST_BUILD)
    return()
  endif()
  cmake_parse_arguments(ARG "" "" "HEADERS;LINK" ${ARGN})
  add_library(${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/headers.cpp)
  target_include_directories(${name} SYSTEM PRIVATE ${PCL_INCLUDE_DIRS})
  target_link_libraries(${name} PRIVATE ${ARG_LINK})
  target_compile_options(${name} PRIVATE -fPIC -pthread)
  sedr_set_warnings(${name})
  target_precompile_headers(${name} PRIVATE
    <algorithm> <cmath> <functional> <map> <memory> <sstream> <string> <vector>
    <Eigen/Core> <Eigen/Geometry> <pcl/point_cloud.h> <pcl/point_types.h> ${ARG_HEADERS})
endfunction()

# sedr_build_fast(target [HEADERS name] [BATCH files]) reuses the headers of that name, else those of
# libraries and programs, and compiles the sources of each folder, or a number of them, as one file.
# Names in unnamed namespaces are therefore unique there; that a name of another file is shadowed
# says nothing.
function(sedr_build_fast target)
  if(NOT SEDR_FAST_BUILD)
    return()
  endif()
  cmake_parse_arguments(ARG "" "BATCH;HEADERS" "" ${ARGN})
  if(NOT ARG_HEADERS)
    set(ARG_HEADERS common_headers)
  endif()
  target_compile_options(${target} PRIVATE -fPIC -pthread -Wno-shadow)
  target_precompile_headers(${target} REUSE_FROM ${ARG_HEADERS})
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON)
  if(ARG_BATCH)
    set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE ${ARG_BATCH})
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(folder ${source} DIRECTORY)
    string(MAKE_C_IDENTIFIER "folder_${folder}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()
