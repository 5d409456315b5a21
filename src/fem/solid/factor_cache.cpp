#include "fem/solid/factor_cache.h"

#include <array>
#include <cstring>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"
#include "core/files.h"
#include "fem/solid/body_digests.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace bodkin::fem {

namespace {

namespace fs = std::filesystem;

constexpr std::array<char, 8> factor_magic = {'B', 'O', 'D', 'K', 'I', 'N', 'F', 'A'};
constexpr std::uint32_t factor_version = 1;  // of the file and of the computation behind it
constexpr std::uint32_t factor_byte_order = 0x01020304;
constexpr std::uint64_t most_free_nodes = 1U << 21U;
constexpr std::uint64_t most_rows = 1ULL << 32U;
constexpr std::size_t page = 4096;  // alignment of the numbers

// The first bytes of the file, followed by the order of elimination, the supernodes' sizes, their rows, and, from the
// next page on, the factor's numbers.
struct FactorHeader {
  std::array<char, 8> magic = factor_magic;
  std::uint32_t version = factor_version;
  std::uint32_t order = factor_byte_order;
  std::uint64_t digest_high = 0, digest_low = 0;
  std::uint64_t nodes = 0, supernodes = 0, rows = 0, numbers = 0;
  std::uint64_t numbers_digest = 0;  // digest_of(PackedFactor)
  std::uint64_t checksum = 0;        // XXH3 of this header, with checksum 0, and of all up to the numbers
};
static_assert(sizeof(FactorHeader) == 80, "the header must have no padding");
static_assert(sizeof(FactorLayout::Size) == 8, "no padding may be hashed");

std::uint64_t numbers_begin(const FactorHeader& header) {
  const std::uint64_t layout = sizeof(FactorHeader) + sizeof(std::uint32_t) * (header.nodes + header.rows) +
                               sizeof(FactorLayout::Size) * header.supernodes;
  return (layout + page - 1) / page * page;
}

template <typename Value>
std::string_view bytes_of(std::span<const Value> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

// Copied from the file's bytes at `at`, which is then moved past them.
template <typename Value>
std::vector<Value> values_at(std::span<const std::byte> bytes, std::size_t count, std::size_t& at) {
  std::vector<Value> values(count);
  if (count > 0) std::memcpy(values.data(), bytes.data() + at, count * sizeof(Value));
  at += count * sizeof(Value);
  return values;
}

// Appends the advice that ends the sentence.
[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw InputError(fmt::format("{} {}; remove it, it is only a cache", file.string(), why));
}

FactorHeader header_of(const fs::path& file, std::span<const std::byte> bytes, const BodyDigest& digest) {
  FactorHeader header;
  if (bytes.size() < sizeof header) refuse(file, "is cut off");
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.magic != factor_magic) throw InputError(file.string() + " is not a factor of Bodkin; name another file");
  if (header.version != factor_version || header.order != factor_byte_order)
    refuse(file, "was written by another version of Bodkin or on another kind of machine");
  if (BodyDigest{header.digest_high, header.digest_low} != digest)
    refuse(file, "belongs to another body: the mesh, the materials or what is fixed are different");
  // With counts below these nothing can overflow.
  const bool possible = header.nodes <= most_free_nodes && header.supernodes <= header.nodes &&
                        header.rows <= most_rows && header.numbers <= bytes.size() / sizeof(double);
  if (!possible || numbers_begin(header) + sizeof(double) * header.numbers != bytes.size())
    refuse(file, fmt::format("is damaged: it has {} bytes, which is impossible", bytes.size()));
  FactorHeader without_checksum = header;
  without_checksum.checksum = 0;
  std::string begin(reinterpret_cast<const char*>(bytes.data()), numbers_begin(header));
  std::memcpy(begin.data(), &without_checksum, sizeof without_checksum);
  if (XXH3_64bits(begin.data(), begin.size()) != header.checksum)
    refuse(file, "is damaged: its checksum is not that of its contents");
  return header;
}

FactorLayout layout_in(const fs::path& file, std::span<const std::byte> bytes, const FactorHeader& header) {
  std::size_t at = sizeof header;
  std::vector<std::uint32_t> position = values_at<std::uint32_t>(bytes, header.nodes, at);
  const std::vector<FactorLayout::Size> sizes = values_at<FactorLayout::Size>(bytes, header.supernodes, at);
  std::vector<std::uint32_t> rows = values_at<std::uint32_t>(bytes, header.rows, at);
  try {
    FactorLayout layout(std::move(position), sizes, std::move(rows));
    if (layout.numbers != header.numbers) throw InputError("it has not as many numbers as its supernodes need");
    return layout;
  } catch (const InputError& error) {
    refuse(file, std::string("is damaged: ") + error.what());
  }
}

// Nothing, or why the factor is not stored: recomputable data must not fill the disk.
std::string reason_against(const fs::path& file, const PackedFactor& factor) {
  std::error_code problem;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const fs::space_info space = fs::space(folder, problem);
  if (problem || space.available / 2 > factor.bytes()) return {};
  return fmt::format("it takes {:.2f} GB of the {:.2f} GB that are free in {}",
                     1e-9 * static_cast<double>(factor.bytes()), 1e-9 * static_cast<double>(space.available),
                     folder.string());
}

std::string not_kept(const fs::path& file, const PackedFactor& factor, const BodyDigest& digest) {
  if (std::string reason = reason_against(file, factor); !reason.empty()) return reason;
  try {
    save_factor(file, factor, digest);
    return {};
  } catch (const SystemError& error) {
    return error.what();
  }
}

}  // namespace

