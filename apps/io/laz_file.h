// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>

namespace pcl_ops::apps {

/** \brief Whether LASzip was there when this was built. */
bool
hasLaszip ();

bool
isLazName (const std::string& file);

/** \brief Also of a .laz. */
bool
isLasName (const std::string& file);

/** \brief Whether the points of a LAS file are compressed, whatever it is called.
 * \throws WorkError if it is none */
bool
isCompressedLas (const std::string& file);

// Both throw a WorkError if the file is damaged or LASzip is missing, and Interrupted.

/** \brief Writes the LAS that was compressed, to the byte. */
void
decompressLaz (const std::string& file, std::ostream& stream);

/** \brief Writes a LAS with compressed points and every other byte kept. */
void
compressLas (const std::string& file, std::ostream& stream);

} // namespace pcl_ops::apps
