// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace pcl_ops::apps {

/** \brief Decompresses LZF (M. Lehmann's LibLZF), as in a compressed PCD. PCL's
 * function is in a library that loads VTK and more. \param[out] bytes has the size that
 * is expected \return false if the compressed bytes do not make as many */
bool
decompressLzf (const std::vector<std::uint8_t>& compressed,
               std::vector<std::uint8_t>& bytes);

} // namespace pcl_ops::apps
