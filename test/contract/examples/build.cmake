# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Builds the examples against an installed prefix and simulates the room that they run on.
# cmake -DSOURCE=examples -DBUILD=folder -DPREFIX=prefix -DROOM=room.pcd -DCXX=c++
#   -DLAUNCHER=ccache -P build.cmake
cmake_minimum_required(VERSION 3.16)
include(${CMAKE_CURRENT_LIST_DIR}/../consumer/run_command.cmake)

run(${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD}
  -DCMAKE_PREFIX_PATH=${PREFIX} -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
  "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Werror")
run(${CMAKE_COMMAND} --build ${BUILD} --parallel 2)
run(${PREFIX}/bin/pcl_ops_simulate ${ROOM} --organized --quiet)
# A scan of KITTI has points of four numbers of four bytes, x, y, z and intensity, without a header.
# Without its header room.pcd passes for one: its labels are where a scan has intensities.
run(sh -c "LC_ALL=C sed '1,/^DATA binary/d' ${ROOM} > ${BUILD}/room.bin")
