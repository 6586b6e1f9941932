// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <sstream>
#include <string>

/** A floor of 10 x 10 points, 2 cm apart, as text of a file with the columns x, y, z
 * and label.
 * \param[in] label_of returns the label of the point with an index from 0 to 99 */
inline std::string
labeledFloor (const std::function<int (int)>& label_of)
{
  std::ostringstream text;
  text << "x,y,z,label\n";
  for (int i = 0; i < 100; ++i)
    text << 0.02 * (i % 10) << ',' << 0.02 * (i / 10) << ",0," << label_of (i) << '\n';
  return text.str();
}

/** The floor as one plane with the label 1. */
inline std::string
floorOfOnePlane ()
{
  return labeledFloor ([] (int) { return 1; });
}

/** The floor as two planes: 60 points with the label 4, 40 with the label 9. */
inline std::string
floorOfTwoPlanes ()
{
  return labeledFloor ([] (int i) { return i < 60 ? 4 : 9; });
}
