// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/temporary_name.h"

#include <array>
#include <cstdint>
#include <mutex>

#include <sys/random.h>

namespace dyncal {
namespace {

constexpr std::string_view kPrefix = ".dyncal-";
constexpr std::size_t kRandomBytes = 16;
constexpr std::string_view kDigits = "0123456789abcdef";

std::mutex namesMutex;
std::function<std::string()> namesOfTest;

} // namespace

std::string newTemporaryName()
{
    {
        const std::lock_guard lock(namesMutex);
        if (namesOfTest)
            return namesOfTest();
    }
    std::array<std::uint8_t, kRandomBytes> random{};
    // Below 256 bytes it fills all or fails; with zeros the name would only be foreseeable.
    (void)!::getrandom(random.data(), random.size(), 0);
    std::string name(kPrefix);
    for (const std::uint8_t byte : random) {
        name += kDigits[byte >> 4U];
        name += kDigits[byte & 15U];
    }
    return name;
}

bool isTemporaryName(std::string_view name)
{
    return name.size() == kPrefix.size() + 2 * kRandomBytes && name.starts_with(kPrefix)
        && name.find_first_not_of(kDigits, kPrefix.size()) == std::string_view::npos;
}

void setTemporaryNames(std::function<std::string()> names)
{
    const std::lock_guard lock(namesMutex);
    namesOfTest = std::move(names);
}

} // namespace dyncal
