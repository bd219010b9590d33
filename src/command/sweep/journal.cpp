#include "journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/magic.h>
#include <sqlite3.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <mutex>
#include <string_view>
#include <utility>

#include "run/sha256.hpp"

namespace libration {

namespace fs = std::filesystem;

namespace {

constexpr int journal_mark = 0x4c69624a;  // "LibJ", SQLite's application_id
constexpr int journal_format = 1;         // SQLite's user_version
constexpr std::ptrdiff_t bytes_of_sum = 8;
// An offset in the file far beyond its content: the process that holds its lock may write. SQLite's own locks are at
// 2^30.
constexpr off_t place_of_writers_lock = off_t{1} << 60;

[[noreturn]] void refuse_as(journal_error::fault kind, const fs::path& path, const std::string& reason) {
    throw journal_error(kind, path.string(), reason);
}

// The journal_error of a return code that SQLite gave.
[[noreturn]] void refuse_code(sqlite3* handle, const fs::path& path, int code) {
    const std::string said = handle != nullptr ? sqlite3_errmsg(handle) : sqlite3_errstr(code);
    switch (code & 0xff) {
        case SQLITE_BUSY:
        case SQLITE_LOCKED: refuse_as(journal_error::fault::in_use, path, "is in use by another run");
        case SQLITE_CORRUPT:
        case SQLITE_NOTADB: refuse_as(journal_error::fault::damaged, path, "is damaged (" + said + ")");
        default: refuse_as(journal_error::fault::unwritable, path, "cannot be written (" + said + ")");
    }
}

// File systems on which several machines do not share memory, which a write-ahead log needs.
bool is_of_network(const fs::path& folder) {
    struct statfs about {};
    if (::statfs(folder.empty() ? "." : folder.c_str(), &about) != 0) {
        return true;
    }
    constexpr std::array<unsigned long, 8> magics{NFS_SUPER_MAGIC,         SMB_SUPER_MAGIC, CIFS_SUPER_MAGIC,
                                                  SMB2_SUPER_MAGIC,        AFS_SUPER_MAGIC, CEPH_SUPER_MAGIC,
                                                  0x0bd00bd0 /* Lustre */, 0x47504653 /* GPFS */};
    const auto type = static_cast<std::uint32_t>(about.f_type);
    return std::find(magics.begin(), magics.end(), type) != magics.end();
}

// A descriptor of the file that holds the lock of its writer; -1 where it cannot be opened. Throws where another
// process holds it.
int locked_for_writing(const fs::path& path, int flags) {
    const int descriptor = ::open(path.c_str(), flags | O_RDWR | O_CLOEXEC, 0666);
    struct flock range {};
    range.l_type = F_WRLCK;
    range.l_whence = SEEK_SET;
    range.l_start = place_of_writers_lock;
    range.l_len = 1;
    if (descriptor >= 0 && ::fcntl(descriptor, F_OFD_SETLK, &range) != 0 && (errno == EAGAIN || errno == EACCES)) {
        ::close(descriptor);
        refuse_as(journal_error::fault::in_use, path, "is in use by another run");
    }
    return descriptor;
}

// What a record must come back as.
std::string sum_of(const journal_record& record) {
    std::string all(record.key.begin(), record.key.end());
    all += fmt::format("{} {} {}:", static_cast<int>(record.failed), record.attempts, record.inputs.size());
    const auto digest = sha256_digest(all + record.inputs + record.content);
    return {digest.begin(), digest.begin() + bytes_of_sum};
}

}  // namespace

cell_key key_of(const std::string& words) {
    const auto digest = sha256_digest(words);
    cell_key key{};
    std::copy_n(digest.begin(), key.size(), key.begin());
    return key;
}

// The handle of SQLite with what holds it. Calls hold the mutex.
struct journal::database {
    // One SQL statement, prepared once.
    class statement {
    public:
        statement(const database& in, const char* sql) : in_(in) {
            in.require(sqlite3_prepare_v3(in.handle, sql, -1, SQLITE_PREPARE_PERSISTENT, &own_, nullptr));
        }
        statement(const statement&) = delete;
        statement& operator=(const statement&) = delete;
        ~statement() { sqlite3_finalize(own_); }

