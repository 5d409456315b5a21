#pragma once

#include <span>

#include "training/store/sql_connection.h"

namespace bodkin::training {

// The statements that lead from one version of the tables to the next. Each is the same for every database. A
// released migration is never changed: another one is added.
using Migration = std::span<const char* const>;
std::span<const Migration> migrations();

// The version that this program knows: as many as there are migrations.
int newest_store_version();
// That of a store; 0: it is empty.
int store_version(SqlConnection& connection);

// Leads a store to version `wanted`, in one change. Throws InputError when it is newer than this program: it is left
// as it is.
void migrate(SqlConnection& connection, int wanted);

}  // namespace bodkin::training
