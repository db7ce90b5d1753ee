# SPDX-License-Identifier: BSD-3-Clause
# One function a kind of target, so that the modules' own lists hold names only.

include(CMakePackageConfigHelpers)
include(SedrFastBuild)

# Warnings of this project only: PCL's and VTK's headers come in as system headers.
function(sedr_set_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow
    -Wnon-virtual-dtor -Woverloaded-virtual $<$<BOOL:${SEDR_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()

# sedr_add_module(filters SOURCES a.cpp b.cpp PUBLIC pcl_common ... PRIVATE ...)
# makes the library sedr_<name>, the target sedr::<name>, its install rules and its pkg-config file.
# What a user of the installed library needs (PCL components, pkg-config modules) is what PUBLIC names.
function(sedr_add_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(target sedr_${name})
  list(TRANSFORM ARG_SOURCES PREPEND src/)
  add_library(${target} SHARED ${ARG_SOURCES})
  add_library(sedr::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_link_libraries(${target} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  sedr_set_warnings(${target})
  sedr_build_fast(${target})

  install(TARGETS ${target} EXPORT sedr_${name}_targets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT sedr_${name}_targets FILE sedr_${name}Targets.cmake NAMESPACE sedr::
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/SEDR)
  install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE.txt DESTINATION ${CMAKE_INSTALL_DOCDIR})

  set(pcl_components ${ARG_PUBLIC})
  list(FILTER pcl_components INCLUDE REGEX "^pcl_")
  list(TRANSFORM pcl_components REPLACE "^pcl_" "")
  set_property(GLOBAL PROPERTY SEDR_PCL_COMPONENTS_OF_${name} "${pcl_components}")

  set(requires ${ARG_PUBLIC})
  list(FILTER requires INCLUDE REGEX "^(pcl|sedr)_")
  list(JOIN requires ", " SEDR_PC_REQUIRES)
  set(SEDR_PC_NAME ${target})
  # The file says where it lies from where it is found, so that a moved installation works.
  file(RELATIVE_PATH SEDR_PC_TO_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/sedr.pc.in ${target}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${target}.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

# sedr_add_tool(name LINK ...) makes the program pcl_<name> from <name>.cpp.
function(sedr_add_tool name)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  add_executable(pcl_${name} ${name}.cpp)
  target_link_libraries(pcl_${name} PRIVATE sedr_tools_common ${ARG_LINK})
  sedr_set_warnings(pcl_${name})
  sedr_build_fast(pcl_${name})
  install(TARGETS pcl_${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endfunction()

# sedr_add_test(name SOURCES ... LINK ... COST seconds FIXTURE ...) makes the GoogleTest program test_<name>.
# Tests of the highest cost begin first, so that none of them is left alone at the end.
function(sedr_add_test name)
  cmake_parse_arguments(ARG "" "COST;FIXTURE" "SOURCES;LINK" ${ARGN})
  add_executable(test_${name} ${ARG_SOURCES})
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/test)
  target_link_libraries(test_${name} PRIVATE ${ARG_LINK} GTest::gtest_main)
  sedr_set_warnings(test_${name})
  sedr_build_fast(test_${name} HEADERS test_headers BATCH 8)
  set(properties PROPERTIES LABELS ${name})
  if(ARG_COST)
    list(APPEND properties COST ${ARG_COST})
  endif()
  if(ARG_FIXTURE)
    list(APPEND properties FIXTURES_REQUIRED ${ARG_FIXTURE})
  endif()
  gtest_discover_tests(test_${name} DISCOVERY_TIMEOUT 60 ${properties})
endfunction()

# The files lie in a folder of their own: CMake looks for packages beside every bin/ of
# PATH, and a build tree has no targets to import.
function(sedr_install_package)
  set(destination ${CMAKE_INSTALL_LIBDIR}/cmake/SEDR)
  foreach(name IN ITEMS filters segmentation surface)
    get_property(SEDR_PCL_COMPONENTS_OF_${name} GLOBAL PROPERTY SEDR_PCL_COMPONENTS_OF_${name})
  endforeach()
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/SEDRConfig.cmake.in
    ${PROJECT_BINARY_DIR}/package/SEDRConfig.cmake INSTALL_DESTINATION ${destination})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/SEDRConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/package/SEDRConfig.cmake
    ${PROJECT_BINARY_DIR}/package/SEDRConfigVersion.cmake DESTINATION ${destination})
endfunction()