        statement& begin() {
            sqlite3_reset(own_);
            next_ = 1;
            return *this;
        }
        statement& text(std::string_view value) {
            in_.require(sqlite3_bind_text64(own_, next_++, value.data(), value.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
            return *this;
        }
        statement& bytes(const void* data, std::size_t size) {
            in_.require(sqlite3_bind_blob64(own_, next_++, data, size, SQLITE_TRANSIENT));
            return *this;
        }
        statement& whole(long value) {
            in_.require(sqlite3_bind_int64(own_, next_++, value));
            return *this;
        }
        statement& real(double value) {
            in_.require(sqlite3_bind_double(own_, next_++, value));
            return *this;
        }
        // Whether there is a row.
        bool step() {
            const int code = sqlite3_step(own_);
            if (code != SQLITE_ROW && code != SQLITE_DONE) {
                sqlite3_reset(own_);
                refuse_code(in_.handle, in_.path, code);
            }
            if (code == SQLITE_DONE) {
                sqlite3_reset(own_);
            }
            return code == SQLITE_ROW;
        }
        std::string column(int which) const {
            const void* const data = sqlite3_column_blob(own_, which);
            const auto size = static_cast<std::size_t>(sqlite3_column_bytes(own_, which));
            return data == nullptr ? std::string() : std::string(static_cast<const char*>(data), size);
        }
        long whole_column(int which) const { return sqlite3_column_int64(own_, which); }
        double real_column(int which) const { return sqlite3_column_double(own_, which); }

    private:
        const database& in_;
        sqlite3_stmt* own_ = nullptr;
        int next_ = 1;
    };

    database(fs::path of, access how) : path(std::move(of)) {
        if (how == access::write) {
            take_writers_lock();
        }
        open(how);
    }
    database(const database&) = delete;
    database& operator=(const database&) = delete;
    // The descriptor last: when it closes, the system drops all locks that this process has on the file.
    ~database() {
        statements.reset();
        sqlite3_close(handle);
        close_lock();
    }

    void require(int code) const {
        if (code != SQLITE_OK) {
            refuse_code(handle, path, code);
        }
    }
    void run(const std::string& sql) const { require(sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr)); }
    long number(const char* sql) const {
        statement one(*this, sql);
        return one.begin().step() ? one.whole_column(0) : 0;
    }

    void take_writers_lock() {
        lock = locked_for_writing(path, O_CREAT);
        if (lock < 0) {
            refuse_as(journal_error::fault::unwritable, path, fmt::format("cannot be written ({})", strerror(errno)));
        }
    }

    void close_lock() {
        if (lock >= 0) {
            ::close(lock);
            lock = -1;
        }
    }

    // A destructor does not run when a constructor throws.
    void open(access how) {
        try {
            const int flags = how == access::write ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READWRITE;
            const int code = sqlite3_open_v2(path.c_str(), &handle, flags | SQLITE_OPEN_FULLMUTEX, nullptr);
            if (code != SQLITE_OK && how == access::read) {
                sqlite3_close(std::exchange(handle, nullptr));
                require(sqlite3_open_v2(path.c_str(), &handle, SQLITE_OPEN_READONLY, nullptr));
            } else {
                require(code);
            }
            sqlite3_extended_result_codes(handle, 1);
            sqlite3_busy_timeout(handle, 2000);
            prepare_file(how);
            statements = std::make_unique<all_statements>(*this);
        } catch (...) {
            statements.reset();
            sqlite3_close(handle);
            close_lock();
            throw;
        }
    }

    // Checks that the file is a journal, and creates the tables of a new one.
    void prepare_file(access how) const {
        const long mark = number("PRAGMA application_id");
        const bool is_new = mark == 0 && number("SELECT count(*) FROM sqlite_master") == 0;
        if (is_new && how == access::read) {
            refuse_as(journal_error::fault::unbegun, path, "holds nothing yet");
        }
        if (!is_new && mark != journal_mark) {
            refuse_as(journal_error::fault::damaged, path, "is not a journal");
        }
        if (!is_new && number("PRAGMA user_version") != journal_format) {
            refuse_as(journal_error::fault::damaged, path, "has the format of another version");
        }
        if (how == access::read) {
            return;
        }
        run(is_of_network(path.parent_path()) ? "PRAGMA journal_mode=DELETE" : "PRAGMA journal_mode=WAL");
        run("PRAGMA synchronous=NORMAL");
        if (is_new) {
            run(fmt::format(
                "BEGIN; PRAGMA application_id={}; PRAGMA user_version={};"
                "CREATE TABLE stamp(study TEXT NOT NULL, version TEXT NOT NULL, library TEXT NOT NULL);"
                "CREATE TABLE command(words TEXT PRIMARY KEY NOT NULL);"
                "CREATE TABLE cell(key BLOB PRIMARY KEY NOT NULL, inputs TEXT NOT NULL, failed INTEGER NOT NULL,"
                " attempts INTEGER NOT NULL, seconds REAL NOT NULL, content BLOB NOT NULL, sum BLOB NOT NULL);"
                "COMMIT",
                journal_mark, journal_format));
        }
    }

    struct all_statements {
        explicit all_statements(const database& in)
            : find(in, "SELECT inputs, failed, attempts, seconds, content, sum, key FROM cell WHERE key = ?"),
              add(in,
                  "INSERT INTO cell(key, inputs, failed, attempts, seconds, content, sum) VALUES(?, ?, ?, ?, ?, ?, ?) "
                  "ON CONFLICT(key) DO UPDATE SET failed = excluded.failed, attempts = excluded.attempts, "
                  "seconds = excluded.seconds, content = excluded.content, sum = excluded.sum"),
              all(in, "SELECT inputs, failed, attempts, seconds, content, sum, key FROM cell ORDER BY rowid"),
              counts(in, "SELECT total(failed = 0), total(failed), total(seconds) FROM cell"),
              stamp(in, "SELECT study, version, library FROM stamp"),
              set_stamp(in, "INSERT INTO stamp(study, version, library) VALUES(?, ?, ?)"),
              commands(in, "SELECT words FROM command ORDER BY rowid"),
              add_command(in, "INSERT OR IGNORE INTO command(words) VALUES(?)") {}
        statement find, add, all, counts, stamp, set_stamp, commands, add_command;
    };

