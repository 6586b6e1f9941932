// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>

namespace pcl_ops::internal {

/** \brief Where each bin begins when items are put bin after bin.
 * \param[in] bin_of_item whole numbers
 * \param[out] begins one more than there are bins: the last is where the last bin ends
 */
template <typename Bins, typename Begins>
void
findBegins (const Bins& bin_of_item, Begins& begins)
{
  std::fill (begins.begin(), begins.end(), 0);
  for (const auto bin : bin_of_item)
    ++begins[bin + std::size_t (1)];
  for (std::size_t bin = 1; bin < begins.size(); ++bin)
    begins[bin] += begins[bin - 1];
}

/** \brief Calls visit (item, place) with where each item goes when items are put bin
 * after bin, those of a bin in their own order (counting sort).
 * \param[in] bin_of_item whole numbers
 * \param[in] begins where each bin's first item goes */
template <typename Bins, typename Begins, typename Visit>
void
forPlaces (const Bins& bin_of_item, Begins begins, Visit&& visit)
{
  for (std::size_t i = 0; i < bin_of_item.size(); ++i)
    visit (i, begins[bin_of_item[i]]++);
}

} // namespace pcl_ops::internal
