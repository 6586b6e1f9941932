// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <string>

namespace pcl_ops::apps {

/** \brief A number from its bytes, the lowest first, on any host. */
template <typename Number>
Number
fromLittleEndian (const char* bytes)
{
  using namespace boost::endian;
  return endian_load<Number, sizeof (Number), order::little> (
      reinterpret_cast<const unsigned char*> (bytes));
}

/** \brief The bytes of a number, the lowest first. */
template <typename Number>
std::string
littleEndian (Number number)
{
  using namespace boost::endian;
  std::string bytes (sizeof (number), '\0');
  endian_store<Number, sizeof (Number), order::little> (
      reinterpret_cast<unsigned char*> (bytes.data()), number);
  return bytes;
}

/** \brief Puts the bytes of a number in place of some. */
template <typename Number>
void
setNumber (std::string& bytes, std::size_t place, Number number)
{
  bytes.replace (place, sizeof (number), littleEndian (number));
}

} // namespace pcl_ops::apps
