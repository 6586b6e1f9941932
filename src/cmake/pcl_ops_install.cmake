# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Installs the library so that CMake, pkg-config and ROS find it. Components, here and in
# pcl_ops_targets.cmake, are those of the Debian packages: "library" has what programs need
# to run, "dev" what they need to be built, and "tools" the programs of the project.
include(CMakePackageConfigHelpers)

# Installs a library of the project as part of an export set: a shared library in the given
# component, a static one and the link to the shared one in dev.
function(pcl_ops_install_library target component export)
  install(TARGETS ${target} EXPORT ${export}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
      COMPONENT ${component} NAMELINK_COMPONENT dev
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${component})
endfunction()

pcl_ops_install_library(pcl_ops library pcl_ops-targets)
pcl_ops_install_library(pcl_ops_core dev pcl_ops-targets)
install(TARGETS pcl_ops_headers EXPORT pcl_ops-targets)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/pcl_ops
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev
  FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp" PATTERN "surface" EXCLUDE PATTERN "buildings" EXCLUDE)

set(pcl_ops_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/pcl_ops)
install(EXPORT pcl_ops-targets NAMESPACE pcl_ops::
  DESTINATION ${pcl_ops_cmake_dir} COMPONENT dev)
# Parts of their own, each with an export set: their Debian packages may be missing.
foreach(part surface buildings)
  if(TARGET pcl_ops_${part})
    pcl_ops_install_library(pcl_ops_${part} ${part} pcl_ops-${part}-targets)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/pcl_ops/${part}
      DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pcl_ops COMPONENT dev)
    install(EXPORT pcl_ops-${part}-targets NAMESPACE pcl_ops::
      DESTINATION ${pcl_ops_cmake_dir} COMPONENT dev)
  endif()
endforeach()
if(TARGET pcl_ops_buildings)
  pcl_ops_install_library(pcl_ops_buildings_core dev pcl_ops-buildings-targets)
endif()
configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/pcl_ops-config.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/pcl_ops-config.cmake
  INSTALL_DESTINATION ${pcl_ops_cmake_dir})
write_basic_package_version_file(
  ${CMAKE_CURRENT_BINARY_DIR}/pcl_ops-config-version.cmake
  VERSION ${PROJECT_VERSION}
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/pcl_ops-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/pcl_ops-config-version.cmake
  DESTINATION ${pcl_ops_cmake_dir} COMPONENT dev)

# Up to 1.12 the names of PCL's .pc files have its version.
set(pcl_pc_suffix "")
if(PCL_VERSION VERSION_LESS 1.13)
  set(pcl_pc_suffix "-${PCL_VERSION_MAJOR}.${PCL_VERSION_MINOR}")
endif()
list(TRANSFORM pcl_ops_pcl_targets APPEND "${pcl_pc_suffix}" OUTPUT_VARIABLE pcl_pc_names)
list(JOIN pcl_pc_names " " PCL_OPS_PC_REQUIRES)
set(PCL_OPS_PC_LIBS_PRIVATE ${CMAKE_THREAD_LIBS_INIT})
foreach(dir LIBDIR INCLUDEDIR)
  file(RELATIVE_PATH PCL_OPS_PC_${dir} ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_${dir}})
endforeach()
file(RELATIVE_PATH PCL_OPS_PC_TO_PREFIX
  ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(${CMAKE_CURRENT_LIST_DIR}/pcl_ops.pc.in pcl_ops.pc @ONLY)
set(pcl_ops_pc_files ${CMAKE_CURRENT_BINARY_DIR}/pcl_ops.pc)
if(TARGET pcl_ops_buildings)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/pcl_ops_buildings.pc.in pcl_ops_buildings.pc @ONLY)
  list(APPEND pcl_ops_pc_files ${CMAKE_CURRENT_BINARY_DIR}/pcl_ops_buildings.pc)
endif()
install(FILES ${pcl_ops_pc_files}
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)

# ROS finds the package by package.xml (REP 136) and an empty file in the index of ament.
install(FILES ${PROJECT_SOURCE_DIR}/package.xml
  DESTINATION ${CMAKE_INSTALL_DATADIR}/pcl_ops COMPONENT dev)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/ament_marker "")
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ament_marker
  DESTINATION ${CMAKE_INSTALL_DATADIR}/ament_index/resource_index/packages
  COMPONENT dev RENAME pcl_ops)
