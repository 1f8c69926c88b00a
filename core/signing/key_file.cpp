// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/key_file.h"

#include "core/signing/signer_standing.h"

#include <openssl/pem.h>
#include <openssl/pkcs12.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>

namespace dyncal {
namespace {

constexpr std::size_t kMostBytes = 1U << 20U; ///< of a file of keys

/// A file's bytes, wiped at the end: they may be an open key.
struct WipedBytes
{
    std::string bytes = {};
    WipedBytes() = default;
    WipedBytes(const WipedBytes &) = delete;
    WipedBytes &operator=(const WipedBytes &) = delete;
    ~WipedBytes() { OPENSSL_cleanse(bytes.data(), bytes.size()); }

    bool read(const std::string &path)
    {
        std::ifstream in(path, std::ios::binary);
        bytes.resize(kMostBytes);
        in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        const auto got = static_cast<std::size_t>(in.gcount());
        bytes.resize(got);
        return !in.bad() && got > 0 && got < kMostBytes;
    }
};

tl::unexpected<Error> wrongSecret(const std::string &path, const SecretBytes &secret)
{
    ERR_clear_error();
    if (!secret.isGiven())
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The key in %1 has a passphrase, and none was given; give it by --pin-fd N, or in its field of the window."),
                {path}});
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core", "The passphrase does not open the key in %1; give the right one."),
            {path}});
}

tl::unexpected<Error> noKey(const std::string &path)
{
    ERR_clear_error();
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "%1 holds no private key together with its certificate; give a PKCS#12 file, or a PEM file with both."),
            {path}});
}

/// Whether the library just refused a cipher: those of old PKCS#12 files are not in it any more.
bool isOfOldCipher()
{
    for (unsigned long code = ERR_get_error(); code != 0; code = ERR_get_error())
        if (ERR_GET_REASON(code) == ERR_R_UNSUPPORTED
            || (ERR_GET_LIB(code) == ERR_LIB_EVP
                && ERR_GET_REASON(code) == EVP_R_UNSUPPORTED_ALGORITHM))
            return true;
    return false;
}

tl::unexpected<Error> oldCipher(const std::string &path)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The passphrase is right, but %1 is encrypted in an old way (RC2 or the like) that is not opened any more; convert it by `openssl pkcs12 -legacy -in OLD.p12 -nodes | openssl pkcs12 -export -out NEW.p12`."),
            {path}});
}

std::vector<openssl::Certificate> ownedFrom(STACK_OF(X509) * stack)
{
    std::vector<openssl::Certificate> list;
    for (int i = 0; i < sk_X509_num(stack); ++i)
        list.emplace_back(sk_X509_value(stack, i));
    sk_X509_free(stack);
    return list;
}

Result<KeyMaterial> readPkcs12(PKCS12 *file, const std::string &path, const SecretBytes &secret)
{
    const bool hasMac = PKCS12_mac_present(file) == 1;
    if (hasMac && PKCS12_verify_mac(file, secret.text(), static_cast<int>(secret.size())) != 1
        && (secret.isGiven() || PKCS12_verify_mac(file, nullptr, 0) != 1))
        return wrongSecret(path, secret);
    EVP_PKEY *key = nullptr;
    X509 *certificate = nullptr;
    STACK_OF(X509) *others = nullptr;
    ERR_clear_error();
    if (PKCS12_parse(file, secret.text(), &key, &certificate, &others) != 1) {
        if (hasMac && isOfOldCipher())
            return oldCipher(path);
        return hasMac ? noKey(path) : wrongSecret(path, secret);
    }
    KeyMaterial state;
    state.key.reset(key);
    state.certificate.reset(certificate);
    state.chain = ownedFrom(others);
    if (!state.key || !state.certificate)
        return noKey(path);
    return state;
}

/// What OpenSSL asks for a passphrase: the one that was given, and whether it was asked.
struct Asked
{
    const SecretBytes &secret;
    bool wasAsked = false;
};

int answer(char *place, int room, int, void *data)
{
    Asked &asked = *static_cast<Asked *>(data);
    asked.wasAsked = true;
    if (!asked.secret.isGiven() || asked.secret.size() > static_cast<std::size_t>(room))
        return -1;
    std::memcpy(place, asked.secret.text(), asked.secret.size());
    return static_cast<int>(asked.secret.size());
}

/// All private keys of a PEM text that open.
std::vector<openssl::PrivateKey> keysIn(std::string_view bytes, Asked &asked)
{
    std::vector<openssl::PrivateKey> keys;
    const openssl::Bio in = openssl::bioOn(bytes);
    while (EVP_PKEY *one = PEM_read_bio_PrivateKey(in.get(), nullptr, &answer, &asked))
        keys.emplace_back(one);
    return keys;
}

std::vector<openssl::Certificate>::iterator certificateOf(
    EVP_PKEY *key, std::vector<openssl::Certificate> &certificates)
{
    return std::ranges::find_if(certificates, [&](const openssl::Certificate &one) {
        return X509_check_private_key(one.get(), key) == 1;
    });
}

Result<KeyMaterial> readPem(
    std::string_view bytes, const std::string &path, const SecretBytes &secret)
{
    Asked asked{secret};
    std::vector<openssl::PrivateKey> keys = keysIn(bytes, asked);
    if (keys.empty() && asked.wasAsked)
        return wrongSecret(path, secret);
    KeyMaterial state;
    state.chain = certificatesIn(bytes);
    if (keys.empty() || state.chain.empty())
        return noKey(path);
    // With no pair the first of both are taken, and found not to belong together.
    auto key = keys.begin();
    auto certificate = state.chain.begin();
    for (auto one = keys.begin(); one != keys.end(); ++one)
        if (const auto own = certificateOf(one->get(), state.chain); own != state.chain.end()) {
            key = one;
            certificate = own;
            break;
        }
    ERR_clear_error(); // of those that are none
    state.key = std::move(*key);
    state.certificate = std::move(*certificate);
    state.chain.erase(certificate);
    return state;
}

} // namespace

Result<KeyMaterial> keyOfFile(const std::string &path, const SecretBytes &secret)
{
    WipedBytes file;
    if (!file.read(path))
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "The key file %1 cannot be read, is empty or has more than %2 bytes; give a PKCS#12 or PEM file that you may read."),
                {path, std::to_string(kMostBytes - 1)}});
    if (file.bytes.find("-----BEGIN ") != std::string::npos)
        return readPem(file.bytes, path, secret);
    const openssl::Bio in = openssl::bioOn(file.bytes);
    const std::unique_ptr<PKCS12, openssl::Freed<&PKCS12_free>> pkcs12(
        d2i_PKCS12_bio(in.get(), nullptr));
    return pkcs12 ? readPkcs12(pkcs12.get(), path, secret) : noKey(path);
}

} // namespace dyncal
