# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Manual pages, made from --help if help2man is installed.
find_program(PCL_OPS_HELP2MAN help2man)
find_program(PCL_OPS_GZIP gzip)
mark_as_advanced(PCL_OPS_HELP2MAN PCL_OPS_GZIP)
set(pcl_ops_manual_dir ${CMAKE_CURRENT_LIST_DIR}/manual)

# Adds the page of a program or, if the words of a command follow, of this command, as
# pcl_ops_evaluate-run(1). The target man makes all pages.
function(pcl_ops_add_manual_page program summary component)
  # The program has to run: it would be slow with sanitizers, and cannot on another machine.
  if(NOT PCL_OPS_HELP2MAN OR NOT PCL_OPS_GZIP OR PCL_OPS_SANITIZE OR CMAKE_CROSSCOMPILING)
    return()
  endif()
  list(JOIN ARGN " " command)
  string(JOIN "-" name ${program} ${ARGN})
  set(page ${PROJECT_BINARY_DIR}/man/${name}.1.gz)
  add_custom_command(OUTPUT ${page}
    COMMAND ${CMAKE_COMMAND}
      -DPROGRAM=$<TARGET_FILE:${program}> "-DCOMMAND=${command}" -DNAME=${name}
      "-DSUMMARY=${summary}" -DPAGE=${page}
      -DHELP2MAN=${PCL_OPS_HELP2MAN} -DGZIP=${PCL_OPS_GZIP}
      -P ${pcl_ops_manual_dir}/make_page.cmake
    DEPENDS ${program} ${pcl_ops_manual_dir}/make_page.cmake
      ${pcl_ops_manual_dir}/common.h2m
    COMMENT "Manual page ${name}(1)" VERBATIM)
  add_custom_target(${name}_man DEPENDS ${page})
  if(NOT TARGET man)
    add_custom_target(man ALL)
  endif()
  add_dependencies(man ${name}_man)
  install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${component})
endfunction()
