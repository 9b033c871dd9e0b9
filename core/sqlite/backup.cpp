// SPDX-License-Identifier: MIT
#include "core/sqlite/backup.hpp"

#include <memory>

#include <sqlite3.h>

#include "core/base/error.hpp"
#include "core/sqlite/connection.hpp"

namespace planum::sqlite {

namespace {

constexpr int kPagesAStep = 2000;

struct Finish {
    void operator()(sqlite3_backup* backup) const noexcept { sqlite3_backup_finish(backup); }
};

} // namespace

void copy_database(const Database& source, const std::filesystem::path& target, Progress& progress) {
    const Database copy = Database::open(target, Access::Create);
    std::unique_ptr<sqlite3_backup, Finish> backup{sqlite3_backup_init(copy.native(), "main", source.native(), "main")};
    if (!backup) throw error_of(copy.connection(), sqlite3_extended_errcode(copy.native()));
    int result = SQLITE_OK;
    while (result == SQLITE_OK) {
        progress.check();
        result = sqlite3_backup_step(backup.get(), kPagesAStep);
        const int pages = sqlite3_backup_pagecount(backup.get());
        const int remaining = sqlite3_backup_remaining(backup.get());
        if (pages > 0) progress.fraction(static_cast<double>(pages - remaining) / pages);
    }
    if (result != SQLITE_DONE) throw error_of(copy.connection(), result);
    result = sqlite3_backup_finish(backup.release());
    if (result != SQLITE_OK) throw error_of(copy.connection(), result);
}

} // namespace planum::sqlite
