// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "typed_number.h"

#include <pcl/PCLPointField.h>

#include <cstring>

namespace pcl_ops::apps {

namespace {

using pcl::PCLPointField;

template <typename Number>
double
numberAt (const std::uint8_t* bytes)
{
  Number number;
  std::memcpy (&number, bytes, sizeof (number));
  return static_cast<double> (number);
}

} // namespace

NumberReader
readerOf (std::uint8_t datatype)
{
  switch (datatype) {
  case PCLPointField::INT8:
    return numberAt<std::int8_t>;
  case PCLPointField::UINT8:
    return numberAt<std::uint8_t>;
  case PCLPointField::INT16:
    return numberAt<std::int16_t>;
  case PCLPointField::UINT16:
    return numberAt<std::uint16_t>;
  case PCLPointField::INT32:
    return numberAt<std::int32_t>;
  case PCLPointField::UINT32:
    return numberAt<std::uint32_t>;
  case PCLPointField::FLOAT32:
    return numberAt<float>;
  case PCLPointField::FLOAT64:
    return numberAt<double>;
  default:
    // 8-byte integers, which PCL writes and reads but has no name for before 1.15.
    return numberAt<std::int64_t>;
  }
}

} // namespace pcl_ops::apps
