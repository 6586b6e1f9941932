# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Debian packages by cpack; scripts/package makes and checks them. This file is included
# before GNUInstallDirs; pcl_ops_make_packages is called after all targets.
option(PCL_OPS_DEBIAN_PACKAGES "Build for Debian packages, which cpack then makes" OFF)
if(PCL_OPS_DEBIAN_PACKAGES)
  # With the prefix /usr GNUInstallDirs chooses Debian's library folder, which the loader
  # searches without run paths. CGAL's GPL parts would change the license of the packages.
  set(CMAKE_INSTALL_PREFIX /usr CACHE PATH "Install prefix" FORCE)
  set(CMAKE_SKIP_INSTALL_RPATH ON)
  set(PCL_OPS_WITH_CGAL OFF)
  find_program(PCL_OPS_GZIP gzip REQUIRED)
  find_program(PCL_OPS_HELP2MAN help2man REQUIRED)
endif()
set(pcl_ops_soversion ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
# Lower than 1, the first revision of a package by Debian, which then replaces these.
set(pcl_ops_debian_version ${PROJECT_VERSION}-0upstream1)
set(pcl_ops_debian_dir ${CMAKE_CURRENT_LIST_DIR}/debian)

# Sets result to the name of the package of a shared library, by Debian's policy 8.1.
function(pcl_ops_library_package library result)
  string(REPLACE "_" "-" name "lib${library}${pcl_ops_soversion}")
  set(${result} ${name} PARENT_SCOPE)
endfunction()

# Installs a file in a package's documentation folder, compressed as Debian's policy asks.
function(pcl_ops_install_compressed source name package component)
  set(compressed ${CMAKE_CURRENT_BINARY_DIR}/debian/${name}.gz)
  execute_process(COMMAND ${PCL_OPS_GZIP} -9nc ${source} OUTPUT_FILE ${compressed}
    COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${compressed} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
    COMPONENT ${component})
endfunction()

# Writes the copyright and the changelog of the packages.
function(pcl_ops_write_debian_texts)
  # The text of the license, without title and authors, in the syntax of control files: a
  # space before each line, and a dot in each empty line.
  file(READ ${PROJECT_SOURCE_DIR}/LICENSE license)
  string(REGEX REPLACE "^.*authors\n\n" "" license "${license}")
  string(REGEX REPLACE "\n+$" "" license "${license}")
  string(REPLACE "\n\n" "\n.\n" license "${license}")
  string(REPLACE "\n" "\n " license "${license}")
  configure_file(${pcl_ops_debian_dir}/copyright.in debian/copyright @ONLY)
  # SOURCE_DATE_EPOCH, where it is set, makes the packages repeatable.
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
  configure_file(${pcl_ops_debian_dir}/changelog.in debian/changelog.Debian @ONLY)
endfunction()

# Makes one component a package of its own:
# pcl_ops_add_package(component NAME name SECTION section SUMMARY line DESCRIPTION text
#   DEPENDS packages of Debian  COMPONENTS components of the project that it needs)
macro(pcl_ops_add_package component)
  cmake_parse_arguments(ARG "" "NAME;SECTION;SUMMARY;DESCRIPTION;DEPENDS" "COMPONENTS" ${ARGN})
  string(TOUPPER ${component} key)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_COMPONENT_${key}_DEPENDS ${ARG_COMPONENTS})
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${ARG_NAME})
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${ARG_SECTION})
  set(CPACK_DEBIAN_${key}_PACKAGE_DEPENDS ${ARG_DEPENDS})
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${ARG_SUMMARY}\n${ARG_DESCRIPTION}")
  set(docs ${CMAKE_INSTALL_DATADIR}/doc/${ARG_NAME})
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/debian/copyright
    DESTINATION ${docs} COMPONENT ${component})
  pcl_ops_install_compressed(${CMAKE_CURRENT_BINARY_DIR}/debian/changelog.Debian
    changelog.Debian ${ARG_NAME} ${component})
  pcl_ops_install_compressed(${PROJECT_SOURCE_DIR}/CHANGELOG.md
    changelog ${ARG_NAME} ${component})
endmacro()

# Makes the component of a shared library a package, named after the library.
macro(pcl_ops_add_library_package target component)
  pcl_ops_library_package(${target} package)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA ${pcl_ops_debian_dir}/triggers)
  pcl_ops_add_package(${component} NAME ${package} SECTION libs ${ARGN})
endmacro()

function(pcl_ops_make_packages)
  if(NOT PCL_OPS_DEBIAN_PACKAGES)
    return()
  endif()
  pcl_ops_write_debian_texts()
  include(${pcl_ops_debian_dir}/packages.cmake)

  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_NAME pcl-ops)
  set(CPACK_PACKAGE_VENDOR "The pcl_ops authors")
  set(CPACK_PACKAGE_CONTACT "The pcl_ops authors <maintainers@pcl-ops.example>")
  # Empty, so that each package begins with a summary of its own.
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
  set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_STRIP_FILES ON)
  # Whatever the user's umask is, all users can read the folders.
  set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  # A package for each component, which depends on those of the components it needs.
  set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
  set(CPACK_DEBIAN_PACKAGE_SOURCE pcl-ops)
  set(CPACK_DEBIAN_PACKAGE_VERSION ${pcl_ops_debian_version})
  set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
  # dpkg-shlibdeps finds what packages the linked libraries are in; it looks for the project's own
  # in the folders of the build.
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS
    ${PROJECT_BINARY_DIR}/src ${PROJECT_BINARY_DIR}/src/surface ${PROJECT_BINARY_DIR}/src/buildings)
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
  set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
  set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_POST_BUILD_SCRIPTS ${pcl_ops_debian_dir}/drop_ldconfig.cmake)
  include(CPack)
endfunction()
