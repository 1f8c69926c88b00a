// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/store/network_folder.h"
#include "registry/store/registry_address.h"

#include "tests/support/test_program.h"

#include <QtTest>

#include <sys/vfs.h>

using namespace dyncal;

/// Where a registry is, and where it must not be.
class TestRegistryAddress : public QObject
{
    Q_OBJECT

private slots:
    void file_isTakenAsItIs()
    {
        const auto address = registryAddress("some folder/r.sqlite");
        QVERIFY(!address->isServer());
        QCOMPARE(address->file, "some folder/r.sqlite");
        QCOMPARE(address->shown(), "some folder/r.sqlite");
    }

    void nothing_isTheFileOfTheUser()
    {
        qputenv("XDG_DATA_HOME", "/somewhere");
        QCOMPARE(registryAddress("")->file, "/somewhere/dyncal/registry.sqlite");
        qunsetenv("XDG_DATA_HOME");
    }

    void server_isTakenApart()
    {
        const auto address
            = registryAddress("postgresql://ann:p%40ss@host.lab:5433/cal%20ibration");
        QVERIFY(address->isServer());
        QCOMPARE(address->host, "host.lab");
        QCOMPARE(address->port, 5433);
        QCOMPARE(address->user, "ann");
        QCOMPARE(address->password, "p@ss");
        QCOMPARE(address->database, "cal ibration");
        QCOMPARE(registryAddress("postgresql://host/db")->port, -1);
    }

    /// Not in sentences either.
    void password_isNeverShown()
    {
        const std::string url = "postgresql://ann:secret@host:5433/db";
        QCOMPARE(registryAddress(url)->shown(), "postgresql://host:5433/db");
        const auto wrong = registryAddress("mysql://ann:secret@host/db");
        QVERIFY(!wrong);
        QVERIFY(english(wrong.error().message).find("secret") == std::string::npos);
    }

    void otherUrls_areRefused()
    {
        for (const char *wrong : {"mysql://host/db", "postgresql://host", "postgresql://host/",
                 "postgresql:///db", "http://host/db", "sqlite://file"}) {
            const auto address = registryAddress(wrong);
            QVERIFY2(!address, wrong);
            QCOMPARE(address.error().kind, ErrorKind::Usage);
        }
    }

    /// The numbers of statfs(2).
    void networkFileSystems_areKnown()
    {
        QCOMPARE(networkFileSystem(0x6969), "NFS");
        QCOMPARE(networkFileSystem(0xFF534D42), "SMB");
        QCOMPARE(networkFileSystem(static_cast<int>(0xFF534D42)), "SMB"); // as a signed field
        QCOMPARE(networkFileSystem(0xFE534D42), "SMB");
        QCOMPARE(networkFileSystem(0x01021997), "9P");
        QCOMPARE(networkFileSystem(0x65735546), "FUSE");
        for (const long local : {0xEF53L, 0x58465342L, 0x9123683EL, 0x01021994L, 0x794C7630L})
            QCOMPARE(networkFileSystem(local), ""); // ext4, XFS, Btrfs, tmpfs, overlay
    }

    void folderThatIsNotThere_countsAsItsParent()
    {
        struct statfs root = {};
        QCOMPARE(::statfs("/dev/shm", &root), 0);
        QCOMPARE(
            networkFileSystemOf("/dev/shm/not/there/r.sqlite"), networkFileSystem(root.f_type));
    }
};

DYNCAL_TEST(TestRegistryAddress)
#include "tst_registry_address.moc"
