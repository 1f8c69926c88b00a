// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/content_hash.h"

#include <openssl/crypto.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <new>
#include <system_error>
#include <vector>

namespace dyncal {
namespace {

constexpr char kHexDigits[] = "0123456789abcdef";

/// OpenSSL fails here only for lack of memory; a hash that was not computed must never be used.
void needs(int done)
{
    if (done != 1)
        throw std::bad_alloc();
}

} // namespace

struct Sha256::State
{
    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context{
        EVP_MD_CTX_new(), &EVP_MD_CTX_free};
};

Sha256::Sha256()
{
    // Without its configuration file, which has no say in SHA-256 and takes 0.6 ms of every start.
    needs(OPENSSL_init_crypto(OPENSSL_INIT_NO_LOAD_CONFIG, nullptr));
    m_state = std::make_unique<State>();
    needs(m_state->context ? 1 : 0);
    needs(EVP_DigestInit_ex(m_state->context.get(), EVP_sha256(), nullptr));
}

Sha256::~Sha256() = default;

void Sha256::add(std::span<const std::byte> bytes)
{
    needs(EVP_DigestUpdate(m_state->context.get(), bytes.data(), bytes.size()));
}

std::string Sha256::hex()
{
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int length = 0;
    needs(EVP_DigestFinal_ex(m_state->context.get(), digest.data(), &length));
    std::string text;
    for (unsigned int i = 0; i < length; ++i) {
        text += kHexDigits[digest[i] >> 4];
        text += kHexDigits[digest[i] & 0xf];
    }
    return text;
}

std::string sha256Hex(std::span<const std::byte> bytes)
{
    Sha256 hash;
    hash.add(bytes);
    return hash.hex();
}

std::string sha256Hex(std::string_view text)
{
    return sha256Hex(std::as_bytes(std::span(text.data(), text.size())));
}

bool isSha256Hex(std::string_view text)
{
    return text.size() == kSha256Digits
        && text.find_first_not_of(kHexDigits) == std::string_view::npos;
}

std::string sha256OfFile(const std::string &path, const std::function<bool(std::uintmax_t)> &goOn)
{
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return {};
    Sha256 hash;
    constexpr std::uintmax_t kBlock = 1 << 20;
    std::error_code unknown; // new memory costs more time than a small file
    const std::uintmax_t size = std::filesystem::file_size(path, unknown);
    std::vector<char> block(
        static_cast<std::size_t>(unknown ? kBlock : std::min(size + 1, kBlock)));
    std::uintmax_t done = 0;
    while (file) {
        file.read(block.data(), std::ssize(block));
        const auto length = static_cast<std::size_t>(file.gcount());
        hash.add(std::as_bytes(std::span(block)).first(length));
        done += length;
        if (goOn && !goOn(done))
            return {};
    }
    return file.bad() ? std::string() : hash.hex();
}

} // namespace dyncal
