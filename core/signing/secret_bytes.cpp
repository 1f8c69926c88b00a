// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/secret_bytes.h"

#include <openssl/crypto.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include <unistd.h>

namespace dyncal {
namespace {

/// Bytes read into `place`, at most `room`; -1 on failure.
ssize_t readSome(int descriptor, char *place, std::size_t room)
{
    ssize_t got = 0;
    do
        got = ::read(descriptor, place, room);
    while (got < 0 && errno == EINTR);
    return got;
}

} // namespace

SecretBytes::~SecretBytes()
{
    wipe();
}

SecretBytes::SecretBytes(SecretBytes &&other) noexcept
    : m_bytes(std::move(other.m_bytes))
    , m_size(std::exchange(other.m_size, 0))
{
}

SecretBytes &SecretBytes::operator=(SecretBytes &&other) noexcept
{
    if (this == &other)
        return *this;
    wipe();
    m_bytes = std::move(other.m_bytes);
    m_size = std::exchange(other.m_size, 0);
    return *this;
}

void SecretBytes::wipe()
{
    if (m_bytes)
        OPENSSL_cleanse(m_bytes.get(), kMost + 1);
}

Result<SecretBytes> SecretBytes::readFrom(int descriptor)
{
    SecretBytes secret;
    secret.m_bytes = std::make_unique<char[]>(kMost + 1);
    char *bytes = secret.m_bytes.get();
    std::size_t size = 0;
    ssize_t got = 1;
    // One byte more than is allowed tells a longer one.
    while (size <= kMost && got > 0 && std::memchr(bytes, '\n', size) == nullptr) {
        got = readSome(descriptor, bytes + size, kMost + 1 - size);
        size += got > 0 ? static_cast<std::size_t>(got) : 0;
    }
    const void *line = std::memchr(bytes, '\n', size);
    if (line != nullptr)
        size = static_cast<std::size_t>(static_cast<const char *>(line) - bytes);
    if (line != nullptr && size > 0 && bytes[size - 1] == '\r') // a line of Windows
        --size;
    if (std::memchr(bytes, 0, size) != nullptr)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The PIN or passphrase in file descriptor %1 (--pin-fd) has a byte that is zero, as a text in UTF-16 has many; write it in UTF-8, in one line of 1 to %2 bytes."),
                {std::to_string(descriptor), std::to_string(kMost)}});
    const bool isFit = got >= 0 && size > 0 && size <= kMost;
    if (!isFit)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "No PIN or passphrase of 1 to %2 bytes in one line can be read from file descriptor %1 (--pin-fd); open it for reading, as in `--pin-fd 3 3< FILE`."),
                {std::to_string(descriptor), std::to_string(kMost)}});
    OPENSSL_cleanse(bytes + size, kMost + 1 - size);
    secret.m_size = size;
    return secret;
}

} // namespace dyncal
