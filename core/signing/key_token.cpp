// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/key_token.h"

#include "core/base/ascii_text.h"

#include <openssl/engine.h>
#include <openssl/ui.h>

#include <algorithm>
#include <cstdlib>

#include <dlfcn.h>

// OpenSSL 3.0 calls engines deprecated; the provider that replaces them is not in Debian 12.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace dyncal {
namespace {

constexpr std::string_view kTokenScheme = "pkcs11:";

/// The engine, initialised; finished when the last copy is gone, with its sessions and its PIN.
using Engine = std::shared_ptr<ENGINE>;

/// Parts of a URI: path attributes are divided by ';', query attributes begin at '?', by '&'.
std::vector<std::string> attributesOf(const std::string &uri)
{
    std::vector<std::string> parts;
    std::string part;
    for (const char c : uri.substr(kTokenScheme.size()) + ';') {
        if (c != ';' && c != '?' && c != '&') {
            part += c;
        } else if (!part.empty()) {
            parts.push_back(std::move(part));
            part.clear();
        }
    }
    return parts;
}

/// %2F is '/'; what is none stays.
std::string decoded(std::string_view text)
{
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::string digits(text.substr(i + 1, 2));
        const bool isCode = text[i] == '%' && digits.size() == 2
            && digits.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
        out += isCode ? static_cast<char>(std::stoi(digits, nullptr, 16)) : text[i];
        i += isCode ? 2 : 0;
    }
    return out;
}

std::string valueOf(const std::vector<std::string> &attributes, const std::string &name)
{
    for (const std::string &one : attributes)
        if (one.starts_with(name + '='))
            return decoded(std::string_view(one).substr(name.size() + 1));
    return {};
}

/// Name of an attribute as it is meant: RFC 3986 lets letters stand as codes, and people hold the
/// shift key.
std::string nameOf(std::string_view attribute)
{
    return lowerCase(decoded(attribute.substr(0, attribute.find('='))));
}

/// The same object as "private" or "cert", without what the engine need not know.
std::string uriOfType(const std::vector<std::string> &attributes, const char *type)
{
    std::string uri(kTokenScheme);
    for (const std::string &one : attributes)
        if (!one.starts_with("type=") && !one.starts_with("module-path="))
            uri += one + ';';
    return uri + "type=" + type;
}

std::string modulePath(const std::vector<std::string> &attributes)
{
    if (std::string path = valueOf(attributes, "module-path"); !path.empty())
        return path;
    const char *set = std::getenv("PKCS11_MODULE_PATH");
    return set != nullptr ? set : "";
}

tl::unexpected<Error> noEngine(const std::string &module)
{
    ERR_clear_error();
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The library of the token (%1) cannot be used through OpenSSL's engine pkcs11; install libengine-pkcs11-openssl and name the token's library by module-path in the URI or by PKCS11_MODULE_PATH."),
            {module.empty() ? std::string("-") : module}});
}

/// The engine opens it late and then says nothing of what is wrong.
bool isLibrary(const std::string &module)
{
    void *library = module.empty() ? nullptr : ::dlopen(module.c_str(), RTLD_LAZY | RTLD_LOCAL);
    return library != nullptr && ::dlclose(library) == 0;
}

Result<Engine> openEngine(const std::string &module, const SecretBytes &pin)
{
    ENGINE_load_builtin_engines();
    ENGINE *engine = ENGINE_by_id("pkcs11");
    if (engine == nullptr)
        return noEngine(module);
    // QUIET: what goes wrong is told here, in one sentence.
    const bool isSet = isLibrary(module) && ENGINE_ctrl_cmd_string(engine, "QUIET", nullptr, 0) == 1
        && ENGINE_ctrl_cmd_string(engine, "MODULE_PATH", module.c_str(), 0) == 1
        && (!pin.isGiven() || ENGINE_ctrl_cmd_string(engine, "PIN", pin.text(), 0) == 1)
        && ENGINE_init(engine) == 1;
    ENGINE_free(engine); // what ENGINE_init() gave stays
    if (!isSet)
        return noEngine(module);
    return Engine(engine, [](ENGINE *one) { ENGINE_finish(one); });
}

openssl::Certificate certificateOf(ENGINE *engine, const std::string &uri)
{
    struct
    {
        const char *uri;
        X509 *certificate;
    } wanted{uri.c_str(), nullptr};
    ENGINE_ctrl_cmd(engine, "LOAD_CERT_CTRL", 0, &wanted, nullptr, 1);
    return openssl::Certificate(wanted.certificate);
}

tl::unexpected<Error> noTokenKey(const std::string &uri, const SecretBytes &pin)
{
    ERR_clear_error();
    if (!pin.isGiven())
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The token gives no private key for %1 without a PIN; give it by --pin-fd N, or in its field of the window."),
                {uri}});
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The token gives no private key for %1: the PIN is wrong, or there is no such token or object; look with `pkcs11-tool --list-objects` before you try again, because tokens lock after some wrong PINs."),
            {uri}});
}

} // namespace

bool isTokenUri(const std::string &source)
{
    return lowerCase(source.substr(0, kTokenScheme.size())) == kTokenScheme;
}

std::string shownSource(const std::string &source)
{
    return isTokenUri(source) ? source.substr(0, source.find('?')) : source;
}

Result<void> checkTokenUri(const std::string &uri)
{
    for (const std::string &one : attributesOf(uri))
        if (nameOf(one).starts_with("pin")) // pin-value, pin-source, and misspelt
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core",
                     "The URI of the token holds a PIN, which others could read in the list of processes; leave it out and give the PIN by --pin-fd N, or in its field of the window."),
                    {}});
    return {};
}

Result<KeyMaterial> keyOfToken(const std::string &uri, const SecretBytes &pin)
{
    if (const Result<void> fit = checkTokenUri(uri); !fit)
        return tl::unexpected<Error>(fit.error());
    const std::vector<std::string> attributes = attributesOf(uri);
    const Result<Engine> engine = openEngine(modulePath(attributes), pin);
    if (!engine)
        return tl::unexpected<Error>(engine.error());
    KeyMaterial state;
    state.token = *engine;
    // UI_null: a wrong PIN is an error, never a question on the terminal.
    state.key.reset(ENGINE_load_private_key(engine->get(), uriOfType(attributes, "private").c_str(),
        const_cast<UI_METHOD *>(UI_null()), nullptr));
    if (!state.key)
        return noTokenKey(shownSource(uri), pin);
    state.certificate = certificateOf(engine->get(), uriOfType(attributes, "cert"));
    ERR_clear_error();
    if (!state.certificate)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The token has no certificate under %1; write the key's certificate into it under the same id (pkcs11-tool --write-object FILE --type cert --id ID)."),
                {shownSource(uri)}});
    return state;
}

} // namespace dyncal

#pragma GCC diagnostic pop
