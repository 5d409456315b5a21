#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "fem/solid/elastic_body.h"

namespace bodkin::fem {

// A fingerprint of everything that a condensed body depends on: the mesh, the materials of its tissues, what is fixed
// and the corridor in its order. XXH3, 128 bits: it finds accidents, not attacks.
struct BodyDigest {
  std::uint64_t high = 0, low = 0;
  bool operator==(const BodyDigest&) const = default;
};

BodyDigest digest_of(const BodyDescription& body);

// Writes a condensed body and the digest of what it was made of to one file, whole or not at all. Throws SystemError.
void save_condensed(const std::filesystem::path& file, const anatomy::CondensedBody& body, const BodyDigest& digest);

// Reads it back, the same to the last bit. Throws InputError, one sentence, when the file is not there, is not of
// this format, is of another version, is damaged or cut off, or belongs to a body with another digest.
anatomy::CondensedBody load_condensed(const std::filesystem::path& file, const BodyDigest& digest);

// The condensed body from the cache or, when that does not have it, prepared by condense() and put there. `note`
// hears what condense() notes, and one sentence when a file had to be passed over or could not be written; it may be
// empty. Throws what condense() does.
anatomy::CondensedBody condensed_with_cache(const std::filesystem::path& file, const BodyDescription& body,
                                            const FactorOptions& options = {}, const Progress& progress = {},
                                            const std::function<void(const std::string&)>& note = {});

}  // namespace bodkin::fem
