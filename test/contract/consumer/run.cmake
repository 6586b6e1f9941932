# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Uses an installed prefix (install.cmake) as users do: by find_package, by pkg-config and a call
# of the compiler, and by calling its programs. LOADER_KNOWS: the dynamic loader searches LIBDIR of
# the prefix by itself, as it does for Debian packages.
# cmake -DPREFIX=prefix -DWORK=folder -DCXX=c++ -DLIBDIR=lib -DPKG_CONFIG=pkg-config
#   [-DLOADER_KNOWS=ON] -P run.cmake
cmake_minimum_required(VERSION 3.16)
include(${CMAKE_CURRENT_LIST_DIR}/run_command.cmake)

set(source ${CMAKE_CURRENT_LIST_DIR})
set(prefix ${PREFIX})
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

message(STATUS "find_package")
set(options_of_parts) # -DWITH_SURFACE=ON and the like
foreach(part surface buildings)
  set(with_${part} OFF)
  if(EXISTS ${prefix}/${LIBDIR}/cmake/pcl_ops/pcl_ops-${part}-targets.cmake)
    set(with_${part} ON)
  endif()
  string(TOUPPER ${part} part_in_capitals)
  list(APPEND options_of_parts -DWITH_${part_in_capitals}=${with_${part}})
endforeach()
run(${CMAKE_COMMAND} -S ${source} -B ${WORK}/build ${options_of_parts}
  -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${WORK}/build --config Release)
find_program(consumer consumer PATHS ${WORK}/build ${WORK}/build/Release NO_DEFAULT_PATH)
run(${consumer})
set(libraries_without_pcl core)
if(with_buildings)
  find_program(buildings_consumer buildings_consumer
    PATHS ${WORK}/build ${WORK}/build/Release NO_DEFAULT_PATH)
  run(${buildings_consumer})
  list(APPEND libraries_without_pcl buildings_core)
endif()
foreach(core ${libraries_without_pcl})
  find_program(${core}_consumer ${core}_consumer
    PATHS ${WORK}/build ${WORK}/build/Release NO_DEFAULT_PATH)
  run(${${core}_consumer})
  execute_process(COMMAND ldd ${${core}_consumer} OUTPUT_VARIABLE loaded)
  if(loaded MATCHES "libpcl")
    message(FATAL_ERROR "a program with the ${core} alone loads\n${loaded}")
  endif()
endforeach()
if(with_surface)
  find_program(surface_consumer surface_consumer
    PATHS ${WORK}/build ${WORK}/build/Release NO_DEFAULT_PATH)
  run(${surface_consumer})
endif()

# Sets result to the text of the first code block of README.md that names this language.
function(block_of_readme language result)
  file(READ ${source}/../../../README.md page)
  string(REGEX MATCH "```${language}\n([^`]*)```" block "${page}")
  set(${result} "${CMAKE_MATCH_1}" PARENT_SCOPE)
endfunction()

message(STATUS "README's program, by README's CMake file")
block_of_readme(cpp program)
block_of_readme(cmake project)
set(readme ${WORK}/readme)
file(WRITE ${readme}/planes.cpp "${program}")
file(WRITE ${readme}/CMakeLists.txt "${project}")
file(WRITE ${readme}/cloud.pcd "VERSION 0.7
FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1
WIDTH 4\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA ascii
0 0 0\n1 0 0\n0 1 0\n1 1 0\n")
run(${CMAKE_COMMAND} -S ${readme} -B ${readme}/build
  -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${readme}/build)
find_program(planes planes PATHS ${readme}/build NO_DEFAULT_PATH)
run(${planes} ${readme}/cloud.pcd)

message(STATUS "pkg-config")
set(ENV{PKG_CONFIG_PATH} "${prefix}/${LIBDIR}/pkgconfig:$ENV{PKG_CONFIG_PATH}")
set(ENV{LD_LIBRARY_PATH} "${prefix}/${LIBDIR}:$ENV{LD_LIBRARY_PATH}")
function(run_by_pkg_config package program)
  execute_process(COMMAND ${PKG_CONFIG} --cflags --libs ${package}
    OUTPUT_VARIABLE flags RESULT_VARIABLE result OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "pkg-config does not find ${package} in ${prefix}")
  endif()
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(${CXX} -O2 ${source}/${program}.cpp -o ${WORK}/${program} ${flags})
  run(${WORK}/${program})
endfunction()
run_by_pkg_config(pcl_ops consumer)
if(with_buildings)
  run_by_pkg_config(pcl_ops_buildings buildings_consumer)
endif()

# Installed programs hold the path of their libraries (RPATH), unless LOADER_KNOWS: then
# LD_LIBRARY_PATH stays set.
if(NOT LOADER_KNOWS)
  set(ENV{LD_LIBRARY_PATH} "")
endif()
file(GLOB programs ${prefix}/bin/*)
foreach(program ${programs})
  run(${program} --version)
endforeach()
