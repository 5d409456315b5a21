#pragma once

#include <filesystem>
#include <string>

namespace bodkin::training {

// The store that is meant: `given`; where it is empty, that of the environment variable BODKIN_STORE; or else
// results.sqlite in the person's data folder, which is made. Throws SystemError when that cannot be.
std::string store_place(const std::string& given = {});

// Where attempts of this station wait for stores: the folder outbox in the data folder, which is made.
std::filesystem::path outbox_folder();

}  // namespace bodkin::training
