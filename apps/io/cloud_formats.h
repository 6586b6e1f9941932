// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_file.h"

#include <string>

namespace pcl_ops::apps {

/** \brief Whether a line of the header of a PCD begins with this word. */
bool
isPcdKey (const std::string& word);

// The readers throw a WorkError that names the line at fault, or that data are missing.

FileCloud
readPcd (const std::string& file);

/** \brief That of a binary one, whose data are those of the points. */
std::string
pcdHeader (const FileCloud& cloud);

/** \brief Reads the vertices, with the names that PCL has for fields: red, green, blue
 * (and alpha) become `rgb` (`rgba`), nx `normal_x`, and so on. The cloud is organized
 * where num_cols and num_rows or PCL's camera say so. */
FileCloud
readPly (const std::string& file);

/** \brief That of a binary little endian one: every field with its type, except that of
 * `rgb` and `rgba` the first becomes red, green, blue (and alpha), 64-bit integers,
 * which PLY lacks, doubles, the numbers of a field of several NAME_0, NAME_1, ..., and
 * normals nx, ny, nz. */
std::string
plyHeader (const pcl::PCLPointCloud2& points);

/** \brief The numbers of its points, as they follow in that file. */
std::string
plyVertices (const pcl::PCLPointCloud2& points);

/** \brief Reads scans of a Leica scanner, with colors, in the frame of all of them.
 * Points at the scanner, which are missing readings, are NaN. One scan is organized,
 * and has the pose of its scanner. */
FileCloud
readPtx (const std::string& file);

/** \brief Reads the vertices of an OFF, with normals and colors. */
FileCloud
readOff (const std::string& file);

/** \brief Reads the vertices of a Wavefront OBJ, with colors. */
FileCloud
readObj (const std::string& file);

/** \brief Reads a scan of the KITTI data set: x, y, z and intensity of each point in
 * single precision; nuScenes's (.pcd.bin) have a ring, too. */
FileCloud
readKitti (const std::string& file);

/** \brief Reads an array of NumPy, of shape (N, 3) or (H, W, 3), or more columns, in
 * the type it has. */
FileCloud
readNpy (const std::string& file);

/** \brief Reads a line for each point: x, y and z and further columns of numbers, each
 * a field in double precision, separated by blanks, commas or semicolons. In front of
 * them there may be the names of the columns and, in a line of its own, the number of
 * points; lines that begin with # or // are comments, of which one with x, y and z has
 * names. pcl::ASCIIReader has no header, and leaves out every line it does not
 * understand. */
FileCloud
readTextCloud (const std::string& file);

} // namespace pcl_ops::apps
