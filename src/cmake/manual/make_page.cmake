# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# cmake -DPROGRAM=file -DCOMMAND=run -DNAME=page -DSUMMARY=line -DPAGE=file.1.gz
#   -DHELP2MAN=help2man -DGZIP=gzip -P make_page.cmake
cmake_minimum_required(VERSION 3.16)

function(run output)
  execute_process(COMMAND ${ARGN} OUTPUT_FILE ${output} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "no manual page of ${PROGRAM}: ${result}")
  endif()
endfunction()

get_filename_component(folder ${PAGE} DIRECTORY)
file(MAKE_DIRECTORY ${folder})
set(raw ${folder}/${NAME}.1)
# Where --help is short, the page is the long one.
set(help_option --help)
execute_process(COMMAND ${PROGRAM} --help-all
  RESULT_VARIABLE has_no_long_help OUTPUT_QUIET ERROR_QUIET)
if("${COMMAND}" STREQUAL "" AND has_no_long_help EQUAL 0)
  set(help_option --help-all)
endif()
run(${raw} ${HELP2MAN} --no-info --section=1 "--name=${SUMMARY}" --help-option=${help_option}
  --include=${CMAKE_CURRENT_LIST_DIR}/common.h2m "${PROGRAM} ${COMMAND}")

# A page is called by its program, which is not all of the name where there is a command;
# and dates are to have the form that readers of such pages know.
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
