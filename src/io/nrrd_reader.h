#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "anatomy/volume.h"

namespace bodkin::io {

// Reads a volume written by write_nrrd(), in this process and without an imaging library: the header must be exactly
// Bodkin's own, its size must agree with the packed bytes before memory is allocated (at most the voxels and the file
// together), and the packed voxels must have the right length and checksum. The grid is to the bit the one that the
// image worker reads from the same file.
//
// Empty: the file does not have this form, or contains voxels of another type; the image worker reads such a file.
// Throws InputError, one sentence that names the file, when it has this form but is truncated or damaged, or cannot
// be read.
template <typename Voxel>
std::optional<anatomy::Volume<Voxel>> read_nrrd(const std::filesystem::path& file);

// As above, for the content of such a file, from nrrd_bytes(). `name` is the prefix of every message.
template <typename Voxel>
std::optional<anatomy::Volume<Voxel>> parse_nrrd(std::span<const std::uint8_t> bytes, const std::string& name);

extern template std::optional<anatomy::CtVolume> read_nrrd(const std::filesystem::path& file);
extern template std::optional<anatomy::LabelVolume> read_nrrd(const std::filesystem::path& file);
extern template std::optional<anatomy::TissueVolume> read_nrrd(const std::filesystem::path& file);
extern template std::optional<anatomy::LabelVolume> parse_nrrd(std::span<const std::uint8_t> bytes,
                                                               const std::string& name);
extern template std::optional<anatomy::TissueVolume> parse_nrrd(std::span<const std::uint8_t> bytes,
                                                                const std::string& name);

}  // namespace bodkin::io
