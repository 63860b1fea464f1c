// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pictures/PictureFormats.h"

#include <cstdio> // jpeglib.h uses its types

#include "vtk_jpeg.h"
#include "vtk_png.h"

#include <csetjmp>
#include <cstddef>
#include <cstdlib>

namespace relevo
{
namespace
{
// Level 1 of zlib takes a third of the time of the default, for files that are a tenth larger.
const int CompressionLevel = 1;

struct JPEGErrors
{
  jpeg_error_mgr Manager; // the first member, so that both have one address
  std::jmp_buf Return;
};

void LeaveJPEG(j_common_ptr encoder)
{
  std::longjmp(reinterpret_cast<JPEGErrors*>(encoder->err)->Return, 1);
}

void IgnoreJPEGMessage(j_common_ptr)
{
}

unsigned char* GetRow(const RawPicture& picture, int fromTop)
{
  const std::size_t size = static_cast<std::size_t>(picture.Width) * 3;
  const std::size_t row = static_cast<std::size_t>(picture.Height - 1 - fromTop);
  return const_cast<unsigned char*>(picture.Pixels.data() + row * size);
}

// No object with a destructor lives in these two functions, because errors leave them by longjmp().
bool RunJPEG(
  const RawPicture& picture, int quality, unsigned char** buffer, unsigned long* bufferSize)
{
  jpeg_compress_struct encoder;
  JPEGErrors errors;
  encoder.err = jpeg_std_error(&errors.Manager);
  errors.Manager.error_exit = LeaveJPEG;
  errors.Manager.output_message = IgnoreJPEGMessage;
  if (setjmp(errors.Return))
  {
    jpeg_destroy_compress(&encoder);
    return false;
  }
  jpeg_create_compress(&encoder);
  jpeg_mem_dest(&encoder, buffer, bufferSize);
  encoder.image_width = static_cast<JDIMENSION>(picture.Width);
  encoder.image_height = static_cast<JDIMENSION>(picture.Height);
  encoder.input_components = 3;
  encoder.in_color_space = JCS_RGB;
  jpeg_set_defaults(&encoder);
  jpeg_set_quality(&encoder, quality, TRUE);
  jpeg_start_compress(&encoder, TRUE);
  while (encoder.next_scanline < encoder.image_height)
  {
    JSAMPROW row = GetRow(picture, static_cast<int>(encoder.next_scanline));
    jpeg_write_scanlines(&encoder, &row, 1);
  }
  jpeg_finish_compress(&encoder);
  jpeg_destroy_compress(&encoder);
  return true;
}

bool RunPNG(png_structp encoder, png_infop info, const RawPicture& picture,
  const std::atomic<bool>& isCancelled)
{
  if (setjmp(png_jmpbuf(encoder)))
  {
    return false;
  }
  png_set_compression_level(encoder, CompressionLevel);
  png_set_filter(encoder, 0, PNG_FILTER_SUB);
  png_set_IHDR(encoder, info, static_cast<png_uint_32>(picture.Width),
    static_cast<png_uint_32>(picture.Height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
    PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(encoder, info);
  for (int row = 0; row < picture.Height; ++row)
  {
    if (isCancelled)
    {
      return false;
    }
    png_write_row(encoder, GetRow(picture, row));
  }
  png_write_end(encoder, info);
  return true;
}

void AppendPNG(png_structp encoder, png_bytep data, png_size_t size)
{
  auto* file = static_cast<std::vector<unsigned char>*>(png_get_io_ptr(encoder));
  file->insert(file->end(), data, data + size);
}

void FlushPNG(png_structp)
{
}

void IgnorePNGMessage(png_structp, png_const_charp)
{
}

void LeavePNG(png_structp encoder, png_const_charp)
{
  png_longjmp(encoder, 1);
}
}

//------------------------------------------------------------------------------
std::vector<unsigned char> WriteJPEG(const RawPicture& picture, int quality)
{
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  std::vector<unsigned char> file;
  if (RunJPEG(picture, quality, &buffer, &size))
  {
    file.assign(buffer, buffer + size);
  }
  std::free(buffer);
  return file;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> WritePNG(const RawPicture& picture, const std::atomic<bool>& isCancelled)
{
  std::vector<unsigned char> file;
  png_structp encoder =
    png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, LeavePNG, IgnorePNGMessage);
  png_infop info = encoder ? png_create_info_struct(encoder) : nullptr;
  if (info)
  {
    png_set_write_fn(encoder, &file, AppendPNG, FlushPNG);
    if (!RunPNG(encoder, info, picture, isCancelled))
    {
      file.clear();
    }
  }
  png_destroy_write_struct(&encoder, &info);
  return file;
}
}
