#include "fem/solid/condensed_cache.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"
#include "core/files.h"
#include "fem/solid/dense_kernels.h"
#include "fem/zero_pages.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace bodkin::fem {

namespace {

namespace fs = std::filesystem;

constexpr std::array<char, 8> file_magic = {'B', 'O', 'D', 'K', 'I', 'N', 'C', 'B'};
constexpr std::uint32_t file_version = 3;  // of the file and of the computation behind it
constexpr std::uint32_t byte_order = 0x01020304;
constexpr std::uint64_t most_nodes = 1U << 20U;

// The first bytes of the file, followed by the nodes, 3 numbers each; their names in the mesh; their tissues; the
// lower triangle of the compliance, column by column.
struct CacheHeader {
  std::array<char, 8> magic = file_magic;
  std::uint32_t version = file_version;
  std::uint32_t order = byte_order;
  std::uint64_t digest_high = 0, digest_low = 0;
  std::uint64_t nodes = 0;
  std::uint64_t checksum = 0;  // XXH3 of this header, with checksum 0, and of the rest
};
static_assert(sizeof(CacheHeader) == 48, "the header must have no padding");

std::uint64_t file_size(std::uint64_t nodes) {
  return sizeof(CacheHeader) + nodes * (sizeof(Vec3) + sizeof(std::uint32_t) + sizeof(anatomy::TissueId)) +
         sizeof(double) * (3 * nodes * (3 * nodes + 1) / 2);
}

// An incremental hash.
class Hash {
 public:
  Hash() : state_(XXH3_createState()) { XXH3_128bits_reset(state_.get()); }
  void add(const void* bytes, std::size_t count) { XXH3_128bits_update(state_.get(), bytes, count); }
  template <typename Value>
  void add(const std::vector<Value>& values) {
    const std::uint64_t count = values.size();
    add(&count, sizeof count);
    add(values.data(), values.size() * sizeof(Value));
  }
  XXH128_hash_t value() const { return XXH3_128bits_digest(state_.get()); }

 private:
  struct Freed {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
  };
  std::unique_ptr<XXH3_state_t, Freed> state_;
};

// A file that is read and hashed from beginning to end.
class HashedFile {
 public:
  explicit HashedFile(const fs::path& file) : name_(file.string()), stream_(file, std::ios::binary) {
    if (!stream_) throw InputError(name_ + " cannot be opened; is it there, and may you read it?");
  }
  void read(void* bytes, std::size_t count) {
    stream_.read(static_cast<char*>(bytes), static_cast<std::streamsize>(count));
    if (!stream_) throw InputError(name_ + " is cut off; remove it, it is only a cache");
  }
  void read_and_hash(void* bytes, std::size_t count) {
    read(bytes, count);
    hash.add(bytes, count);
  }
  Hash hash;

 private:
  std::string name_;
  std::ifstream stream_;
};

void check_header(const std::string& name, std::uint64_t size, const CacheHeader& header, const BodyDigest& digest) {
  if (header.magic != file_magic) throw InputError(name + " is not a condensed body of Bodkin; name another file");
  if (header.version != file_version || header.order != byte_order) {
    throw InputError(
        fmt::format("{} was written by another version of Bodkin or on another kind of machine; remove it, "
                    "it is only a cache",
                    name));
  }
  if (BodyDigest{header.digest_high, header.digest_low} != digest) {
    throw InputError(
        fmt::format("{} belongs to another body: the mesh, the materials, what is fixed or the corridor "
                    "are different; remove it, it is only a cache",
                    name));
  }
  if (header.nodes > most_nodes || size != file_size(header.nodes)) {
    throw InputError(fmt::format("{} is damaged: it has {} bytes, which is impossible; remove it, it is only a cache",
                                 name, size));
  }
}

}  // namespace

