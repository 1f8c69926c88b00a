// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/support/made_keys.h"

namespace dyncal::testing {

/// A time-stamping authority by `openssl ts`, with the key "stamps" of the keys.
class MadeStamps
{
public:
    explicit MadeStamps(const MadeKeys &keys)
        : m_keys(keys)
    {
        keys.write("ts.cnf",
            "[tsa]\ndefault_tsa=t\n[t]\nserial=" + keys.file("stamps.serial") + "\nsigner_cert="
                + keys.file("stamps.pem") + "\nsigner_key=" + keys.file("stamps.key")
                + "\nsigner_digest=sha256\ndefault_policy=1.2.3.4\ndigests=sha256\n"
                  "ess_cert_id_alg=sha256\n");
        keys.write("stamps.serial", "01\n");
    }

    /// The reply to a request, both DER.
    std::string reply(const std::string &request) const
    {
        m_keys.write("stamps.tsq", request);
        m_keys.openssl({"ts", "-reply", "-config", m_keys.path("ts.cnf"), "-section", "t",
            "-queryfile", m_keys.path("stamps.tsq"), "-out", m_keys.path("stamps.tsr")});
        return m_keys.content("stamps.tsr");
    }

private:
    const MadeKeys &m_keys;
};

} // namespace dyncal::testing
