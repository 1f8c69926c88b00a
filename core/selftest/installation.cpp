// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/installation.h"

#include "core/base/version.h"

#include <Eigen/Core>
#include <fftw3.h>
#include <gnu/libc-version.h>
#include <hdf5.h>
#include <nlohmann/json.hpp>
#include <openssl/crypto.h>
#include <pugixml.hpp>
#include <sys/utsname.h>
#include <zlib.h>

#include <fstream>

namespace dyncal {
namespace {

/// The rest of the first line of a file that begins with `key`, behind what separates them.
std::string valueIn(const char *path, const std::string &key)
{
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with(key))
            continue;
        const std::size_t begin = line.find_first_not_of(" \t:=\"", key.size());
        const std::size_t end = line.find_last_not_of(" \t\"");
        return begin == line.npos || end < begin ? "unknown" : line.substr(begin, end - begin + 1);
    }
    return "unknown";
}

std::string systemText()
{
    utsname names{};
    const std::string kernel = ::uname(&names) == 0
        ? std::string(names.sysname) + " " + names.release + " " + names.machine
        : "unknown";
    return valueIn("/etc/os-release", "PRETTY_NAME") + "; " + kernel;
}

std::string dotted(unsigned major, unsigned minor, unsigned patch)
{
    return std::to_string(major)
        .append(".")
        .append(std::to_string(minor))
        .append(".")
        .append(std::to_string(patch));
}

std::string hdf5Version()
{
    unsigned major = 0, minor = 0, patch = 0;
    return ::H5get_libversion(&major, &minor, &patch) < 0 ? "unknown" : dotted(major, minor, patch);
}

std::string compilerText()
{
#if defined(__clang__)
    return "clang " + dotted(__clang_major__, __clang_minor__, __clang_patchlevel__);
#else
    return "g++ " __VERSION__;
#endif
}

} // namespace

Installation thisInstallation(std::vector<UsedLibrary> others)
{
    Installation made{versionText(), buildText(), compilerText(),
        valueIn("/proc/cpuinfo", "model name"), systemText(), {}};
    made.libraries
        = {{"Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
            {"FFTW", ::fftw_version}, {"HDF5", hdf5Version()},
            {"libcrypto", ::OpenSSL_version(OPENSSL_VERSION)}, {"zlib", ::zlibVersion()},
            {"JSON for Modern C++",
                dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                    NLOHMANN_JSON_VERSION_PATCH)},
            {"pugixml",
                dotted(PUGIXML_VERSION / 1000, PUGIXML_VERSION / 10 % 100, PUGIXML_VERSION % 10)},
            {"glibc", ::gnu_get_libc_version()}};
    for (UsedLibrary &other : others)
        made.libraries.push_back(std::move(other));
    return made;
}

} // namespace dyncal
