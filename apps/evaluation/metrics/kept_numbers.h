// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/labels/labels.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>

namespace pcl_ops::evaluation {

/** \brief How well the planes of a sequence of clouds keep their numbers. Of true
 * planes those count that are found in two clouds and more: by one plane with more than
 * half of their common points in common. */
class KeptNumbers {
public:
  /** \brief Adds the next cloud.
   * \param[in] truth, result labels of its points; those of a true plane are the same
   * in all clouds */
  void
  add (const PlaneLabels& truth, const PlaneLabels& result);

  /** \brief True planes found in two clouds and more. */
  std::size_t
  planes () const;

  /** \brief Those that have one number wherever they are found. */
  std::size_t
  planesKept () const;

  /** \brief Times such a plane is found after the first. */
  std::size_t
  sightings () const
  {
    return sightings_;
  }

  /** \brief Times it has the number it had when it was found before. */
  std::size_t
  sightingsKept () const
  {
    return sightings_kept_;
  }

  /** \brief Numbers that were given, also to planes that are no true ones. */
  std::size_t
  numbers () const
  {
    return numbers_.size();
  }

private:
  struct History {
    std::set<std::uint32_t> numbers;
    std::uint32_t last = 0;
    std::size_t sightings = 0;
  };
  std::map<std::uint32_t, History> of_truth_;
  std::set<std::uint32_t> numbers_;
  std::size_t sightings_ = 0, sightings_kept_ = 0;
};

} // namespace pcl_ops::evaluation
