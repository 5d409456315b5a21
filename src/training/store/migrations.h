#pragma once

#include <span>

#include "training/store/sql_connection.h"

namespace bodkin::training {

// The statements that convert one version of the tables to the next. They are the same for every database. A released
// migration is never changed: new ones are added.
using Migration = std::span<const char* const>;
std::span<const Migration> migrations();

// The version supported by this program: the number of migrations.
int newest_store_version();
// The version of a store; 0: it is empty.
int store_version(SqlConnection& connection);

// Converts a store to version `wanted`, in one transaction. Throws InputError, without changing the store, when it is
// newer than this program.
void migrate(SqlConnection& connection, int wanted);

}  // namespace bodkin::training
