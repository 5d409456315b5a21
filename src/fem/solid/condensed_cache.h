#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "fem/solid/elastic_body.h"

namespace bodkin::fem {

// A digest of everything that determines a condensed body: the mesh, the materials of its tissues, the fixed nodes,
// and the corridor in its order. XXH3, 128 bits: it detects accidents, not attacks.
struct BodyDigest {
  std::uint64_t high = 0, low = 0;
  bool operator==(const BodyDigest&) const = default;
};

BodyDigest digest_of(const BodyDescription& body);

// Writes a condensed body and the digest of its inputs to one file, atomically. Throws SystemError.
void save_condensed(const std::filesystem::path& file, const anatomy::CondensedBody& body, const BodyDigest& digest);

// Reads it back, equal to the last bit. Throws InputError, one sentence, when the file does not exist, has another
// format or version, is damaged or truncated, or belongs to a body with another digest.
anatomy::CondensedBody load_condensed(const std::filesystem::path& file, const BodyDigest& digest);

// The condensed body from the cache or, if it is not there, computed by condense() and stored. `note` receives the
// notes of condense(), and one sentence when a file was rejected or could not be written; it may be empty. Throws
// what condense() throws.
anatomy::CondensedBody condensed_with_cache(const std::filesystem::path& file, const BodyDescription& body,
                                            const FactorOptions& options = {}, const Progress& progress = {},
                                            const std::function<void(const std::string&)>& note = {});

}  // namespace bodkin::fem