void save_factor(const fs::path& file, const PackedFactor& factor, const BodyDigest& digest) {
  const FactorLayout& layout = factor.layout();
  std::vector<FactorLayout::Size> sizes;
  for (const FactorLayout::Part& part : layout.parts) sizes.push_back({part.columns, part.rows});
  FactorHeader header;
  header.digest_high = digest.high;
  header.digest_low = digest.low;
  header.nodes = layout.position.size();
  header.supernodes = sizes.size();
  header.rows = layout.rows.size();
  header.numbers = layout.numbers;
  header.numbers_digest = digest_of(factor);
  std::string begin;
  begin.reserve(numbers_begin(header));
  begin.append(bytes_of(std::span<const FactorHeader>(&header, 1)));
  begin.append(bytes_of(std::span<const std::uint32_t>(layout.position)));
  begin.append(bytes_of(std::span<const FactorLayout::Size>(sizes)));
  begin.append(bytes_of(std::span<const std::uint32_t>(layout.rows)));
  begin.resize(numbers_begin(header), '\0');
  header.checksum = XXH3_64bits(begin.data(), begin.size());
  std::memcpy(begin.data(), &header, sizeof header);
  write_file(file, std::array<std::string_view, 2>{begin, bytes_of(factor.numbers())});
}

PackedFactor load_factor(const fs::path& file, const BodyDigest& digest) {
  MappedFile mapped(file);
  const FactorHeader header = header_of(file, mapped.bytes(), digest);
  FactorLayout layout = layout_in(file, mapped.bytes(), header);
  PackedFactor factor(std::move(layout), std::move(mapped), numbers_begin(header));
  if (digest_of(factor) != header.numbers_digest)
    refuse(file, "is damaged: its checksum is not that of its contents");
  return factor;
}

std::shared_ptr<const ContactBody> contact_body_with_cache(const fs::path& file,
                                                           const std::shared_ptr<const BodyDescription>& body,
                                                           const Progress& progress,
                                                           const std::function<void(const std::string&)>& note) {
  const auto report = [&note](const std::string& sentence) {
    if (note) note(sentence);
  };
  for (const std::string& warning : check_body(*body)) report(warning);
  BodyDigest digest;
  std::error_code problem;
  if (!file.empty()) digest = digest_of({body->mesh, body->materials, body->fixed, {}});
  if (!file.empty() && fs::exists(file, problem)) {
    try {
      return std::make_shared<const ContactBody>(body, load_factor(file, digest));
    } catch (const InputError& error) {
      report(std::string("the body is prepared again, because ") + error.what());
    }
  }
  auto whole = std::make_shared<const ContactBody>(body, FactorOptions{}, progress);
  if (file.empty()) return whole;
  if (progress) progress("keeping the prepared body", 0.0);
  const std::string reason = not_kept(file, whole->factor(), digest);
  if (!reason.empty()) report("the prepared body is not kept for the next time, because " + reason);
  return whole;
}

}  // namespace bodkin::fem
