// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <string>

namespace dyncal::testing {

/// Bytes as a file with a path, without a disk.
class MemoryFile
{
public:
    MemoryFile(const void *data, std::size_t size)
        : m_descriptor(::memfd_create("dyncal-test", MFD_CLOEXEC))
    {
        for (std::size_t done = 0; done < size;) {
            const ssize_t written
                = ::write(m_descriptor, static_cast<const char *>(data) + done, size - done);
            if (written <= 0)
                std::abort();
            done += static_cast<std::size_t>(written);
        }
    }

    MemoryFile(const MemoryFile &) = delete;
    MemoryFile &operator=(const MemoryFile &) = delete;
    ~MemoryFile() { ::close(m_descriptor); }

    std::string path() const { return "/proc/self/fd/" + std::to_string(m_descriptor); }

private:
    int m_descriptor;
};

} // namespace dyncal::testing
