#include "tracking/jpeg_file.h"

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <fmt/format.h>
#include <jpeglib.h>

#include "core/error.h"

namespace bodkin::tracking {

namespace {

// libjpeg reports errors through a function that must not return.
[[noreturn]] void throw_error(j_common_ptr info) {
  char text[JMSG_LENGTH_MAX] = {};
  info->err->format_message(info, text);
  throw InputError(text);
}

void say_nothing(j_common_ptr /*info*/) {}

std::string encode(const unsigned char* pixels, int width, int height, int parts, int quality) {
  jpeg_compress_struct info{};
  jpeg_error_mgr errors{};
  info.err = jpeg_std_error(&errors);
  errors.error_exit = throw_error;
  errors.output_message = say_nothing;
  jpeg_create_compress(&info);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;  // NOLINT: libjpeg's
  jpeg_mem_dest(&info, &bytes, &size);
  std::string made;
  try {
    info.image_width = static_cast<JDIMENSION>(width);
    info.image_height = static_cast<JDIMENSION>(height);
    info.input_components = parts;
    info.in_color_space = parts == 1 ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_set_defaults(&info);
    jpeg_set_quality(&info, quality, TRUE);
    jpeg_start_compress(&info, TRUE);
    while (info.next_scanline < info.image_height) {
      // libjpeg only reads the row.
      auto* row = const_cast<unsigned char*>(pixels + static_cast<std::size_t>(info.next_scanline) *  // NOLINT
                                                          static_cast<std::size_t>(width * parts));
      jpeg_write_scanlines(&info, &row, 1);
    }
    jpeg_finish_compress(&info);
    made.assign(reinterpret_cast<const char*>(bytes), size);
  } catch (...) {
    jpeg_destroy_compress(&info);
    std::free(bytes);
    throw;
  }
  jpeg_destroy_compress(&info);
  std::free(bytes);
  return made;
}

// `sized(width, height)` returns the destination of the pixels.
template <typename Sized>
void decode(std::string_view bytes, const std::string& origin, J_COLOR_SPACE space, const Sized& sized) {
  jpeg_decompress_struct info{};
  jpeg_error_mgr errors{};
  info.err = jpeg_std_error(&errors);
  errors.error_exit = throw_error;
  errors.output_message = say_nothing;
  jpeg_create_decompress(&info);
  try {
    jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    jpeg_read_header(&info, TRUE);
    if (static_cast<double>(info.image_width) * info.image_height > 64e6) {
      throw InputError("it has more than 64 million pixels");
    }
    info.out_color_space = space;
    jpeg_start_decompress(&info);
    unsigned char* to = sized(static_cast<int>(info.output_width), static_cast<int>(info.output_height));
    const std::size_t row =
        static_cast<std::size_t>(info.output_width) * static_cast<std::size_t>(info.output_components);
    while (info.output_scanline < info.output_height) {
      unsigned char* line = to + info.output_scanline * row;
      jpeg_read_scanlines(&info, &line, 1);
    }
    if (errors.num_warnings > 0) throw InputError("its data end early or are damaged");
    jpeg_finish_decompress(&info);
  } catch (const InputError& error) {
    jpeg_destroy_decompress(&info);
    throw InputError(fmt::format("{}: not a valid JPEG picture: {}", origin, error.what()));
  } catch (...) {
    jpeg_destroy_decompress(&info);
    throw;
  }
  jpeg_destroy_decompress(&info);
}

}  // namespace

std::string encode_jpeg(const GreyImage& picture, int quality) {
  return encode(picture.pixels.data(), picture.width, picture.height, 1, quality);
}

std::string encode_jpeg(const imaging::ImageRgb& picture, int quality) {
  static_assert(sizeof(imaging::Rgb) == 3);
  return encode(reinterpret_cast<const unsigned char*>(picture.pixels.data()), picture.width, picture.height, 3,
                quality);
}

GreyImage decode_jpeg_grey(std::string_view bytes, const std::string& origin) {
  GreyImage picture;
  decode(bytes, origin, JCS_GRAYSCALE, [&](int width, int height) {
    picture = GreyImage(width, height);
    return picture.pixels.data();
  });
  return picture;
}

imaging::ImageRgb decode_jpeg(std::string_view bytes, const std::string& origin) {
  imaging::ImageRgb picture;
  decode(bytes, origin, JCS_RGB, [&](int width, int height) {
    picture = imaging::ImageRgb(width, height);
    return reinterpret_cast<unsigned char*>(picture.pixels.data());
  });
  return picture;
}

}  // namespace bodkin::tracking
