// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl_ops::apps {

/** \brief Finds out whether a window can be opened: without a display, or with one that
 * cannot draw in three dimensions, VTK ends the program by itself.
 * \throws WorkError that says what is missing and the mend */
void
checkDisplay ();

} // namespace pcl_ops::apps
