# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Installs a build into PREFIX_before and renames that folder to PREFIX: installed files then work
# only if none holds the path it was installed to.
# cmake -DBUILD=build -DPREFIX=prefix -DCONFIG=Release -P install.cmake
cmake_minimum_required(VERSION 3.16)
include(${CMAKE_CURRENT_LIST_DIR}/run_command.cmake)

file(REMOVE_RECURSE ${PREFIX} ${PREFIX}_before)
run(${CMAKE_COMMAND} --install ${BUILD} --config ${CONFIG} --prefix ${PREFIX}_before)
file(RENAME ${PREFIX}_before ${PREFIX})
