// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ply_body.h"

#include <pcl/common/io.h>

#include <boost/endian/conversion.hpp>

#include "number_lines.h"
#include "typed_number.h"

#include <algorithm>
#include <array>

namespace pcl_ops::apps {

namespace {

constexpr const char* grid_name = "range_grid";

/** \brief Of an element's list of vertices: whether they are among those there are. */
class GridCheck {
public:
  GridCheck (const HeaderReader& reader,
             const PlyLayout& layout,
             const std::string& name)
  : reader_ (reader)
  , is_grid_ (name == grid_name)
  , vertices_ (static_cast<double> (layout.find ("vertex")->count))
  {}

  void
  operator() (double vertex) const
  {
    if (is_grid_ && !(vertex >= 0.0 && vertex < vertices_))
      reader_.fail ("its range_grid names a vertex that does not exist");
  }

private:
  const HeaderReader& reader_;
  bool is_grid_;
  double vertices_;
};

bool
hasLists (const PlyElement& element)
{
  return std::any_of (element.properties.begin(),
                      element.properties.end(),
                      [] (const PlyProperty& property) { return property.is_list; });
}

/** \brief Walks through a line's lists by their lengths. */
void
checkLists (const HeaderReader& reader,
            const PlyElement& element,
            const std::vector<double>& numbers,
            const GridCheck& check)
{
  const auto fail = [&] {
    reader.failAtLine ("has a list of another length than it says");
  };
  std::size_t at = 0;
  for (const PlyProperty& property : element.properties) {
    if (at == numbers.size())
      fail();
    const double length = property.is_list ? numbers[at] : 0.0;
    const auto left = static_cast<double> (numbers.size() - at - 1);
    if (!(length >= 0.0 && length <= left))
      fail();
    const std::size_t end = at + 1 + static_cast<std::size_t> (length);
    while (++at < end)
      check (numbers[at]);
  }
  if (at != numbers.size())
    fail();
}

void
checkText (HeaderReader& reader, const PlyLayout& layout)
{
  NumberLines lines (reader);
  for (const PlyElement& element : layout.elements) {
    const GridCheck check (reader, layout, element.name);
    const bool has_lists = hasLists (element);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      lines.next();
      if (has_lists)
        checkLists (reader, element, lines.numbers(), check);
      else
        lines.expectNumbers (element.properties.size());
    }
  }
  lines.expectEnd();
}

/** \brief The numbers of data that is no text, one after the other. */
class BinaryNumbers {
public:
  BinaryNumbers (HeaderReader& reader, bool is_big_endian)
  : reader_ (reader), is_big_endian_ (is_big_endian)
  {}

  double
  next (std::uint8_t type)
  {
    std::array<std::uint8_t, 8> bytes{};
    const auto size = static_cast<std::size_t> (pcl::getFieldSize (type));
    reader_.read (reinterpret_cast<char*> (bytes.data()), size);
    if (is_big_endian_ == is_host_little_endian)
      std::reverse (bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t> (size));
    return readerOf (type) (bytes.data());
  }

private:
  static constexpr bool is_host_little_endian =
      boost::endian::order::native == boost::endian::order::little;

  HeaderReader& reader_;
  bool is_big_endian_;
};

/** \brief Looks at a grid's lists, which PCL's reader follows blindly. */
void
checkBinary (HeaderReader& reader, const PlyLayout& layout)
{
  if (layout.find (grid_name) == nullptr)
    return;
  BinaryNumbers numbers (reader, layout.format == "binary_big_endian");
  for (const PlyElement& element : layout.elements) {
    const GridCheck check (reader, layout, element.name);
    for (std::uint64_t i = 0; i < element.count; ++i)
      for (const PlyProperty& property : element.properties) {
        const double length =
            property.is_list ? numbers.next (property.length_type) : 1.0;
        for (double item = 0.0; item < length; ++item) {
          const double number = numbers.next (property.type);
          if (property.is_list)
            check (number);
        }
      }
    if (element.name == grid_name)
      return;
  }
}

} // namespace

const PlyElement*
PlyLayout::find (const std::string& name) const
{
  const auto found =
      std::find_if (elements.begin(), elements.end(), [&] (const PlyElement& element) {
        return element.name == name;
      });
  return found == elements.end() ? nullptr : &*found;
}

void
checkPlyBody (HeaderReader& reader, const PlyLayout& layout)
{
  if (layout.format == "ascii")
    checkText (reader, layout);
  else
    checkBinary (reader, layout);
}

} // namespace pcl_ops::apps
