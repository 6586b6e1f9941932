// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
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

/** \brief A cloud and which of its points to use. */
struct FuzzedCloud {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud;
  /** \brief None: the whole cloud. May be outside of it, double, or without order. */
  pcl::IndicesPtr indices;
};

/** \brief Up to some 4,000 points as bytes say: planes, lines, balls, lattices, dust,
 * equal points, any bits as floats, points far away, not finite ones, all of it shrunk,
 * magnified or moved off. Bytes that were points themselves would hardly ever lie on a
 * plane. */
FuzzedCloud
cloudFrom (ByteReader& bytes);

/** \brief Something that holds for whatever comes in did not. */
struct BrokenPromise : std::logic_error {
  using std::logic_error::logic_error;
};

/** \brief \throws BrokenPromise unless it holds */
inline void
promise (bool holds, const std::string& what)
{
  if (!holds)
    throw BrokenPromise ("broken promise: " + what);
}

using Targets = std::map<std::string, void (*) (const Bytes&)>;

/** \brief Detect planes with parameters and in a cloud made up from bytes, by each
 * method: see promiseOrderedPlanes. */
Targets
detectorTargets ();

/** \brief All by their names; the corpus of each is the folder of that name. "pcd",
 * "ply", "las" and "ascii" load bytes as a file: a cloud whose sizes agree, or an error
 * of one line; of a text each number is written again, and a LAS is labeled, where it
 * takes labels. "options" takes lines for what stands on a command line, and detects
 * planes in a small cloud by it. */
const Targets&
allTargets ();

} // namespace pcl_ops::fuzz
