// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/support/program_answer.h"
#include "tests/support/scratch_folder.h"

#include <QString>

namespace dyncal::testing {

/// A laboratory's keys, made by openssl in a folder of their own: an authority (root.pem) and what
/// it certifies, valid 2025 to 2035. For NAME there are NAME.key, NAME.pem (certificate) and
/// NAME.all.pem (both, and the authority's certificate).
class MadeKeys
{
public:
    static constexpr const char *kFrom = "20250101000000Z";
    static constexpr const char *kUntil = "20351231235959Z";
    static constexpr const char *kNow = "2026-06-01T12:00:00Z"; ///< a moment when all are valid

    MadeKeys()
    {
        write("ca.cnf",
            "[ca]\ndefault_ca=c\n[c]\ndatabase=" + file("index.txt") + "\nserial=" + file("serial")
                + "\nnew_certs_dir=" + file(".")
                + "\npolicy=p\ndefault_md=sha256\nunique_subject=no\n"
                  "[p]\ncommonName=supplied\norganizationName=optional\n"
                  "[root]\nbasicConstraints=critical,CA:true\nkeyUsage=critical,keyCertSign\n"
                  "[signer]\nbasicConstraints=CA:false\nkeyUsage=critical,digitalSignature\n"
                  "[cipher]\nkeyUsage=critical,keyEncipherment\n"
                  "[stamps]\nkeyUsage=critical,digitalSignature\n"
                  "extendedKeyUsage=critical,timeStamping\n");
        write("index.txt", "");
        write("serial", "01\n");
        isMade = request("root", "Test Authority", {"-newkey", "rsa:2048"})
            && certify("root", "root", {"-selfsign", "-keyfile", path("root.key")});
    }

    bool isMade = false;

    std::string file(const std::string &name) const { return m_folder.file(name); }
    QString path(const QString &name) const
    {
        return QString::fromStdString(file(name.toStdString()));
    }
    std::string content(const std::string &name) const { return contentOf(file(name)); }
    std::string write(const std::string &name, const std::string &bytes) const
    {
        return m_folder.write(name, bytes.data(), bytes.size());
    }

    bool openssl(const QStringList &arguments) const
    {
        const ProgramAnswer answer = answerOf("openssl", arguments);
        if (!answer.ran)
            qWarning("openssl %s: %s", qPrintable(arguments.join(' ')), answer.err.constData());
        return answer.ran;
    }

    /// A key and its certificate, of `section`: "signer", "cipher" (not for signatures), "stamps".
    bool make(const std::string &name, const QString &subject, const QString &section = "signer",
        const QStringList &key = {"-newkey", "rsa:2048"}, const QString &from = kFrom,
        const QString &until = kUntil) const
    {
        const bool made = request(name, subject, key)
            && certify(name, section, {"-cert", path("root.pem"), "-keyfile", path("root.key")},
                from, until);
        write(name + ".all.pem",
            content(name + ".key") + content(name + ".pem") + content("root.pem"));
        return made;
    }

    /// The same certified by another of these keys, which is of section "root" itself; above it are
    /// both in NAME.all.pem.
    bool makeUnder(const std::string &issuer, const std::string &name, const QString &subject,
        const QString &section = "signer") const
    {
        const QString above = path(QString::fromStdString(issuer));
        const bool made = request(name, subject, {"-newkey", "rsa:2048"})
            && certify(name, section, {"-cert", above + ".pem", "-keyfile", above + ".key"});
        write(name + ".all.pem",
            content(name + ".key") + content(name + ".pem") + content(issuer + ".pem")
                + content("root.pem"));
        return made;
    }

    /// NAME.p12 with a passphrase.
    bool makePkcs12(const std::string &name, const QString &passphrase) const
    {
        const QString base = path(QString::fromStdString(name));
        return openssl(
            {"pkcs12", "-export", "-inkey", base + ".key", "-in", base + ".pem", "-certfile",
                path("root.pem"), "-passout", "pass:" + passphrase, "-out", base + ".p12"});
    }

private:
    bool request(const std::string &name, const QString &subject, const QStringList &key) const
    {
        const QString base = path(QString::fromStdString(name));
        return openssl(QStringList{"req", "-new", "-nodes", "-keyout", base + ".key", "-out",
                           base + ".csr", "-utf8", "-subj", "/CN=" + subject}
            + key);
    }
    bool certify(const std::string &name, const QString &section, const QStringList &by,
        const QString &from = kFrom, const QString &until = kUntil) const
    {
        const QString base = path(QString::fromStdString(name));
        return openssl(QStringList{"ca", "-batch", "-notext", "-utf8", "-config", path("ca.cnf"),
                           "-in", base + ".csr", "-out", base + ".pem", "-extensions", section,
                           "-startdate", from, "-enddate", until}
            + by);
    }

    ScratchFolder m_folder;
};

} // namespace dyncal::testing
