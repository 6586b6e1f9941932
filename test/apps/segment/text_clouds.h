// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "segment_program.h"

#include <cmath>
#include <sstream>
#include <string>

/** \brief A square, 2 m x 2 m seen from above, that goes down by 45 degrees towards one
 * of its corners.
 * \param[in] east,north 1 if it goes down to the east or north, -1 if to the west or
 * south */
inline std::string
slopeText (int east, int north)
{
  std::ostringstream text;
  for (int i = 0; i < points_of_plane; ++i) {
    const double x = 0.04 * (i % points_of_side);
    const double y = 0.04 * (i / points_of_side);
    text << east * x << ' ' << north * y << ' ' << -M_SQRT1_2 * (x + y) << '\n';
  }
  return text.str();
}

/** \brief Points at longitude and latitude in degrees, with a height in meters. */
inline std::string
degreesText ()
{
  constexpr int points = 400;
  std::ostringstream text;
  text << std::fixed << std::setprecision (8);
  for (int i = 0; i < points; ++i)
    text << 11 + 1e-6 * (i % 20) << ' ' << 48 + 5e-8 * i << ' ' << 498 + i % 20 << '\n';
  return text.str();
}

/** \brief A floor in text with columns whose names mean something to readers of PLY. */
inline std::string
columnsText ()
{
  std::ostringstream text;
  text << "x,y,z,red,nx,normal_x,rgb\n";
  for (int i = 0; i < 2000; ++i)
    text << 0.05 * (i % 50) << ',' << 0.05 * (i / 50) << ",0," << i << ",2,3,4\n";
  return text.str();
}

/** \brief A PCD of 2 x 2 points with fields of unusual types and sizes. */
inline std::string
pcdOfManyTypes ()
{
  std::string text =
      "FIELDS x y z normal_x normal_y normal_z shape stamp red\n"
      "SIZE 4 8 4 4 4 4 2 8 4\nTYPE F F F F F F I I F\nCOUNT 1 1 1 1 1 1 2 1 1\n"
      "WIDTH 2\nHEIGHT 2\nPOINTS 4\nDATA ascii\n";
  for (int i = 0; i < 4; ++i)
    text += std::to_string (i) + " 0 1.5 0 0 1 7 8 4294967297 9\n";
  return text;
}

/** \brief A scan of a horizontal square of 1 m x 1 m, in the format PTX.
 * \param[in] scanner height of the scanner [m]
 * \param[in] above height of the square above the scanner, negative if below [m] */
inline std::string
scanText (int scanner, int above)
{
  std::ostringstream text;
  text << "50\n50\n0 0 " << scanner << "\n1 0 0\n0 1 0\n0 0 1\n"
       << "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 " << scanner << " 1\n";
  for (int i = 0; i < 2500; ++i)
    text << 0.02 * (i / 50) << ' ' << 0.02 * (i % 50) << ' ' << above << ' ' << i
         << '\n';
  return text.str();
}

/** \brief A square of 2 m x 2 m at z = 5 m, in the format OFF. */
inline std::string
offText ()
{
  std::ostringstream text;
  text << "OFF\n2500 0 0\n";
  for (int i = 0; i < 2500; ++i)
    text << 0.04 * (i / 50) << ' ' << 0.04 * (i % 50) << " 5\n";
  return text.str();
}

/** \brief Three squares of 2 m x 2 m that meet in a corner, in double precision at UTM
 * coordinates. */
inline std::string
farCornerText ()
{
  constexpr double x = 448'261.25;
  constexpr double y = 5'411'932.5;
  constexpr double z = 312.125;
  std::ostringstream text;
  text << "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH 7500\nHEIGHT 1\nPOINTS 7500\n"
       << "DATA ascii\n"
       << std::fixed << std::setprecision (4);
  for (int i = 0; i < 2500; ++i) {
    const double s = (i / 50 + 0.5) / 25.0;
    const double t = (i % 50 + 0.5) / 25.0;
    text << x + s << ' ' << y + t << ' ' << z << '\n'
         << x << ' ' << y + s << ' ' << z + t << '\n'
         << x + t << ' ' << y << ' ' << z + s << '\n';
  }
  return text.str();
}

/** \brief A wall of 3 m x 2 m with a window of 1 m x 0.8 m. */
inline std::string
windowText ()
{
  std::ostringstream text;
  for (int column = 0; column <= 150; ++column)
    for (int row = 0; row <= 100; ++row) {
      const double x = 0.02 * column;
      const double z = 0.02 * row;
      // The rim of the window, from 1 to 2 m and from 0.8 to 1.6 m, has points.
      const bool is_in_window = x > 1.005 && x < 1.995 && z > 0.805 && z < 1.595;
      if (!is_in_window)
        text << x << " 2 " << z << '\n';
    }
  return text.str();
}

/** \brief A wall, and a floor that rises by 3 cm over 2.4 m. */
inline std::string
tiltedFloorText ()
{
  std::ostringstream text;
  for (int i = 0; i < 60; ++i)
    for (int k = 0; k < 60; ++k)
      text << 0.04 * i << ' ' << 0.04 * k << ' ' << 0.0005 * i << '\n'
           << 0.04 * i << " 0 " << 0.04 * k + 0.01 << '\n';
  return text.str();
}
