// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/support/made_keys.h"

namespace dyncal::testing {

/// A SoftHSM2 token of the test's own, with the key and certificate "lab" of the keys under the
/// label "seal". SOFTHSM2_CONF and PKCS11_MODULE_PATH are set for this process and those it starts.
class MadeToken
{
public:
    static constexpr const char *kPin = "48151623";
    static constexpr const char *kModule = "/usr/lib/softhsm/libsofthsm2.so";
    static constexpr const char *kUri = "pkcs11:token=lab;object=seal";

    explicit MadeToken(const MadeKeys &keys)
    {
        std::filesystem::create_directory(keys.file("tokens"));
        qputenv("SOFTHSM2_CONF",
            keys.write("softhsm2.conf", "directories.tokendir = " + keys.file("tokens") + "\n")
                .c_str());
        qputenv("PKCS11_MODULE_PATH", kModule);
        const QStringList login{"--module", kModule, "--login", "--pin", kPin, "--token-label",
            "lab", "--id", "01", "--label", "seal", "--write-object"};
        isMade
            = ran("softhsm2-util",
                  {"--init-token", "--free", "--label", "lab", "--pin", kPin, "--so-pin", "0000"})
            && keys.openssl({"pkey", "-in", keys.path("lab.key"), "-outform", "DER", "-out",
                keys.path("lab.der")})
            && keys.openssl({"x509", "-in", keys.path("lab.pem"), "-outform", "DER", "-out",
                keys.path("lab.crt")})
            && ran("pkcs11-tool", login + QStringList{keys.path("lab.der"), "--type", "privkey"})
            && ran("pkcs11-tool", login + QStringList{keys.path("lab.crt"), "--type", "cert"});
    }

    bool isMade = false;

private:
    static bool ran(const QString &program, const QStringList &arguments)
    {
        const ProgramAnswer answer = answerOf(program, arguments);
        if (!answer.ran)
            qWarning("%s: %s", qPrintable(program), (answer.err + answer.out).constData());
        return answer.ran;
    }
};

} // namespace dyncal::testing
