// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "header_reader.h"

#include <cstddef>
#include <string>

namespace pcl_ops::apps {

/** \brief What the words of a line of text are separated by: a semicolon or a comma if
 * there is one, else a space, which stands for all blanks. */
char
separatorOf (const std::string& line);

/** \brief The words of a line, without blanks and quotes around them. */
Words
wordsOf (const std::string& line);

/** \brief Whether these can be names of columns: none begins as a number does. */
bool
areNames (const Words& words);

/** \brief Whether x, y and z are among them, or what else these are called. */
bool
nameCoordinates (const Words& words);

/** \brief The fields that the columns of a text become. Those called x, y and z are the
 * coordinates, or easting, northing and elevation, whatever the case and the unit in
 * brackets behind; where no column has a name, the first three are. All others keep
 * their names as far as those of a field can be so, or are field_4, field_5, ...
 * \param[in] file of the text, for messages
 * \param[in] names of the columns; empty for none
 * \param[in] count of the columns, at least three
 * \throws WorkError where columns have names, but a coordinate has none */
Words
fieldNames (const std::string& file, const Words& names, std::size_t count);

} // namespace pcl_ops::apps
