# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# The names, summaries and descriptions of the packages that cpack makes. Those of the source
# package of Debian are in src/packaging/debian/control.
pcl_ops_add_library_package(pcl_ops library
  SUMMARY "fast plane detection in unorganized point clouds for PCL"
  DESCRIPTION "pcl_ops finds all planes of a point cloud in one call: floors, walls, table
tops and boards, each with the points that lie on it. It has Oriented Point
Sampling, Fast Sampling Plane Filtering and the 3D Kernel-based Hough
Transform, as classes in the style of the Point Cloud Library.
.
This package has the shared library.")

set(libraries library) # the components of shared libraries
if(TARGET pcl_ops_surface)
  list(APPEND libraries surface)
  pcl_ops_add_library_package(pcl_ops_surface surface
    COMPONENTS library
    SUMMARY "outlines and meshes of the planes pcl_ops finds"
    DESCRIPTION "pcl_ops finds all planes of a point cloud in one call. This part of it turns
them into surfaces: outlines with holes, and triangles.
.
This package has the shared library.")
endif()

if(TARGET pcl_ops_buildings)
  list(APPEND libraries buildings)
  pcl_ops_add_library_package(pcl_ops_buildings buildings
    COMPONENTS library
    SUMMARY "kinds of planes and floor plans for pcl_ops"
    DESCRIPTION "pcl_ops finds all planes of a point cloud in one call. This part of it says
what they are in a building: floors, ceilings, walls, roofs. It makes walls
parallel and orthogonal, and draws floor plans.
.
This package has the shared library.")
endif()

pcl_ops_add_package(dev NAME libpcl-ops-dev SECTION libdevel
  DEPENDS libpcl-dev
  COMPONENTS ${libraries}
  SUMMARY "fast plane detection in point clouds for PCL (development files)"
  DESCRIPTION "pcl_ops finds all planes of a point cloud in one call: floors, walls, table
tops and boards, each with the points that lie on it.
.
This package has what programs that use it are built with: the headers, the
CMake package and the pkg-config file.")

set(lab "")
if(PCL_OPS_BUILD_LAB)
  set(lab "
.
pcl_ops_simulate makes rooms as a depth camera sees them, with their true
planes; pcl_ops_evaluate and pcl_ops_benchmark measure how good and how fast
plane detectors are.")
endif()
pcl_ops_add_package(tools NAME pcl-ops-tools SECTION science
  COMPONENTS ${libraries}
  SUMMARY "find the planes of a point cloud (command line programs)"
  DESCRIPTION "pcl_ops_segment labels every point of a .pcd, .ply or .las file with the plane
it lies on and writes the planes and a picture of them; pcl_ops_evaluate
compares results.${lab}")

if(TARGET pcl_ops_view)
  pcl_ops_add_package(view NAME pcl-ops-view SECTION science
    COMPONENTS ${libraries}
    SUMMARY "look at the planes of a point cloud (viewer)"
    DESCRIPTION "pcl_ops_view shows a point cloud by its planes, in a window. It has a package
of its own because it needs VTK.")
endif()

if(TARGET pcl_ops_python)
  # The module works with one minor version of Python alone.
  string(REGEX MATCH "([0-9]+)\\.([0-9]+)" version ${PCL_OPS_PYTHON_VERSION})
  math(EXPR next_minor "${CMAKE_MATCH_2} + 1")
  set(next_version ${CMAKE_MATCH_1}.${next_minor})
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${pcl_ops_debian_dir}/prerm)
  pcl_ops_add_package(python NAME python3-pcl-ops SECTION python
    DEPENDS "python3 (>= ${version}), python3 (<< ${next_version}), python3-numpy"
    COMPONENTS library
    SUMMARY "fast plane detection in point clouds (Python 3 module)"
    DESCRIPTION "pcl_ops finds all planes of a point cloud in one call: floors, walls, table
tops and boards, each with the points that lie on it.
.
This package has the module for Python: numpy arrays in, labels and planes
out.")
endif()
