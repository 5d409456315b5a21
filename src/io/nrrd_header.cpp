#include "io/nrrd_header.h"

#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace bodkin::io {
namespace {

constexpr std::array<std::string_view, 3> voxel_types = {"short", "unsigned short", "unsigned char"};

std::string vector_text(const Vec3& v) {
  return fmt::format("({:.17g},{:.17g},{:.17g})", v.x(), v.y(), v.z());
}

// Reads a text from its start, piece by piece; once a piece is not as expected, failed() stays true.
class HeaderScanner {
 public:
  explicit HeaderScanner(std::string_view text) : text_(text) {}

  void expect(std::string_view piece) {
    if (text_.substr(position_).starts_with(piece))
      position_ += piece.size();
    else
      failed_ = true;
  }

  std::string_view one_of(const std::array<std::string_view, 3>& words) {
    for (const std::string_view word : words) {
      if (!text_.substr(position_).starts_with(word)) continue;
      position_ += word.size();
      return word;
    }
    failed_ = true;
    return {};
  }

  template <typename Number>
  Number number() {
    Number value{};
    const char* end = text_.data() + text_.size();
    const auto [stop, problem] = std::from_chars(text_.data() + position_, end, value);
    if (problem == std::errc())
      position_ = static_cast<std::size_t>(stop - text_.data());
    else
      failed_ = true;
    return value;
  }

  Vec3 vector() {
    Vec3 result;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      expect(axis == 0 ? "(" : ",");
      result[axis] = number<double>();
    }
    expect(")");
    return result;
  }

  bool failed() const { return failed_; }
  std::size_t position() const { return position_; }

 private:
  std::string_view text_;
  std::size_t position_ = 0;
  bool failed_ = false;
};

}  // namespace

std::string nrrd_header_text(const NrrdHeader& header) {
  return fmt::format(
      "NRRD0004\ntype: {}\ndimension: 3\nspace: left-posterior-superior\nsizes: {} {} {}\n"
      "space directions: {} {} {}\n"
      "kinds: domain domain domain\nendian: little\nencoding: gzip\nspace origin: {}\n\n",
      header.type, header.size[0], header.size[1], header.size[2], vector_text(header.steps.col(0)),
      vector_text(header.steps.col(1)), vector_text(header.steps.col(2)), vector_text(header.origin));
}

std::optional<ParsedNrrdHeader> parse_nrrd_header(std::string_view bytes) {
  HeaderScanner scanner(bytes.substr(0, longest_nrrd_header));
  NrrdHeader header;

  scanner.expect("NRRD0004\ntype: ");
  header.type = scanner.one_of(voxel_types);
  scanner.expect("\ndimension: 3\nspace: left-posterior-superior\nsizes:");
  for (int& count : header.size) {
    scanner.expect(" ");
    count = scanner.number<int>();
  }
  scanner.expect("\nspace directions:");
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    scanner.expect(" ");
    header.steps.col(axis) = scanner.vector();
  }
  scanner.expect("\nkinds: domain domain domain\nendian: little\nencoding: gzip\nspace origin: ");
  header.origin = scanner.vector();
  scanner.expect("\n\n");

  const bool positive = header.size[0] > 0 && header.size[1] > 0 && header.size[2] > 0;
  if (scanner.failed() || !positive || !header.steps.allFinite() || !header.origin.allFinite()) return std::nullopt;
  return ParsedNrrdHeader{header, scanner.position()};
}

}  // namespace bodkin::io
