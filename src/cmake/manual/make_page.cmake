# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Makes a manual page of a program or of one of its commands:
# cmake -DPROGRAM=file -DCOMMAND=command -DNAME=page -DSUMMARY=line -DPAGE=file.1.gz
#   -DHELP2MAN=help2man -DGZIP=gzip -P make_page.cmake
cmake_minimum_required(VERSION 3.16)

# Runs a command with its output in a file.
function(run output)
  execute_process(COMMAND ${ARGN} OUTPUT_FILE ${output} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "no manual page of ${PROGRAM}: ${result}")
  endif()
endfunction()

get_filename_component(folder ${PAGE} DIRECTORY)
file(MAKE_DIRECTORY ${folder})
set(raw ${folder}/${NAME}.1)
# The page has --help-all of programs that have it, as their --help is short.
set(help_option --help)
execute_process(COMMAND ${PROGRAM} --help-all
  RESULT_VARIABLE has_no_long_help OUTPUT_QUIET ERROR_QUIET)
if("${COMMAND}" STREQUAL "" AND has_no_long_help EQUAL 0)
  set(help_option --help-all)
endif()
run(${raw} ${HELP2MAN} --no-info --section=1 "--name=${SUMMARY}" --help-option=${help_option}
  --include=${CMAKE_CURRENT_LIST_DIR}/common.h2m "${PROGRAM} ${COMMAND}")

# help2man calls the page after the program: of a command, put the whole name instead. Dates
# become year-month-day, as usual in manual pages.
file(READ ${raw} text)
get_filename_component(program ${PROGRAM} NAME)
string(TOUPPER ${program} program_title)
string(TOUPPER ${NAME} title)
string(TIMESTAMP date "%Y-%m-%d" UTC)
string(REGEX REPLACE "\n\\.TH ${program_title} \"1\" \"[^\"]*\""
  "\n.TH ${title} \"1\" \"${date}\"" text "${text}")
string(REPLACE "\n${program} \\- " "\n${NAME} \\- " text "${text}")
file(WRITE ${raw} "${text}")
run(${PAGE} ${GZIP} -9nc ${raw})
file(REMOVE ${raw})
