#include "io/images/dicom_extent.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <string>
#include <string_view>

namespace bodkin::io {
namespace {

constexpr std::uint32_t undefined_length = 0xFFFFFFFF;
constexpr std::uint32_t pixel_data = 0x7FE00010, transfer_syntax = 0x00020010;
constexpr std::uint32_t item_tag = 0xFFFEE000, end_of_item = 0xFFFEE00D, end_of_sequence = 0xFFFEE0DD;
constexpr int deepest_sequence = 16;  // sequences in sequences

struct Element {
  std::uint32_t tag = 0, length = 0;
};

enum class Step { element, end, cut, unknown };

class Walker {
 public:
  explicit Walker(const std::filesystem::path& file) : stream_(file, std::ios::binary) {
    std::error_code error;
    size_ = std::filesystem::file_size(file, error);
    std::array<char, 132> head{};
    stream_.read(head.data(), static_cast<std::streamsize>(head.size()));
    place_ = std::string_view(head.data() + 128, 4) == "DICM" ? 132 : 0;
  }

  DicomExtent run() {
    DicomExtent extent;
    Element element;
    for (Step step = next(element); step != Step::end; step = next(element)) {
      if (step == Step::unknown) return extent;
      if (step == Step::cut) {
        (element.tag == pixel_data ? extent.pixels_cut : extent.header_cut) = true;
        return extent;
      }
      if (element.tag < extent.last_tag && extent.last_tag >= pixel_data) break;  // padding after the pixels
      if (element.tag == transfer_syntax && !read_syntax(element)) return {};
      extent.last_tag = element.tag;
      const bool whole = element.length == undefined_length ? skip_sequence(0) : skip(element.length);
      if (unknown_) return extent;
      if (!whole) {
        (element.tag == pixel_data ? extent.pixels_cut : extent.header_cut) = true;
        return extent;
      }
    }
    return extent;
  }

 private:
  bool read(char* bytes, std::size_t count) {
    if (size_ - place_ < count) return false;
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(place_));
    stream_.read(bytes, static_cast<std::streamsize>(count));
    place_ += count;
    return stream_.gcount() == static_cast<std::streamsize>(count);
  }

  static std::uint32_t number(const char* bytes, int count) {
    std::uint32_t value = 0;
    for (int n = count - 1; n >= 0; --n) value = 256 * value + static_cast<unsigned char>(bytes[n]);
    return value;
  }

  Step next(Element& element) {
    if (place_ >= size_) return Step::end;
    std::array<char, 8> head{};
    if (!read(head.data(), head.size())) return Step::cut;
    element.tag = (number(head.data(), 2) << 16U) + number(head.data() + 2, 2);
    element.length = number(head.data() + 4, 4);
    const bool explicit_here = element.tag >> 16U == 2 || (explicit_ && element.tag >> 16U != 0xFFFE);
    if (!explicit_here) return Step::element;
    const std::string_view kind(head.data() + 4, 2);
    if (std::isupper(static_cast<unsigned char>(kind[0])) == 0 ||
        std::isupper(static_cast<unsigned char>(kind[1])) == 0)
      return Step::unknown;
    static constexpr std::array<std::string_view, 13> long_form = {"OB", "OD", "OF", "OL", "OV", "OW", "SQ",
                                                                   "SV", "UC", "UN", "UR", "UT", "UV"};
    if (std::find(long_form.begin(), long_form.end(), kind) == long_form.end()) {
      element.length = number(head.data() + 6, 2);
      return Step::element;
    }
    std::array<char, 4> length{};
    if (!read(length.data(), length.size())) return Step::cut;
    element.length = number(length.data(), 4);
    return Step::element;
  }

  bool skip(std::uint64_t length) {
    if (size_ - place_ < length) return false;
    place_ += length;
    return true;
  }

  // Items to the end of a sequence of undefined length, or of the coded pieces of pixels.
  bool skip_sequence(int depth) {
    Element each;
    for (;;) {
      const Step step = depth > deepest_sequence ? Step::unknown : next(each);
      const bool odd = step == Step::element && each.tag != end_of_sequence && each.tag != item_tag;
      unknown_ = unknown_ || odd || step == Step::unknown;
      if (step != Step::element || odd) return false;
      if (each.tag == end_of_sequence) return true;
      if (each.length != undefined_length) {
        if (!skip(each.length)) return false;
        continue;
      }
      if (!skip_item(depth + 1)) return false;
    }
  }

  // Elements to the end of an item of undefined length.
  bool skip_item(int depth) {
    Element each;
    for (;;) {
      const Step step = next(each);
      if (step == Step::unknown) unknown_ = true;
      if (step != Step::element) return false;
      if (each.tag == end_of_item) return true;
      if (each.length == undefined_length ? !skip_sequence(depth + 1) : !skip(each.length)) return false;
    }
  }

  // False for packed or big endian data, which are not parsed.
  bool read_syntax(const Element& element) {
    std::string text(std::min<std::uint32_t>(element.length, 64), '\0');
    const std::uint64_t before = place_;
    if (!read(text.data(), text.size())) return true;
    place_ = before;
    text.erase(std::find(text.begin(), text.end(), '\0'), text.end());
    if (text == "1.2.840.10008.1.2.1.99" || text == "1.2.840.10008.1.2.2") return false;
    explicit_ = text != "1.2.840.10008.1.2";
    return true;
  }

  std::ifstream stream_;
  std::uint64_t size_ = 0, place_ = 0;
  bool explicit_ = false;  // until the meta information says so
  bool unknown_ = false;
};

}  // namespace

DicomExtent dicom_extent(const std::filesystem::path& file) {
  return Walker(file).run();
}

}  // namespace bodkin::io
