// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace dyncal::testing {

/// A folder of its own for files that need a name or a neighbour; gone at the end. In memory where
/// the system has such a file system.
class ScratchFolder
{
public:
    ScratchFolder()
    {
        const std::filesystem::path memory("/dev/shm");
        const auto base = std::filesystem::is_directory(memory)
            ? memory
            : std::filesystem::temp_directory_path();
        std::string pattern = (base / "scratch-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr)
            std::abort();
        m_path = pattern;
    }

    ScratchFolder(const ScratchFolder &) = delete;
    ScratchFolder &operator=(const ScratchFolder &) = delete;
    ~ScratchFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }

    std::string file(const std::string &name) const { return (m_path / name).string(); }

    /// The file's path, once it holds these bytes.
    std::string write(const std::string &name, const void *data, std::size_t size) const
    {
        std::ofstream out(file(name), std::ios::binary);
        out.write(static_cast<const char *>(data), static_cast<std::streamsize>(size));
        if (!out.flush())
            std::abort();
        return file(name);
    }

private:
    std::filesystem::path m_path;
};

/// All bytes of the file; "(none)" where it cannot be read.
inline std::string contentOf(const std::string &path)
{
    std::ifstream in(path, std::ios::binary);
    return in ? std::string(std::istreambuf_iterator<char>(in), {}) : "(none)";
}

} // namespace dyncal::testing
