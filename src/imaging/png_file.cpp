#include "imaging/png_file.h"

#include <cstdint>

#include <fmt/format.h>
#include <png.h>

#include "core/error.h"
#include "core/files.h"

namespace bodkin::imaging {

static_assert(sizeof(Rgb) == 3, "pixels are handed to libpng as packed RGB");

namespace {

constexpr std::uint64_t most_pixels = 64'000'000;

png_image empty_control() {
  png_image control{};
  control.version = PNG_IMAGE_VERSION;
  return control;
}

}  // namespace

std::string encode_png(const ImageRgb& image) {
  png_image control = empty_control();
  control.width = static_cast<png_uint_32>(image.width);
  control.height = static_cast<png_uint_32>(image.height);
  control.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  const auto encode = [&](void* memory) {
    if (png_image_write_to_memory(&control, memory, &size, 0, image.pixels.data(), 0, nullptr) == 0) {
      throw SystemError(fmt::format("a picture of {} x {} pixels could not be made into a PNG: {}", image.width,
                                    image.height, control.message));
    }
  };
  encode(nullptr);  // queries the size
  std::string bytes(size, '\0');
  encode(bytes.data());
  bytes.resize(size);
  return bytes;
}

ImageRgb decode_png(std::string_view bytes, const std::string& origin) {
  png_image control = empty_control();
  const auto refuse = [&](const std::string& reason) {
    png_image_free(&control);
    return InputError(fmt::format("{} is not a usable PNG picture: {}", origin, reason));
  };
  if (png_image_begin_read_from_memory(&control, bytes.data(), bytes.size()) == 0) throw refuse(control.message);
  if (std::uint64_t{control.width} * control.height > most_pixels) {
    throw refuse(fmt::format("{} x {} pixels are too many", control.width, control.height));
  }
  control.format = PNG_FORMAT_RGB;
  ImageRgb image(static_cast<int>(control.width), static_cast<int>(control.height));
  const png_color white{255, 255, 255};
  if (png_image_finish_read(&control, &white, image.pixels.data(), 0, nullptr) == 0) throw refuse(control.message);
  return image;
}

void write_png(const ImageRgb& image, const std::filesystem::path& file) {
  write_file(file, encode_png(image));
}

}  // namespace bodkin::imaging
