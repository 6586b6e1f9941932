# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# How the library is found once installed: by CMake, by pkg-config, by ROS. Components,
# here and in pcl_ops_targets.cmake, are those of the Debian packages: library for what
# programs need to run, dev for what they need to be built, tools for our own.
include(CMakePackageConfigHelpers)

# A library of the project, its shared part in a component of its own, and the export
# set it belongs to.
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
# Exported apart, as the packages of Debian may be missing.
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

# PCL's own .pc files carried its version in their names up to 1.12.
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

# REP 136 and the ament resource index: package.xml and an empty marker.
install(FILES ${PROJECT_SOURCE_DIR}/package.xml
  DESTINATION ${CMAKE_INSTALL_DATADIR}/pcl_ops COMPONENT dev)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/ament_marker "")
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ament_marker
  DESTINATION ${CMAKE_INSTALL_DATADIR}/ament_index/resource_index/packages
  COMPONENT dev RENAME pcl_ops)
