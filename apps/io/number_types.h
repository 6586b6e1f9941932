// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace pcl_ops::apps {

/** \brief Returns the number that is at an address in the bytes of a cloud. */
using NumberReader = double (*) (const std::uint8_t* bytes);

/** \brief A type of the numbers in a cloud's fields. */
struct NumberType {
  /** \brief The value of pcl::PCLPointField::datatype. PCL lacks 64-bit integers before
   * version 1.13. */
  std::uint8_t id;
  /** \brief The TYPE in a PCD: I, U (unsigned) or F (floating point). */
  char kind;
  /** \brief Number of bytes of a number. */
  std::size_t size;
  /** \brief The two names in PLY, as "uchar" and "uint8"; empty for 64-bit integers,
   * which PLY lacks. */
  std::string_view ply_name, ply_name_with_bits;
  /** \brief Reads a number in the byte order of the machine. */
  NumberReader read;
  /** \brief Parses a number and writes it into \p bytes. Accepts `nan`, `inf` and
   * `infinity`, but no number too large for double precision; a number that is too
   * large only for a float becomes infinite. For an integer type decimals are cut off,
   * as in PCL, and numbers beyond its range are taken modulo the range. `nan`, and
   * numbers with an absolute value of 2^63 or more, become 0; but uint64 takes all
   * whole numbers in its range. The result does not depend on the locale.
   * \return false if \p text is anything else */
  bool (*parse) (std::string_view text, void* bytes);
};

/** \brief Returns the type with an id (NumberType::id).
 * \throws std::out_of_range if no type has the id */
const NumberType&
numberType (std::uint8_t id);

/** \brief Returns the first type that is wanted; nullptr if there is none. */
const NumberType*
findNumberType (const std::function<bool (const NumberType&)>& is_wanted);

} // namespace pcl_ops::apps
