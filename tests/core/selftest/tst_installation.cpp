// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What an installation says of itself, against what the system says by other ways; and the folder
// that the checks of readers and writers use.

#include "core/selftest/installation.h"
#include "core/selftest/passing_folder.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QSysInfo>
#include <QTest>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

using namespace dyncal;

namespace {

namespace fs = std::filesystem;

std::string versionOf(const Installation &here, const std::string &name)
{
    const auto found = std::ranges::find(here.libraries, name, &UsedLibrary::name);
    return found == here.libraries.end() ? "" : found->version;
}

/// Files of libraries that this process has loaded, resolved to the last link: libz.so.1.2.13.
std::set<std::string> loadedLibraries()
{
    std::ifstream maps("/proc/self/maps");
    std::set<std::string> names;
    for (std::string line; std::getline(maps, line);)
        if (const std::size_t at = line.find('/'); at != line.npos)
            names.insert(fs::path(line.substr(at)).filename().string());
    return names;
}

/// Whether a file "lib<name>.so.<version>" or "lib<name>-<version>.so" is loaded.
bool isLoaded(const std::string &name, const std::string &version)
{
    const std::set<std::string> all = loadedLibraries();
    return std::ranges::any_of(all, [&](const std::string &file) {
        return file.starts_with("lib" + name) && file.ends_with(".so." + version);
    });
}

bool isOneLine(const std::string &text)
{
    return !text.empty() && text.find_first_of("\n\r\t\"") == text.npos && text.front() != ' '
        && text.back() != ' ';
}

} // namespace

class TestInstallation : public QObject
{
    Q_OBJECT

private slots:
    /// Values of files come without key, separator, quotes and line end.
    void texts_areOneLineEach()
    {
        const Installation here = thisInstallation();
        for (const std::string &text :
            {here.version, here.build, here.compiler, here.processor, here.system})
            QVERIFY2(isOneLine(text), text.c_str());
        for (const UsedLibrary &library : here.libraries)
            QVERIFY2(isOneLine(library.version), library.version.c_str());
    }

    void system_isTheOneQtSees()
    {
        const std::string system = thisInstallation().system;
        QVERIFY(system.starts_with(QSysInfo::prettyProductName().toStdString()));
        const std::string kernel = QSysInfo::kernelVersion().toStdString();
        QVERIFY2(system.find(kernel) != system.npos, system.c_str());
        const std::string machine = QSysInfo::currentCpuArchitecture().toStdString();
        QVERIFY2(system.ends_with(machine), system.c_str());
    }

    void processor_isALineOfTheSystems()
    {
        QFile cpuinfo("/proc/cpuinfo");
        QVERIFY(cpuinfo.open(QIODevice::ReadOnly));
        const std::string processor = thisInstallation().processor;
        const bool isNamed = cpuinfo.readAll().contains(("model name\t: " + processor).c_str());
        QVERIFY2(isNamed || processor == "unknown", processor.c_str());
    }

    /// The versions are of the files that are loaded, not of the headers that were there once.
    void versions_areThoseOfTheLoadedFiles()
    {
        const Installation here = thisInstallation();
        QVERIFY2(isLoaded("z", versionOf(here, "zlib")), versionOf(here, "zlib").c_str());
        const std::string crypto = versionOf(here, "libcrypto"); // "OpenSSL 3.0.15 3 Sep 2024"
        QVERIFY2(crypto.starts_with("OpenSSL "), crypto.c_str());
        QVERIFY(isLoaded("crypto", crypto.substr(8, crypto.find('.') - 8)));
        QVERIFY(versionOf(here, "FFTW").starts_with("fftw-3."));
        QCOMPARE(std::ranges::count(versionOf(here, "Eigen"), '.'), 2);
        QCOMPARE(std::ranges::count(versionOf(here, "HDF5"), '.'), 2);
        QVERIFY(versionOf(here, "pugixml").starts_with("1."));
    }

    /// Others come behind core's own, in their order and with whatever name they have.
    void others_areAppendedAsTheyAre()
    {
        const std::size_t own = thisInstallation().libraries.size();
        const Installation here = thisInstallation({{"Z", "1"}, {"A \"x\"", ""}, {"Z", "1"}});
        QCOMPARE(here.libraries.size(), own + 3);
        QCOMPARE(here.libraries[own].name, std::string("Z"));
        QCOMPARE(here.libraries[own + 1].name, std::string("A \"x\""));
        QCOMPARE(here.libraries[own + 1].version, std::string());
        QCOMPARE(here.libraries[own + 2].name, std::string("Z"));
    }

    void names_areOnceEach()
    {
        std::set<std::string> names;
        for (const UsedLibrary &library : thisInstallation().libraries)
            QVERIFY2(names.insert(library.name).second, library.name.c_str());
    }

    /// A folder for its owner alone, with its content gone at the end, however deep.
    void passingFolder_isPrivateAndGoesWithItsContent()
    {
        fs::path kept;
        {
            const PassingFolder folder;
            kept = fs::path(folder.file("x")).parent_path();
            QVERIFY(fs::is_directory(kept));
            QVERIFY(fs::is_empty(kept));
            QCOMPARE(fs::status(kept).permissions(), fs::perms::owner_all);
            QCOMPARE(folder.file("a b.csv"), (kept / "a b.csv").string());
            fs::create_directories(kept / "deep" / "deeper");
            std::ofstream(kept / "deep" / "deeper" / "file") << "text";
        }
        QVERIFY(!fs::exists(kept));
    }

    void passingFolders_areDifferent_andMayBeGoneAlready()
    {
        const PassingFolder one;
        const PassingFolder other;
        QVERIFY(one.file("x") != other.file("x"));
        fs::remove_all(fs::path(other.file("x")).parent_path()); // somebody cleaned up
        std::ofstream(one.file("x")) << "text";
        QVERIFY(fs::exists(one.file("x")));
    }

    /// What the folder links to is not in it.
    void passingFolder_leavesWhatItLinksTo()
    {
        const PassingFolder outside;
        std::ofstream(outside.file("kept")) << "text";
        {
            const PassingFolder folder;
            fs::create_directory_symlink(
                fs::path(outside.file("x")).parent_path(), folder.file("link"));
        }
        QVERIFY(fs::exists(outside.file("kept")));
    }
};

DYNCAL_TEST(TestInstallation)
#include "tst_installation.moc"
