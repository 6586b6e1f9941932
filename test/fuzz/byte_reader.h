// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace pcl_ops::fuzz {

/** \brief What a fuzzer makes up. */
using Bytes = std::vector<std::uint8_t>;

/** \brief Numbers from bytes, one after the other; zeros after the last, so that any
 * bytes mean something. */
class ByteReader {
public:
  explicit ByteReader (const Bytes& bytes) : bytes_ (bytes) {}

  bool
  isAtEnd () const
  {
    return next_ >= bytes_.size();
  }

  template <typename Number>
  Number
  take ()
  {
    std::uint8_t raw[sizeof (Number)] = {};
    for (std::uint8_t& byte : raw)
      byte = isAtEnd() ? std::uint8_t (0) : bytes_[next_++];
    Number number;
    std::memcpy (&number, raw, sizeof (Number));
    return number;
  }

  /** \brief 0 .. bound - 1 */
  std::size_t
  below (std::size_t bound)
  {
    return take<std::uint16_t>() % bound;
  }

private:
  const Bytes& bytes_;
  std::size_t next_ = 0;
};

} // namespace pcl_ops::fuzz
