// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "depth_png.h"

#include <boost/endian/conversion.hpp>

#include <cli/errors.h>
#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <new>

namespace pcl_ops::evaluation {

namespace {

struct PngError {
  std::string what;
};

[[noreturn]] void
leave (png_structp png, png_const_charp message)
{
  *static_cast<std::string*> (png_get_error_ptr (png)) = message;
  png_longjmp (png, 1);
}

void
ignoreWarning (png_structp, png_const_charp)
{}

/** A PNG file in the hands of libpng. */
class PngFile {
public:
  explicit PngFile (const std::string& file)
  : stream_ (std::fopen (file.c_str(), "rb"))
  , png_ (
        png_create_read_struct (PNG_LIBPNG_VER_STRING, &reason_, leave, ignoreWarning))
  , info_ (png_create_info_struct (png_))
  {}
  PngFile (const PngFile&) = delete;
  PngFile&
  operator= (const PngFile&) = delete;
  ~PngFile()
  {
    png_destroy_read_struct (&png_, &info_, nullptr);
    if (stream_ != nullptr)
      std::fclose (stream_);
  }

  /** The image's size, without its values.
   * \throw PngError if this is no depth image */
  DepthImage
  readHeader ()
  {
    if (info_ == nullptr)
      throw std::bad_alloc();
    if (stream_ == nullptr)
      throw PngError{"cannot be read"};
    attempt ("is no whole PNG file", [&] {
      png_init_io (png_, stream_);
      png_set_user_limits (png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
      png_read_info (png_, info_);
    });
    checkPixels();
    const DepthImage image{
        png_get_image_width (png_, info_), png_get_image_height (png_, info_), {}};
    /** Far above any depth camera, far below what would exhaust the memory. */
    constexpr std::size_t most_pixels = 100'000'000;
    if (image.width > most_pixels / image.height)
      throw PngError{"has an impossible size of " + std::to_string (image.width) +
                     " x " + std::to_string (image.height) + " pixels"};
    return image;
  }

  void
  readValues (DepthImage& image)
  {
    image.values.resize (image.width * image.height);
    attempt ("is damaged: it holds less than its size says", [&] {
      for (std::size_t row = 0; row < image.height; ++row)
        png_read_row (png_,
                      reinterpret_cast<png_bytep> (&image.values[row * image.width]),
                      nullptr);
      png_read_end (png_, nullptr);
    });
    for (std::uint16_t& value : image.values)
      boost::endian::big_to_native_inplace (value);
  }

private:
  void
  checkPixels () const
  {
    const int bits = png_get_bit_depth (png_, info_);
    const int color_type = png_get_color_type (png_, info_);
    if (bits != 16 || color_type != PNG_COLOR_TYPE_GRAY)
      throw PngError{"is no depth image: " + std::to_string (bits) +
                     " bits per channel, color type " + std::to_string (color_type) +
                     ", not 16-bit grey"};
    if (png_get_interlace_type (png_, info_) != PNG_INTERLACE_NONE)
      throw PngError{"is interlaced, which depth images are not"};
  }

  /** Where libpng finds an error it leaves \p read by longjmp: what that calls
   * must have nothing to destroy. */
  template <typename Read>
  void
  attempt (const char* problem, const Read& read)
  {
    if (setjmp (png_jmpbuf (png_)) != 0)
      throw PngError{std::string (problem) + " (" + reason_ + ")"};
    read();
  }

  std::string reason_;
  std::FILE* stream_;
  png_structp png_;
  png_infop info_;
};

} // namespace

DepthImage
readDepthPng (const std::string& file)
{
  try {
    PngFile png (file);
    DepthImage image = png.readHeader();
    png.readValues (image);
    return image;
  }
  catch (const PngError& error) {
    throw apps::WorkError (file, error.what + "; get the file again");
  }
}

} // namespace pcl_ops::evaluation
