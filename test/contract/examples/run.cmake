# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Runs an example on a cloud and compares its output with a regular expression.
# cmake -DPROGRAM=file -DCLOUD=room.pcd -DEXPECTED=expression -P run.cmake
cmake_minimum_required(VERSION 3.16)
execute_process(COMMAND ${PROGRAM} ${CLOUD}
  RESULT_VARIABLE result OUTPUT_VARIABLE output)
message(STATUS "${output}")
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} failed: ${result}")
endif()
if(NOT output MATCHES "${EXPECTED}")
  message(FATAL_ERROR "the output of ${PROGRAM} does not match ${EXPECTED}")
endif()
