#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "fem/solid/condensed_cache.h"
#include "fem/solid/contact_body.h"

namespace bodkin::fem {

// Writes a body's factor and the digest of what it was made of to one file, whole or not at all. Throws SystemError.
void save_factor(const std::filesystem::path& file, const PackedFactor& factor, const BodyDigest& digest);

// The same factor to the last bit, whose numbers stay in the file (MappedFile). All of it is read once, for its
// checksum. Throws InputError, one sentence, when the file is not there, is not of this format, is of another
// version, is damaged or cut off, or belongs to a body with another digest.
PackedFactor load_factor(const std::filesystem::path& file, const BodyDigest& digest);

// A body that a needle can enter anywhere, with its factor from the cache or, when that does not have it, checked,
// factorised and put there; an empty `file` is no cache. `note` hears the warnings of the check, and one sentence
// when a file had to be passed over or none was written; it may be empty. Throws what check_body() and ContactBody
// do.
std::shared_ptr<const ContactBody> contact_body_with_cache(const std::filesystem::path& file,
                                                           const std::shared_ptr<const BodyDescription>& body,
                                                           const Progress& progress = {},
                                                           const std::function<void(const std::string&)>& note = {});

}  // namespace bodkin::fem