    // The record of the row at which a statement stands.
    journal_record record_at(const statement& row) const {
        journal_record record;
        record.inputs = row.column(0);
        record.failed = row.whole_column(1) != 0;
        record.attempts = static_cast<int>(row.whole_column(2));
        record.seconds = row.real_column(3);
        record.content = row.column(4);
        const std::string key = row.column(6);
        std::copy_n(key.begin(), std::min(key.size(), record.key.size()), record.key.begin());
        if (row.column(5) != sum_of(record)) {
            refuse_as(journal_error::fault::damaged, path,
                      "is damaged (the checksum of " + record.inputs + " is wrong)");
        }
        return record;
    }

    fs::path path;
    sqlite3* handle = nullptr;
    int lock = -1;
    std::unique_ptr<all_statements> statements;
    std::mutex mutex;
};

journal::journal(fs::path path, access how) : path_(std::move(path)) {
    ::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error like a full disk, not the end of the process
    if (how == access::read && !fs::exists(path_)) {
        refuse_as(journal_error::fault::unwritable, path_, "does not exist");
    }
    database_ = std::make_unique<database>(path_, how);
}

journal::journal(journal&& other) noexcept = default;
journal::~journal() = default;

std::optional<journal_stamp> journal::stamp() const {
    const std::lock_guard guard(database_->mutex);
    auto& ask = database_->statements->stamp.begin();
    if (!ask.step()) {
        return std::nullopt;
    }
    journal_stamp found{ask.column(0), ask.column(1), ask.column(2)};
    ask.begin();
    return found;
}

void journal::set_stamp(const journal_stamp& stamp) {
    const std::lock_guard guard(database_->mutex);
    database_->run("DELETE FROM stamp");
    database_->statements->set_stamp.begin().text(stamp.study).text(stamp.version).text(stamp.library).step();
}

std::vector<std::string> journal::commands() const {
    const std::lock_guard guard(database_->mutex);
    std::vector<std::string> all;
    for (auto& ask = database_->statements->commands.begin(); ask.step();) {
        all.push_back(ask.column(0));
    }
    return all;
}

void journal::add_command(const std::string& words) {
    const std::lock_guard guard(database_->mutex);
    database_->statements->add_command.begin().text(words).step();
}

std::optional<journal_record> journal::find(const cell_key& key) const {
    const std::lock_guard guard(database_->mutex);
    auto& ask = database_->statements->find.begin().bytes(key.data(), key.size());
    if (!ask.step()) {
        return std::nullopt;
    }
    auto record = database_->record_at(ask);
    ask.begin();
    return record;
}

void journal::add(const std::vector<journal_record>& records) {
    const std::lock_guard guard(database_->mutex);
    database_->run("BEGIN IMMEDIATE");
    try {
        for (const journal_record& each : records) {
            const std::string sum = sum_of(each);
            database_->statements->add.begin()
                .bytes(each.key.data(), each.key.size())
                .text(each.inputs)
                .whole(static_cast<long>(each.failed))
                .whole(each.attempts)
                .real(each.seconds)
                .bytes(each.content.data(), each.content.size())
                .bytes(sum.data(), sum.size())
                .step();
        }
        database_->run("COMMIT");
    } catch (...) {
        sqlite3_exec(database_->handle, "ROLLBACK", nullptr, nullptr, nullptr);
        throw;
    }
}

void journal::settle() {
    const std::lock_guard guard(database_->mutex);
    sqlite3_exec(database_->handle, "PRAGMA journal_mode=DELETE", nullptr, nullptr, nullptr);
}

void journal::for_each(const std::function<void(const journal_record&)>& see) const {
    const std::lock_guard guard(database_->mutex);
    for (auto& ask = database_->statements->all.begin(); ask.step();) {
        see(database_->record_at(ask));
    }
}

journal_counts journal::counts() const {
    const std::lock_guard guard(database_->mutex);
    auto& ask = database_->statements->counts.begin();
    ask.step();
    const journal_counts found{ask.whole_column(0), ask.whole_column(1), ask.real_column(2)};
    ask.begin();
    return found;
}

void drop_journal(const fs::path& path) {
    if (const int lock = locked_for_writing(path, 0); lock >= 0) {
        ::close(lock);
    }
    std::error_code problem;
    for (const char* const beside : {"", "-wal", "-shm", "-journal"}) {
        fs::remove(path.string() + beside, problem);
        if (problem) {
            refuse_as(journal_error::fault::unwritable, path, "cannot be removed (" + problem.message() + ")");
        }
    }
}

}  // namespace libration
