# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Installs a build into the folder PREFIX_before, then renames that folder to PREFIX. A file that
# holds the path of the folder where it was installed does not work after that.
# cmake -DBUILD=build -DPREFIX=prefix -DCONFIG=Release -P install.cmake
cmake_minimum_required(VERSION 3.16)
include(${CMAKE_CURRENT_LIST_DIR}/run_command.cmake)

file(REMOVE_RECURSE ${PREFIX} ${PREFIX}_before)
run(${CMAKE_COMMAND} --install ${BUILD} --config ${CONFIG} --prefix ${PREFIX}_before)
file(RENAME ${PREFIX}_before ${PREFIX})
