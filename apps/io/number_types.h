// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace pcl_ops::apps {

using NumberReader = double (*) (const std::uint8_t* bytes);

/** \brief A type of the numbers in a cloud's fields. */
struct NumberType {
  /** \brief As in pcl::PCLPointField, which lacks 64-bit integers before PCL 1.13. */
  std::uint8_t id;
  /** \brief I, U or F, as PCD says. */
  char kind;
  std::size_t size;
  /** \brief In PLY, in both spellings; empty for 64-bit integers. */
  std::string_view ply_name, ply_name_with_bits;
  NumberReader read;
  /** \brief Puts a number into bytes: also `nan`, `inf` and `infinity`, but none that
   * is too large for double precision. Of an integer field decimals
   * are cut off, as in PCL, and what is beyond its type is taken modulo its range.
   * \param[in] text is followed by a character that is no part of it
   * \return false for anything else */
  bool (*parse) (std::string_view text, void* bytes);
};

const NumberType&
numberType (std::uint8_t id);

/** \return nullptr for none */
const NumberType*
findNumberType (const std::function<bool (const NumberType&)>& is_it);

} // namespace pcl_ops::apps
