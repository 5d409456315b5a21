#pragma once

#include <filesystem>
#include <string>

namespace bodkin::training {

// The store to use: `given`; if empty, that of the environment variable BODKIN_STORE; or else results.sqlite in the
// person's data folder, which is created. Throws SystemError when that is impossible.
std::string store_place(const std::string& given = {});

// The folder of this station's waiting attempts: outbox in the data folder, which is created.
std::filesystem::path outbox_folder();

}  // namespace bodkin::training
