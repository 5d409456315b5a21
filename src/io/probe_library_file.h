#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/ultrasound_probe.h"

namespace bodkin::io {

// Reads ultrasound probes (share/bodkin/probes.xml shows the format, with sources). At least one; every one passes
// check(). Throws InputError naming file, line, attribute, what was found and what was expected.
std::vector<anatomy::UltrasoundProbe> read_probes(const std::filesystem::path& file);

// The same from a document already in memory; `origin` names it in messages.
std::vector<anatomy::UltrasoundProbe> parse_probes(std::string_view document, const std::string& origin);

// A document with these probes, which parse_probes() reads back to the same bits.
std::string probes_xml(std::span<const anatomy::UltrasoundProbe> probes);

// The probes that come with Bodkin. Throws SystemError when the installation lacks them.
std::vector<anatomy::UltrasoundProbe> default_probes();

// The probe of that name, ignoring case. Throws InputError, which lists the known names, when the library has no such
// probe.
const anatomy::UltrasoundProbe& find_probe(std::span<const anatomy::UltrasoundProbe> probes, std::string_view name);
// As above, among the probes that come with Bodkin.
anatomy::UltrasoundProbe find_probe(std::string_view name);

}  // namespace bodkin::io
