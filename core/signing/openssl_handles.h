// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// For the sources of this room only: what OpenSSL hands out, owned.

#include "core/base/index.h"

#include <openssl/bio.h>
#include <openssl/cms.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/ts.h>
#include <openssl/x509.h>

#include <climits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal::openssl {

template <auto Free>
struct Freed
{
    template <typename T>
    void operator()(T *handle) const
    {
        Free(handle);
    }
};

inline void freeStackOnly(STACK_OF(X509) * stack)
{
    sk_X509_free(stack);
}

using Certificate = std::unique_ptr<X509, Freed<&X509_free>>;
using PrivateKey = std::unique_ptr<EVP_PKEY, Freed<&EVP_PKEY_free>>;
using Bio = std::unique_ptr<BIO, Freed<&BIO_free_all>>;
using Cms = std::unique_ptr<CMS_ContentInfo, Freed<&CMS_ContentInfo_free>>;
using Store = std::unique_ptr<X509_STORE, Freed<&X509_STORE_free>>;
using StoreContext = std::unique_ptr<X509_STORE_CTX, Freed<&X509_STORE_CTX_free>>;
using Borrowed = std::unique_ptr<STACK_OF(X509), Freed<&freeStackOnly>>; ///< not its certificates
using Pkcs7 = std::unique_ptr<PKCS7, Freed<&PKCS7_free>>;
using Bytes = std::vector<unsigned char>;

/// A file in memory to be read; it must outlive what is returned.
inline Bio bioOn(std::string_view bytes)
{
    return Bio(bytes.size() > INT_MAX
            ? nullptr
            : BIO_new_mem_buf(bytes.data(), static_cast<int>(bytes.size())));
}

/// What i2d_...(`value`, pointer) writes; empty if it fails.
template <typename T, typename Encode>
std::string derOf(T *value, Encode encode)
{
    const int size = encode(value, nullptr);
    std::string der(size > 0 ? static_cast<std::size_t>(size) : 0, '\0');
    auto *place = reinterpret_cast<unsigned char *>(der.data());
    if (size > 0)
        encode(value, &place);
    return der;
}

inline const unsigned char *bytesOf(std::string_view text)
{
    return reinterpret_cast<const unsigned char *>(text.data());
}

/// Certificates in one list that owns none of them.
inline Borrowed borrowed(const std::vector<Certificate> &certificates)
{
    Borrowed stack(sk_X509_new_null());
    for (const Certificate &one : certificates)
        sk_X509_push(stack.get(), one.get());
    return stack;
}

} // namespace dyncal::openssl
