// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/signing_options.h"

#include "core/signing/http_post.h"
#include "core/signing/seal_command.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace dyncal {
namespace {

constexpr int kNoDescriptor = -1;
constexpr int kLastDescriptor = 1023; ///< that a process has without asking for more

Result<void> checkTogether(const SigningOptions &options)
{
    const int ways = static_cast<int>(!options.key.empty())
        + static_cast<int>(!options.sealCommand.empty()) + static_cast<int>(options.isUnsigned);
    if (ways != 1)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "Say who signs the certificate by one of --key and --seal-command, or that nobody does by --unsigned."),
                {}});
    if (options.isUnsigned && !options.authority.empty())
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "A time stamp (--tsa) is put over a signature, and --unsigned asks for none; leave one of them out."),
                {}});
    if (options.key.empty() && options.pinDescriptor >= 0)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT(
                 "core", "--pin-fd gives the PIN or passphrase of a key; name the key by --key."),
                {}});
    return {};
}

/// What is wrong with a file descriptor as it was typed; "" where nothing is.
std::string wrongDescriptor(const std::string &typed)
{
    constexpr std::size_t kMostDigits = 4;
    const bool isNumber = !typed.empty() && typed.size() <= kMostDigits
        && typed.find_first_not_of("0123456789") == std::string::npos;
    if (isNumber && std::stoi(typed) <= kLastDescriptor)
        return {};
    return "it is the number of an open file descriptor, 0 to " + std::to_string(kLastDescriptor)
        + ", as in `--pin-fd 3 3< FILE`";
}

/// No program that is started from here inherits it. A standard stream stays open, so that nothing
/// that is opened later takes its place.
void closeRead(int descriptor)
{
    const int nothing
        = descriptor <= STDERR_FILENO ? ::open("/dev/null", O_RDWR | O_CLOEXEC) : kNoDescriptor;
    if (nothing == kNoDescriptor) {
        ::close(descriptor);
        return;
    }
    ::dup2(nothing, descriptor);
    ::close(nothing);
}

Result<SecretBytes> secretOf(const SigningOptions &options)
{
    if (options.pinDescriptor < 0)
        return SecretBytes();
    Result<SecretBytes> secret = SecretBytes::readFrom(options.pinDescriptor);
    closeRead(options.pinDescriptor);
    return secret;
}

Result<SigningOrder> withKey(
    SigningOrder order, const SigningOptions &options, const std::string &utc)
{
    ::prctl(PR_SET_DUMPABLE, 0);
    const Result<SecretBytes> secret = secretOf(options);
    if (!secret)
        return tl::unexpected<Error>(secret.error());
    const Result<SigningKey> key = SigningKey::open(options.key, *secret);
    if (!key)
        return tl::unexpected<Error>(key.error());
    if (const Result<void> valid = key->checkValidAt(utc); !valid)
        return tl::unexpected<Error>(valid.error());
    order.key = *key;
    return order;
}

} // namespace

void declareSigning(CLI::App &verb, SigningOptions &options)
{
    verb.add_option("--key", options.key,
            "Sign with this key: a PKCS#12 file, a PEM file with key and certificates, or a token's")
        ->type_name("FILE.p12|FILE.pem|pkcs11:URI");
    verb.add_option("--pin-fd", options.pinDescriptor,
            "Read the key's PIN or passphrase from this open file descriptor")
        ->check(CLI::Validator(wrongDescriptor, "", ""))
        ->type_name("N");
    verb.add_option("--seal-command", options.sealCommand,
            "Have this command sign the PDF: it gets the SHA-256, and answers with a CMS")
        ->type_name("CMD");
    verb.add_option("--tsa", options.authority,
            "Put a time stamp of this authority over the PDF's signature (RFC 3161)")
        ->type_name("http://HOST/PATH");
    verb.add_flag("--unsigned", options.isUnsigned, "Without a signature");
}

Result<SigningOrder> signingOrder(const SigningOptions &options, const std::string &utc)
{
    if (const Result<void> fit = checkTogether(options); !fit)
        return tl::unexpected<Error>(fit.error());
    SigningOrder order{.sealCommand = options.sealCommand, .authority = options.authority};
    if (!order.authority.empty())
        if (const Result<void> address = checkHttpAddress(order.authority); !address)
            return tl::unexpected<Error>(address.error());
    if (!order.sealCommand.empty())
        if (const auto words = wordsOfCommand(order.sealCommand); !words)
            return tl::unexpected<Error>(words.error());
    return options.key.empty() ? order : withKey(std::move(order), options, utc);
}

} // namespace dyncal
