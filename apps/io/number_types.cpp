// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "number_types.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <locale>
#include <sstream>
#include <system_error>
#include <type_traits>

namespace pcl_ops::apps {

namespace {

/** \brief A NumberType::read. */
template <typename Number>
double
read (const std::uint8_t* bytes)
{
  Number number;
  std::memcpy (&number, bytes, sizeof (number));
  return static_cast<double> (number);
}

/** \brief Reads a number in single or double precision.
 * \return false unless all of the text is a number that is not too large for double
 * precision */
template <typename Float>
bool
readFloat (std::string_view text, Float& number)
{
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars (text.data(), end, number);
  if (error != std::errc::result_out_of_range)
    return error == std::errc() && rest == end;
  // from_chars stores nothing if the number is too large or too small. A stream does,
  // and takes a point for the decimal point in any locale, as strtod does not.
  std::istringstream stream{std::string (text)};
  stream.imbue (std::locale::classic());
  double nearest = 0.0; // the largest double if the number is too large
  stream >> nearest;
  number = static_cast<Float> (nearest);
  // Some streams fail for a number that is too small, too.
  const bool is_too_large = !stream && std::abs (nearest) > 1.0;
  return rest == end && !is_too_large;
}

/** \brief Reads an integer, or cuts off the decimals of another number, as \ref
 * NumberType::parse says.
 * \return false unless all of the text is a number */
template <typename Integer>
bool
readInteger (std::string_view text, Integer& number)
{
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars (text.data(), end, number);
  if (error == std::errc() && rest == end)
    return true;
  double real = 0.0;
  if (!readFloat (text, real))
    return false;
  const bool fits_int64 = std::abs (real) < std::ldexp (1.0, 63);
  number = fits_int64 ? static_cast<Integer> (static_cast<std::int64_t> (real))
                      : Integer (0);
  return true;
}

/** \brief A NumberType::parse. */
template <typename Number>
bool
parse (std::string_view text, void* bytes)
{
  // from_chars does not accept a plus sign. In +-1 it stays, as this is no number.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
    text.remove_prefix (1);
  Number number{};
  bool is_number = false;
  if constexpr (std::is_integral_v<Number>)
    is_number = readInteger (text, number);
  else
    is_number = readFloat (text, number);
  std::memcpy (bytes, &number, sizeof (number));
  return is_number;
}

template <typename Number>
constexpr NumberType
typeOf (std::uint8_t id,
        char kind,
        std::string_view ply_name = {},
        std::string_view ply_name_with_bits = {})
{
  constexpr std::size_t size = sizeof (Number);
  return {id, kind, size, ply_name, ply_name_with_bits, read<Number>, parse<Number>};
}

/** \brief All types in the order of their ids, which begin with 1. */
constexpr std::array<NumberType, 10> types = {
    {typeOf<std::int8_t> (1, 'I', "char", "int8"),
     typeOf<std::uint8_t> (2, 'U', "uchar", "uint8"),
     typeOf<std::int16_t> (3, 'I', "short", "int16"),
     typeOf<std::uint16_t> (4, 'U', "ushort", "uint16"),
     typeOf<std::int32_t> (5, 'I', "int", "int32"),
     typeOf<std::uint32_t> (6, 'U', "uint", "uint32"),
     typeOf<float> (7, 'F', "float", "float32"),
     typeOf<double> (8, 'F', "double", "float64"),
     typeOf<std::int64_t> (9, 'I'),
     typeOf<std::uint64_t> (10, 'U')}};

} // namespace

const NumberType&
numberType (std::uint8_t id)
{
  return types.at (id - 1U);
}

const NumberType*
findNumberType (const std::function<bool (const NumberType&)>& is_wanted)
{
  const auto* const found = std::find_if (types.begin(), types.end(), is_wanted);
  return found == types.end() ? nullptr : &*found;
}

} // namespace pcl_ops::apps
