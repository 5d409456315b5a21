#include "io/mesh/vtu_array.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <type_traits>

#include <fmt/format.h>
#include <zlib.h>

#include "core/error.h"
#include "io/xml_document.h"

namespace bodkin::io {
namespace {

static_assert(std::endian::native == std::endian::little, "binary VTK data is read as this machine stores numbers");

struct NumberType {
  const char* name;
  std::size_t bytes;
  bool whole;
};
constexpr std::array<NumberType, 10> number_types = {{{"Int8", 1, true},
                                                      {"UInt8", 1, true},
                                                      {"Int16", 2, true},
                                                      {"UInt16", 2, true},
                                                      {"Int32", 4, true},
                                                      {"UInt32", 4, true},
                                                      {"Int64", 8, true},
                                                      {"UInt64", 8, true},
                                                      {"Float32", 4, false},
                                                      {"Float64", 8, false}}};
constexpr std::size_t most_packed = 1040;  // zlib makes no more bytes than that of one

const NumberType* type_of(std::string_view name) {
  const auto found = std::find_if(number_types.begin(), number_types.end(),
                                  [&](const NumberType& type) { return type.name == name; });
  return found == number_types.end() ? nullptr : &*found;
}

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

// The bytes of base64 text, which may be several encoded pieces with their own padding one after the other.
class Base64 {
 public:
  Base64(std::string_view text, const std::string& where) : text_(text), where_(where) {}

  // The next `count` bytes, which end a piece.
  std::string take(std::size_t count) {
    if (count > text_.size()) fail_short();
    std::string bytes;
    bytes.reserve(count + 2);
    while (bytes.size() < count) {
      std::uint32_t group = 0;
      int given = 0;
      for (int i = 0; i < 4; ++i) {
        const char c = next();
        const int value = value_of(c);
        if (c != '=' && value < 0)
          throw InputError(fmt::format("{}: {} is not base64", where_, in_quotes(std::string_view(&c, 1))));
        group = group << 6U | static_cast<std::uint32_t>(c == '=' ? 0 : value);
        if (c != '=') ++given;
      }
      for (int i = 0; i + 1 < given; ++i) bytes += static_cast<char>(group >> (16 - 8 * i) & 0xFFU);
      if (given < 4) break;
    }
    if (bytes.size() < count) fail_short();
    bytes.resize(count);
    return bytes;
  }

 private:
  [[noreturn]] void fail_short() const { throw InputError(fmt::format("{}: the data ends too early", where_)); }
  char next() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
    if (at_ == text_.size()) fail_short();
    return text_[at_++];
  }
  static int value_of(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : (c == '/' ? 63 : -1);
  }

  std::string_view text_;
  const std::string& where_;
  std::size_t at_ = 0;
};

// Bytes as they are.
class Raw {
 public:
  Raw(std::string_view bytes, const std::string& where) : bytes_(bytes), where_(where) {}
  std::string take(std::size_t count) {
    if (count > bytes_.size()) throw InputError(fmt::format("{}: the data ends too early", where_));
    std::string piece(bytes_.substr(0, count));
    bytes_.remove_prefix(count);
    return piece;
  }

 private:
  std::string_view bytes_;
  const std::string& where_;
};

std::vector<std::uint64_t> sizes_in(const std::string& bytes, bool is_long) {
  const std::size_t width = is_long ? 8 : 4;
  std::vector<std::uint64_t> sizes(bytes.size() / width, 0);
  for (std::size_t i = 0; i < sizes.size(); ++i) std::memcpy(&sizes[i], bytes.data() + i * width, width);
  return sizes;
}

std::string unpack(const std::string& packed, std::size_t size, const std::string& where) {
  if (size > packed.size() * most_packed + 64)
    throw InputError(fmt::format("{}: a packed block says that it holds {} bytes, which is impossible", where, size));
  std::string bytes(size, '\0');
  uLongf written = size;
  const int outcome = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &written,
                                 reinterpret_cast<const Bytef*>(packed.data()), packed.size());
  if (outcome != Z_OK || written != size) throw InputError(fmt::format("{}: a packed block is damaged", where));
  return bytes;
}

// The bytes of a binary array: a header with sizes, then the data. base64 encodes the header as a piece of its own
// when the data is packed, and with the data otherwise.
template <typename Source>
std::string payload(Source source, const VtuStorage& storage, std::size_t most, bool joined, const Source& again,
                    const std::string& where) {
  const std::size_t width = storage.long_headers ? 8 : 4;
  const auto too_large = [&](std::uint64_t size) {
    throw InputError(fmt::format("{}: the data says that it has {} bytes, expected at most {}", where, size, most));
  };
  if (!storage.packed) {
    const std::uint64_t size = sizes_in(source.take(width), storage.long_headers).front();
    if (size > most) too_large(size);
    if (!joined) return source.take(size);
    Source whole = again;
    return whole.take(width + size).substr(width);
  }
  Source head = source;
  const std::uint64_t blocks = sizes_in(head.take(3 * width), storage.long_headers).front();
  if (blocks > most) too_large(blocks);
  const std::vector<std::uint64_t> sizes =
      sizes_in(source.take((3 + static_cast<std::size_t>(blocks)) * width), storage.long_headers);
  // The stated size of a whole block may exceed the data (writers state their usual one), and incompressible data can
  // grow.
  const std::uint64_t block = sizes[1], last = sizes[2];
  const std::uint64_t most_packed_size = most * 2 + 65536;
  std::string packed_all, bytes;
  std::uint64_t packed_size = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    if (sizes[3 + b] > most_packed_size - packed_size) too_large(sizes[3 + b]);
    packed_size += sizes[3 + b];
  }
  packed_all = source.take(packed_size);
  std::size_t at = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t size = b + 1 == blocks && last != 0 ? last : block;
    if (size > most - bytes.size()) too_large(size);
    bytes += unpack(packed_all.substr(at, sizes[3 + b]), size, where);
    at += sizes[3 + b];
  }
  return bytes;
}

