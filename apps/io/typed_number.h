// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace pcl_ops::apps {

/** \brief Reads a number from its bytes. */
using NumberReader = double (*) (const std::uint8_t*);

/** \brief The reader of one of the types of pcl::PCLPointField. */
NumberReader
readerOf (std::uint8_t datatype);

} // namespace pcl_ops::apps
