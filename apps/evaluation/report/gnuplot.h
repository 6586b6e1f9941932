// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl_ops::evaluation {

/** \brief A picture gnuplot draws from columns of numbers. */
struct Plot {
  /** \brief Of its files, without extension. */
  std::string name;
  /** \brief The columns, as NAME.dat has them. */
  std::string data;
  /** \brief What this picture alone has: axes, titles and what is plotted. */
  std::string commands;
};

/** \brief Writes NAME.dat, NAME.gp and, where gnuplot is installed, NAME.png.
 * \return whether the picture was drawn
 * \throw apps::WorkError if a file cannot be written */
bool
writePlot (const Plot& plot, const std::string& folder);

} // namespace pcl_ops::evaluation