template <typename Value, typename Stored>
void convert(const std::string& bytes, std::vector<Value>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    Stored stored;
    std::memcpy(&stored, bytes.data() + i * sizeof stored, sizeof stored);
    values[i] = static_cast<Value>(stored);
  }
}

template <typename Value>
std::vector<Value> from_bytes(const std::string& bytes, const NumberType& type, const std::string& where) {
  if (bytes.size() % type.bytes != 0) {
    throw InputError(
        fmt::format("{}: the data has {} bytes, which is not a whole number of {}", where, bytes.size(), type.name));
  }
  std::vector<Value> values(bytes.size() / type.bytes);
  const std::string_view name = type.name;
  if (name == "Int8") convert<Value, std::int8_t>(bytes, values);
  if (name == "UInt8") convert<Value, std::uint8_t>(bytes, values);
  if (name == "Int16") convert<Value, std::int16_t>(bytes, values);
  if (name == "UInt16") convert<Value, std::uint16_t>(bytes, values);
  if (name == "Int32") convert<Value, std::int32_t>(bytes, values);
  if (name == "UInt32") convert<Value, std::uint32_t>(bytes, values);
  if (name == "Int64") convert<Value, std::int64_t>(bytes, values);
  if (name == "UInt64") convert<Value, std::uint64_t>(bytes, values);
  if constexpr (std::is_same_v<Value, double>) {
    if (name == "Float32") convert<Value, float>(bytes, values);
    if (name == "Float64") convert<Value, double>(bytes, values);
  }
  return values;
}

template <typename Value>
std::vector<Value> from_ascii(std::string_view text, std::size_t most, const std::string& where) {
  std::vector<Value> values;
  for (std::size_t at = 0;;) {
    while (at < text.size() && is_space(text[at])) ++at;
    if (at == text.size()) return values;
    const std::size_t begin = at;
    while (at < text.size() && !is_space(text[at])) ++at;
    const std::string_view word = text.substr(begin, at - begin);
    Value value{};
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (problem != std::errc() || end != word.data() + word.size()) {
      throw InputError(fmt::format("{}: value {} is {}, expected a {}number", where, values.size() + 1,
                                   in_quotes(word), std::is_same_v<Value, double> ? "" : "whole "));
    }
    if (values.size() == most) throw InputError(fmt::format("{}: there are more than {} values", where, most));
    values.push_back(value);
  }
}

template <typename Value>
std::vector<Value> values_of(const VtuArray& array, const VtuStorage& storage, const VtuAppended& appended,
                             std::size_t expected, std::size_t most, const std::string& origin) {
  const std::string where = fmt::format("{}: the array '{}'", origin, one_line(array.name));
  const NumberType* type = type_of(array.type);
  if (type == nullptr || (!std::is_same_v<Value, double> && !type->whole)) {
    throw InputError(fmt::format("{} has the type {}, expected one of {}numbers such as {}", where,
                                 in_quotes(array.type), std::is_same_v<Value, double> ? "" : "whole ",
                                 std::is_same_v<Value, double> ? "Float64" : "Int64"));
  }
  std::vector<Value> values;
  if (array.format == "ascii") {
    values = from_ascii<Value>(array.text, most, where);
  } else if (storage.big_endian) {
    throw InputError(fmt::format("{} is stored as big-endian binary, expected little-endian or ascii", where));
  } else if (array.format == "binary") {
    const Base64 source(array.text, where);
    values = from_bytes<Value>(payload(source, storage, most * type->bytes, true, source, where), *type, where);
  } else if (array.format == "appended") {
    if (array.offset >= appended.bytes.size())
      throw InputError(fmt::format("{} begins at {}, behind the end of the appended data", where, array.offset));
    const std::string_view rest = appended.bytes.substr(array.offset);
    const auto read = [&](const auto& source, bool joined) {
      return payload(source, storage, most * type->bytes, joined, source, where);
    };
    values = from_bytes<Value>(appended.raw ? read(Raw(rest, where), false) : read(Base64(rest, where), true), *type,
                               where);
  } else {
    throw InputError(
        fmt::format("{} has the format {}, expected ascii, binary or appended", where, in_quotes(array.format)));
  }
  if (expected != 0 && values.size() != expected)
    throw InputError(fmt::format("{} has {} values, expected {}", where, values.size(), expected));
  return values;
}

}  // namespace

std::vector<double> vtu_numbers(const VtuArray& array, const VtuStorage& storage, const VtuAppended& appended,
                                std::size_t expected, std::size_t most, const std::string& where) {
  return values_of<double>(array, storage, appended, expected, most, where);
}

std::vector<std::int64_t> vtu_wholes(const VtuArray& array, const VtuStorage& storage, const VtuAppended& appended,
                                     std::size_t expected, std::size_t most, const std::string& where) {
  return values_of<std::int64_t>(array, storage, appended, expected, most, where);
}

bool is_whole_type(std::string_view type) {
  const NumberType* found = type_of(type);
  return found != nullptr && found->whole;
}

}  // namespace bodkin::io
