# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Uses an installed prefix (install.cmake) from outside: by find_package, by pkg-config
# with the bare compiler, and by calling its programs.
# cmake -DPREFIX=prefix -DWORK=folder -DCXX=c++ -DLIBDIR=lib -DPKG_CONFIG=pkg-config -P run.cmake
cmake_minimum_required(VERSION 3.16)
include(${CMAKE_CURRENT_LIST_DIR}/run_command.cmake)

set(source ${CMAKE_CURRENT_LIST_DIR})
set(prefix ${PREFIX})
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

message(STATUS "find_package")
set(with_surface OFF)
if(EXISTS ${prefix}/${LIBDIR}/cmake/pcl_ops/pcl_ops-surface-targets.cmake)
  set(with_surface ON)
endif()
run(${CMAKE_COMMAND} -S ${source} -B ${WORK}/build -DWITH_SURFACE=${with_surface}
  -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${WORK}/build --config Release)
find_program(consumer consumer PATHS ${WORK}/build ${WORK}/build/Release NO_DEFAULT_PATH)
run(${consumer})
find_program(core_consumer core_consumer
  PATHS ${WORK}/build ${WORK}/build/Release NO_DEFAULT_PATH)
run(${core_consumer})
execute_process(COMMAND ldd ${core_consumer} OUTPUT_VARIABLE loaded)
if(loaded MATCHES "libpcl")
  message(FATAL_ERROR "a program with the core alone loads\n${loaded}")
endif()
if(with_surface)
  find_program(surface_consumer surface_consumer
    PATHS ${WORK}/build ${WORK}/build/Release NO_DEFAULT_PATH)
  run(${surface_consumer})
endif()

# The first block of code of that language.
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
execute_process(COMMAND ${PKG_CONFIG} --cflags --libs pcl_ops
  OUTPUT_VARIABLE flags RESULT_VARIABLE result OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "pkg-config does not find pcl_ops in ${prefix}")
endif()
separate_arguments(flags UNIX_COMMAND "${flags}")
run(${CXX} -O2 ${source}/consumer.cpp -o ${WORK}/consumer ${flags})
set(ENV{LD_LIBRARY_PATH} "${prefix}/${LIBDIR}:$ENV{LD_LIBRARY_PATH}")
run(${WORK}/consumer)

set(ENV{LD_LIBRARY_PATH} "")
file(GLOB programs ${prefix}/bin/*)
foreach(program ${programs})
  run(${program} --version)
endforeach()
