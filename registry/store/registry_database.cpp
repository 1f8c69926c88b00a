// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/store/registry_database.h"

#include "registry/store/network_folder.h"

#include <QCoreApplication>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QSqlRecord>

#include <array>
#include <atomic>
#include <filesystem>

#include <unistd.h>

namespace dyncal {

struct RegistryDatabase::Private
{
    RegistryAddress address;
    std::unique_ptr<QCoreApplication> application; ///< drivers are plugins, which need one
    QtMessageHandler messages = nullptr; ///< those before, where the application is ours
    QString name; ///< of the connection

    ~Private()
    {
        QSqlDatabase::database(name, false).close();
        QSqlDatabase::removeDatabase(name);
        if (application)
            qInstallMessageHandler(messages);
    }
    QSqlDatabase connection() const { return QSqlDatabase::database(name, false); }
};

namespace {

void ignoreMessage(QtMsgType, const QMessageLogContext &, const QString &) { }

std::unique_ptr<QCoreApplication> neededApplication()
{
    static int argc = 1;
    static std::array<char, 7> program{"dyncal"};
    static std::array<char *, 2> argv{program.data(), nullptr};
    return QCoreApplication::instance() ? nullptr
                                        : std::make_unique<QCoreApplication>(argc, argv.data());
}

std::string reasonOf(const QSqlError &error)
{
    return error.text().simplified().toStdString();
}

tl::unexpected<Error> failed(const RegistryAddress &address, const QSqlError &error)
{
    return fail(error.type() == QSqlError::ConnectionError ? ErrorKind::Usage : ErrorKind::Internal,
        {DYNCAL_TEXT("core",
             "The registry %1 does not answer as it should (%2); check that it is there, is a registry and may be written to, and do it again: nothing is lost."),
            {address.shown(), reasonOf(error)}});
}

Result<void> checkPlace(const RegistryAddress &address, RegistryAccess access)
{
    namespace fs = std::filesystem;
    std::error_code error;
    if (access != RegistryAccess::Write && !fs::is_regular_file(address.file, error))
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core", "There is no registry %1; name its file or server."),
                {address.shown()}});
    if (access == RegistryAccess::Read)
        return {};
    const std::string network = networkFileSystemOf(address.file);
    if (!network.empty())
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The registry %1 lies on a network folder (%2), where two programs that write it at once would destroy it; put it on a disk of this machine, or use a PostgreSQL server for several."),
                {address.shown(), network}});
    fs::create_directories(fs::path(address.file).parent_path(), error);
    return {};
}

Result<void> checkDriver(const RegistryAddress &address)
{
    const char *driver = address.isServer() ? "QPSQL" : "QSQLITE";
    if (QSqlDatabase::isDriverAvailable(driver))
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The registry %1 needs the driver %2, which is not installed; install the package %3."),
            {address.shown(), driver,
                address.isServer() ? "libqt6sql6-psql" : "libqt6sql6-sqlite"}});
}

/// Whether what a killed program left of a transaction may be undone by reading: without that the
/// file could not be read.
bool mayRecover(const std::string &file)
{
    return ::access(file.c_str(), W_OK) == 0 && networkFileSystemOf(file).empty();
}

void describe(QSqlDatabase &connection, const RegistryAddress &address, RegistryAccess access)
{
    if (address.isServer()) {
        connection.setHostName(QString::fromStdString(address.host));
        connection.setPort(address.port);
        connection.setUserName(QString::fromStdString(address.user));
        connection.setPassword(QString::fromStdString(address.password));
        connection.setDatabaseName(QString::fromStdString(address.database));
        connection.setConnectOptions("connect_timeout=10");
        return;
    }
    connection.setDatabaseName(QString::fromStdString(address.file));
    connection.setConnectOptions(access == RegistryAccess::Read && !mayRecover(address.file)
            ? "QSQLITE_BUSY_TIMEOUT=60000;QSQLITE_OPEN_READONLY"
            : "QSQLITE_BUSY_TIMEOUT=60000");
}

Result<void> connect(const RegistryAddress &address, RegistryAccess access, const QString &name)
{
    QSqlDatabase connection
        = QSqlDatabase::addDatabase(address.isServer() ? "QPSQL" : "QSQLITE", name);
    describe(connection, address, access);
    if (!connection.open())
        return failed(address, connection.lastError());
    return {};
}

} // namespace

RegistryDatabase::RegistryDatabase(std::unique_ptr<Private> opened)
    : d(std::move(opened))
{
}

RegistryDatabase::RegistryDatabase(RegistryDatabase &&) noexcept = default;
RegistryDatabase &RegistryDatabase::operator=(RegistryDatabase &&) noexcept = default;
RegistryDatabase::~RegistryDatabase() = default;

const RegistryAddress &RegistryDatabase::address() const
{
    return d->address;
}

Result<RegistryDatabase> RegistryDatabase::open(
    const RegistryAddress &address, RegistryAccess access)
{
    static std::atomic<int> count = 0;
    if (!address.isServer())
        if (const Result<void> place = checkPlace(address, access); !place)
            return tl::unexpected<Error>(place.error());
    auto opened = std::make_unique<Private>();
    opened->address = address;
    opened->application = neededApplication();
    if (opened->application) // the sentence of an error says what Qt would say about it
        opened->messages = qInstallMessageHandler(ignoreMessage);
    opened->name = QString("registry-%1").arg(++count);
    if (const Result<void> driver = checkDriver(address); !driver)
        return tl::unexpected<Error>(driver.error());
    if (const Result<void> connected = connect(address, access, opened->name); !connected)
        return tl::unexpected<Error>(connected.error());
    RegistryDatabase database(std::move(opened));
    // SQLite: on disk when a transaction has ended, and the first answer shows whether it is one.
    const char *mode
        = access == RegistryAccess::Read ? "PRAGMA query_only = ON" : "PRAGMA synchronous = EXTRA";
    if (!address.isServer())
        if (const auto set = database.run(mode); !set)
            return tl::unexpected<Error>(set.error());
    return database;
}

Result<std::vector<RegistryDatabase::Row>> RegistryDatabase::run(
    const QString &statement, const std::vector<QVariant> &values)
{
    QSqlQuery query(d->connection());
    query.setForwardOnly(true);
    // PostgreSQL prepares no statements of transactions and tables; those have no values.
    bool done = values.empty() ? query.exec(statement) : query.prepare(statement);
    for (const QVariant &value : values)
        query.addBindValue(value);
    done = done && (values.empty() || query.exec());
    const int columns = query.record().count();
    std::vector<Row> rows;
    while (done && query.next()) {
        Row row;
        for (int i = 0; i < columns; ++i)
            row.push_back(query.value(i));
        rows.push_back(std::move(row));
    }
    if (!done || query.lastError().isValid())
        return failed(d->address, query.lastError());
    return rows;
}

Result<void> RegistryDatabase::begin()
{
    // Writers one after the other, from the first statement on: what is read is what is there.
    if (!d->address.isServer())
        return run("BEGIN IMMEDIATE").map([](const auto &) {});
    constexpr const char *kLock = "SELECT pg_advisory_xact_lock(1685679971)";
    return run("BEGIN").and_then([&](const auto &) { return run(kLock); }).map([](const auto &) {});
}

Result<void> RegistryDatabase::transaction(const std::function<Result<void>()> &work)
{
    if (const Result<void> begun = begin(); !begun) {
        run("ROLLBACK");
        return begun;
    }
    Result<void> done = work();
    if (done)
        done = run("COMMIT").map([](const auto &) {});
    if (!done)
        run("ROLLBACK");
    return done;
}

} // namespace dyncal
