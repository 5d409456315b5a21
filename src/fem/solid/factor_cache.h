#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "fem/solid/condensed_cache.h"
#include "fem/solid/contact_body.h"

namespace bodkin::fem {

// Writes a body's factor and the digest of the body to one file, atomically. Throws SystemError.
void save_factor(const std::filesystem::path& file, const PackedFactor& factor, const BodyDigest& digest);

// The same factor to the last bit, whose numbers stay in the file (MappedFile). The whole file is read once, for its
// checksum. Throws InputError, one sentence, when the file does not exist, has another format or version, is damaged
// or truncated, or belongs to a body with another digest.
PackedFactor load_factor(const std::filesystem::path& file, const BodyDigest& digest);

// A body that a needle can enter anywhere, with its factor from the cache or, if that does not have it, checked,
// factorised and stored; an empty `file` means no cache. `note` receives the warnings of the check, and one sentence
// when a file was rejected or none was written; it may be empty. Throws what check_body() and ContactBody throw.
std::shared_ptr<const ContactBody> contact_body_with_cache(const std::filesystem::path& file,
                                                           const std::shared_ptr<const BodyDescription>& body,
                                                           const Progress& progress = {},
                                                           const std::function<void(const std::string&)>& note = {});

}  // namespace bodkin::fem
