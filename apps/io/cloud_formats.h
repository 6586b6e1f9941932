// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_file.h"

#include <string>

namespace pcl_ops::apps {

/** \brief Whether \p word is a keyword that begins a line of a PCD header. */
bool
isPcdKey (const std::string& word);

// The readers throw a WorkError that says what is wrong in the file. Their clouds may
// lack x, y or z: loadCloud checks this, and sets row_step and is_survey.

FileCloud
readPcd (const std::string& file);

/** \brief Returns the header of a binary PCD. In the file the bytes of
 * FileCloud::points.data follow this header unchanged. */
std::string
pcdHeader (const FileCloud& cloud);

/** \brief Reads the vertices of a PLY, with PCL's names of fields: red, green, blue
 * (and alpha) become `rgb` (`rgba`), nx `normal_x`, and so on. The cloud is organized
 * if num_cols and num_rows or PCL's camera element say so. Lists are left out. */
FileCloud
readPly (const std::string& file);

/** \brief Returns the header of a binary little endian PLY. Every field keeps its name
 * and type, but: the first `rgb` or `rgba` of four bytes becomes red, green, blue (and
 * alpha); further such fields, and padding, are left out; 64-bit integers, which PLY
 * lacks, become doubles; a field NAME of several numbers becomes NAME_0, NAME_1, ...;
 * normals become nx, ny, nz; a name that is taken gets a _. */
std::string
plyHeader (const pcl::PCLPointCloud2& points);

/** \brief Returns the data of points, as the \ref plyHeader of any cloud with the same
 * fields declares them. */
std::string
plyVertices (const pcl::PCLPointCloud2& points);

/** \brief Reads all scans of a Leica PTX, with colors, in their common frame. Points at
 * the scanner itself are missing readings and become NaN. If there is only one scan,
 * the cloud is organized and has the pose of its scanner. */
FileCloud
readPtx (const std::string& file);

/** \brief Reads the vertices of an OFF, with normals and colors. */
FileCloud
readOff (const std::string& file);

/** \brief Reads the vertices of a Wavefront OBJ, with colors. */
FileCloud
readObj (const std::string& file);

/** \brief Reads a scan of the KITTI data set: x, y, z and intensity of each point in
 * single precision. Those of nuScenes (.pcd.bin) have a ring, too. */
FileCloud
readKitti (const std::string& file);

/** \brief Reads a NumPy array of shape (N, 3) or (H, W, 3), or with more columns. The
 * fields keep the number type of the array. */
FileCloud
readNpy (const std::string& file);

/** \brief Reads a text with a line for each point: x, y, z and further columns,
 * separated by blanks, commas or semicolons. Each column of numbers becomes a field in
 * double precision. Before the points there may be a line with the names of the columns
 * and one with the number of points. Lines that begin with # or // are comments. If no
 * line names the columns, a comment before the points may: it must have one word for
 * each column, x, y and z among them. pcl::ASCIIReader reads no names, and leaves out
 * every line that it does not understand. */
FileCloud
readTextCloud (const std::string& file);

} // namespace pcl_ops::apps