BodyDigest digest_of(const BodyDescription& body) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(body.mesh.elements[0]) == 16,
                "no padding may be hashed");
  Hash hash;
  hash.add(&file_version, sizeof file_version);
  hash.add(body.mesh.nodes);
  hash.add(body.mesh.elements);
  hash.add(body.mesh.tissues);
  std::array<bool, 256> met{};
  for (const anatomy::TissueId tissue : body.mesh.tissues) met[tissue] = true;
  for (std::size_t tissue = 0; tissue < met.size(); ++tissue) {
    const ElasticMaterial* material = body.materials.find(static_cast<anatomy::TissueId>(tissue));
    if (!met[tissue] || material == nullptr) continue;
    const std::array<double, 3> values = {static_cast<double>(tissue), material->young, material->poisson};
    hash.add(values.data(), sizeof values);
    if (!material->has_fibres()) continue;
    const std::array<double, 5> along = {material->young_along, material->shear_along, material->fibre.x(),
                                         material->fibre.y(), material->fibre.z()};
    hash.add(along.data(), sizeof along);
  }
  std::vector<std::uint32_t> fixed = body.fixed;
  std::sort(fixed.begin(), fixed.end());
  fixed.erase(std::unique(fixed.begin(), fixed.end()), fixed.end());
  hash.add(fixed);
  hash.add(body.corridor);
  const XXH128_hash_t value = hash.value();
  return {value.high64, value.low64};
}

void save_condensed(const fs::path& file, const anatomy::CondensedBody& body, const BodyDigest& digest) {
  CacheHeader header;
  header.digest_high = digest.high;
  header.digest_low = digest.low;
  header.nodes = body.nodes.size();
  std::string bytes;
  bytes.reserve(file_size(header.nodes));
  const auto append = [&bytes](const void* from, std::size_t count) {
    bytes.append(static_cast<const char*>(from), count);
  };
  append(&header, sizeof header);
  append(body.nodes.data(), body.nodes.size() * sizeof(Vec3));
  append(body.mesh_nodes.data(), body.mesh_nodes.size() * sizeof(std::uint32_t));
  append(body.tissues.data(), body.tissues.size() * sizeof(anatomy::TissueId));
  const Eigen::Index size = body.compliance.rows();
  for (Eigen::Index column = 0; column < size; ++column)
    append(&body.compliance(column, column), static_cast<std::size_t>(size - column) * sizeof(double));
  Hash hash;
  hash.add(bytes.data(), bytes.size());
  header.checksum = hash.value().low64;
  std::memcpy(bytes.data(), &header, sizeof header);
  write_file(file, bytes);
}

anatomy::CondensedBody load_condensed(const fs::path& file, const BodyDigest& digest) {
  HashedFile stream(file);
  const std::string name = file.string();
  CacheHeader header;
  stream.read(&header, sizeof header);
  std::error_code problem;
  check_header(name, fs::file_size(file, problem), header, digest);
  const std::uint64_t checksum = header.checksum;
  header.checksum = 0;
  stream.hash.add(&header, sizeof header);

  anatomy::CondensedBody body;
  body.nodes.resize(header.nodes);
  body.mesh_nodes.resize(header.nodes);
  body.tissues.resize(header.nodes);
  stream.read_and_hash(body.nodes.data(), body.nodes.size() * sizeof(Vec3));
  stream.read_and_hash(body.mesh_nodes.data(), body.mesh_nodes.size() * sizeof(std::uint32_t));
  stream.read_and_hash(body.tissues.data(), body.tissues.size() * sizeof(anatomy::TissueId));
  const auto size = static_cast<Eigen::Index>(3 * header.nodes);
  body.compliance.resize(size, size);
  prefer_large_pages(body.compliance.data(), sizeof(double) * static_cast<std::size_t>(body.compliance.size()));
  for (Eigen::Index column = 0; column < size; ++column)
    stream.read_and_hash(&body.compliance(column, column), static_cast<std::size_t>(size - column) * sizeof(double));
  if (stream.hash.value().low64 != checksum) {
    throw InputError(name + " is damaged: its checksum is not that of its contents; remove it, it is only a cache");
  }
  mirror_lower(static_cast<std::size_t>(size), body.compliance.data(), static_cast<std::size_t>(size));
  return body;
}

anatomy::CondensedBody condensed_with_cache(const fs::path& file, const BodyDescription& body,
                                            const FactorOptions& options, const Progress& progress,
                                            const std::function<void(const std::string&)>& note) {
  const BodyDigest digest = digest_of(body);
  std::error_code problem;
  if (fs::exists(file, problem)) {
    try {
      return load_condensed(file, digest);
    } catch (const InputError& error) {
      if (note) note(std::string("the body is prepared again, because ") + error.what());
    }
  }
  anatomy::CondensedBody condensed = condense(body, options, progress, note);
  try {
    save_condensed(file, condensed, digest);
  } catch (const SystemError& error) {
    if (note) note(std::string("the prepared body is not kept for the next time, because ") + error.what());
  }
  return condensed;
}

}  // namespace bodkin::fem
