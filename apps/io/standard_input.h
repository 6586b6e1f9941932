// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_file.h"

namespace pcl_ops::apps {

/** \brief What stands for the standard streams where a file name is expected. */
inline constexpr const char* standard_stream = "-";

/** \brief How the standard input is called in messages. */
inline constexpr const char* standard_input = "standard input";

/** \brief Reads the PCD (ascii, binary, binary_compressed), PLY, LAS or text that is
 * piped into the program; a text by its first number or //. PCL reads from files only:
 * all of it is put into one for temporary files ($TMPDIR) first, which is removed in
 * any case. \throws UsageError if nothing is piped in, WorkError as \ref loadCloud, and
 * Interrupted */
FileCloud
loadStandardInput ();

} // namespace pcl_ops::apps
