// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl_ops::apps {

/** \brief Finds out whether anything can be drawn: where not, VTK aborts the program.
 * \param[in] has_window false if the drawing goes to a file
 * \throws WorkError that says what is missing and the mend */
void
checkDisplay (bool has_window);

} // namespace pcl_ops::apps
