// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A certificate issued and signed from the window, by the program as it is built, and verified in
// the window of the registry.

#include "tests/support/answering_server.h"
#include "tests/support/made_stamps.h"
#include "tests/support/made_token.h"
#include "tests/support/test_program.h"
#include "tests/ui/shell/registry/issuing_bench.h"
#include "ui/shell/registry/signing_choice.h"

#include <QComboBox>
#include <QLineEdit>
#include <QTabWidget>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr int kVerifyTab = 3;

/// A job that is open, with the dialog that issues it, over a program that keeps its arguments.
struct Bench : test::IssuingBench
{
    explicit Bench(const QString &recording)
    {
        program = path("dyncal-that-keeps-arguments");
        writeBytes(program,
            "#!/bin/sh\necho \"$@\" >> '" + path("arguments").toUtf8()
                + "'\nexec \"$DYNCAL_BINARY\" \"$@\"\n");
        QFile::setPermissions(program, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        if (!job.begin(recording))
            qFatal("no job");
        openJob();
        showIssuing();
    }

    void choose(SigningWay way) const
    {
        auto *box = find<QComboBox>("signingWay");
        box->setCurrentIndex(box->findData(signingWayName(way)));
        emit box->activated(box->currentIndex());
    }
    void type(const char *name, const QString &text) const
    {
        find<QLineEdit>(name)->clear();
        QTest::keyClicks(find<QLineEdit>(name), text);
    }
    QString outcome() const { return text("issueOutcome"); }
    QByteArray arguments() const { return bytesOf(path("arguments")); }
    bool isSecretGone() const { return find<QLineEdit>("signingSecret")->text().isEmpty(); }

    /// Names of files below the job and the settings that hold these bytes.
    QStringList filesWith(const QByteArray &bytes) const
    {
        QStringList names;
        for (const QString &where : {job.folder.path(), folder.path()}) {
            const QMap<QString, QByteArray> files = bytesBelow(where);
            for (auto file = files.begin(); file != files.end(); ++file)
                if (file->contains(bytes))
                    names << file.key();
        }
        return names;
    }
    QJsonObject verified(const QStringList &more) const
    {
        return QJsonDocument::fromJson(job.verify(QStringList{job.output() + "/1"} + more).out)
            .array()
            .first()
            .toObject();
    }

    void showVerifying()
    {
        showRegistry();
        find<QTabWidget>("registryTabs")->setCurrentIndex(kVerifyTab);
    }
    void verifyFolder()
    {
        prompts.setNextFile(job.output());
        button("verifyFolder")->click();
        waitForRegistry();
    }
};

} // namespace

class TestSignedFromWindow : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_recordings;
    MadeKeys m_keys;
    QString recording() const { return m_recordings.filePath("shot.h5"); }
    QStringList trust() const { return {"--trust", m_keys.path("root.pem")}; }

private slots:
    void initTestCase()
    {
        QVERIFY(simulateShortCapture(recording(), 7));
        QVERIFY(m_keys.isMade);
        QVERIFY(m_keys.make("lab", "Example Laboratory"));
        QVERIFY(m_keys.make("stamps", "Stamps", "stamps"));
        QVERIFY(m_keys.make("past", "Past", "signer", {"-newkey", "rsa:2048"}, "20250101000000Z",
            "20250601000000Z"));
        QVERIFY(m_keys.makePkcs12("lab", "hemligt-ord-77"));
    }

    void keyFile_signs_andIsVerifiedInTheWindow()
    {
        Bench bench(recording());
        bench.choose(SigningWay::KeyFile);
        QVERIFY(!bench.button("issueNow")->isEnabled());
        QVERIFY2(bench.obstacles().contains("Name the file of the key that signs."),
            qPrintable(bench.obstacles().join('\n')));
        bench.type("signingKeyFile", m_keys.path("lab.all.pem"));
        QCOMPARE(bench.obstacles().first(), QString("Nothing keeps it from being issued."));
        bench.issueNow();
        QVERIFY2(bench.outcome().startsWith(
                     "Certificate 1 is issued and signed by Example Laboratory: "),
            qPrintable(bench.outcome()));
        QCOMPARE(bench.verified(trust())["status"].toString(), "valid");

        // Whom to trust is not known yet.
        bench.showVerifying();
        bench.verifyFolder();
        QCOMPARE(bench.cell("verifyTable", 0, 2), QString("▲ unknown signer"));
        QCOMPARE(bench.cell("verifyTable", 0, 5), QString("Example Laboratory"));
        QVERIFY(bench.text("verifySummary").startsWith("▲ 1 unchanged, but"));
        bench.prompts.setNextFile(m_keys.path("root.pem"));
        bench.button("verifyChooseTrust")->click();
        bench.verifyFolder();
        QCOMPARE(bench.cell("verifyTable", 0, 2), QString("● valid"));
        QVERIFY(bench.cell("verifyTable", 0, 6).startsWith("20"));
        QCOMPARE(bench.text("verifySummary"), QString("● 1 valid"));
        QCOMPARE(bench.preferences.issuing(Preferences::Issuing::Trust), m_keys.path("root.pem"));

        // Another day, and a day that is none.
        bench.type("verifyMoment", "2040-01-01");
        bench.verifyFolder();
        QCOMPARE(bench.cell("verifyTable", 0, 2), QString("▲ expired"));
        bench.type("verifyMoment", "yesterday");
        bench.verifyFolder();
        QVERIFY2(bench.text("registryOutcome").contains("yesterday"),
            qPrintable(bench.text("registryOutcome")));
        QCOMPARE(bench.rows("verifyTable"), 0); // no verdict of another day is left
        bench.type("verifyMoment", {});

        QByteArray pdf = bytesOf(bench.job.output() + "/1/certificate.pdf");
        pdf[pdf.size() / 3] = static_cast<char>(pdf[pdf.size() / 3] ^ 1);
        QVERIFY(writeBytes(bench.job.output() + "/1/certificate.pdf", pdf));
        bench.verifyFolder();
        QCOMPARE(bench.cell("verifyTable", 0, 2), QString("■ changed"));
        QVERIFY(bench.text("verifySummary").startsWith("■ 1 changed"));
        QVERIFY(bench.find<QLabel>("verifySummary")->font().bold());
    }

    void passphrase_opensTheKey_andIsNowhereAfterwards()
    {
        Bench bench(recording());
        bench.choose(SigningWay::KeyFile);
        bench.type("signingKeyFile", m_keys.path("lab.p12"));
        bench.issueNow(); // without one
        QVERIFY2(bench.outcome().contains("has a passphrase"), qPrintable(bench.outcome()));
        bench.type("signingSecret", "annat-ord-88");
        bench.issueNow();
        QVERIFY2(bench.outcome().contains("does not open the key") && bench.outcome().endsWith('.'),
            qPrintable(bench.outcome()));
        QVERIFY(bench.isSecretGone());
        QVERIFY(!QFile::exists(bench.job.registry())); // no number is taken
        QVERIFY(!QDir(bench.job.output()).exists());

        bench.type("signingSecret", "hemligt-ord-77");
        bench.issueNow();
        QVERIFY2(
            bench.outcome().contains("signed by Example Laboratory"), qPrintable(bench.outcome()));
        QVERIFY(bench.isSecretGone());
        QCOMPARE(bench.verified(trust())["status"].toString(), "valid");
        QCOMPARE(bench.verified(trust())["number"].toInt(), 1);
        QVERIFY2(bench.arguments().contains("--pin-fd=0"), bench.arguments());
        for (const char *secret : {"annat-ord-88", "hemligt-ord-77"}) {
            QCOMPARE(bench.filesWith(secret), QStringList());
            QVERIFY(!bench.outcome().contains(secret));
        }
    }

    void country_isAskedForBeforeTheNumberIsTaken()
    {
        Bench bench(recording()); // its addresses name none
        QCOMPARE(bench.obstacles().first(), QString("Nothing keeps it from being issued."));
        QCOMPARE(bench.obstacles().filter("▲ Caution CER-010").size(), 2);
        bench.issueNow();
        QVERIFY2(bench.outcome().contains("CER-010: The DCC names no country of the customer"),
            qPrintable(bench.outcome()));
    }

    void refusalsOfTheCommand_areSwedishInASwedishWindow()
    {
        const auto restore = qScopeGuard([before = QLocale()] { QLocale::setDefault(before); });
        Bench bench(recording());
        bench.find<QAction>("languageAction_sv")->trigger();
        QTRY_COMPARE(bench.language.code(), QString("sv"));
        bench.choose(SigningWay::KeyFile);
        bench.type("signingKeyFile", m_keys.path("lab.p12"));
        bench.type("signingSecret", "annat-ord-88");
        bench.issueNow();
        QVERIFY2(bench.outcome().startsWith("Lösenfrasen öppnar inte nyckeln i "),
            qPrintable(bench.outcome()));
        bench.choose(SigningWay::Unsigned);
        bench.issueNow();
        QVERIFY2(bench.outcome().startsWith("Bevis 1 ") && bench.outcome().contains("CER-010: DCC"),
            qPrintable(bench.outcome()));
        QVERIFY2(!bench.outcome().contains("names no country"), qPrintable(bench.outcome()));
    }

    void tokenSigns_withItsPin()
    {
        const MadeToken token(m_keys);
        QVERIFY(token.isMade);
        Bench bench(recording());
        bench.choose(SigningWay::Token);
        bench.type("signingToken", QString(MadeToken::kUri) + "?pin-value=" + MadeToken::kPin);
        QVERIFY2(bench.obstacles().first().contains("holds a PIN"),
            qPrintable(bench.obstacles().first()));
        QVERIFY(!bench.button("issueNow")->isEnabled());
        bench.type("signingToken", MadeToken::kUri);
        bench.type("signingSecret", "99999999");
        bench.issueNow();
        QVERIFY2(bench.outcome().contains("the PIN is wrong"), qPrintable(bench.outcome()));
        bench.type("signingSecret", MadeToken::kPin);
        bench.issueNow();
        QVERIFY2(
            bench.outcome().contains("signed by Example Laboratory"), qPrintable(bench.outcome()));
        QCOMPARE(bench.filesWith(MadeToken::kPin), QStringList());
    }

    void serviceSeals_andAnAuthorityStamps()
    {
        const MadeStamps stamps(m_keys);
        const AnsweringServer server([&](const std::string &, const std::string &body) {
            return httpAnswer(stamps.reply(body));
        });
        const QString url = QString::fromStdString(server.url());
        Bench bench(recording());
        bench.choose(SigningWay::Service);
        bench.type("signingService",
            "python3 '" + qEnvironmentVariable("DYNCAL_SOURCE_DIR")
                + "/tests/support/seal_service.py' '" + m_keys.path("lab.key") + "' '"
                + m_keys.path("lab.pem") + "'");
        bench.type("signingAuthority", "http://127.0.0.1:1/");
        bench.issueNow();
        QVERIFY2(bench.outcome().contains("http://127.0.0.1:1/ cannot be reached"),
            qPrintable(bench.outcome()));
        bench.type("signingAuthority", url);
        bench.issueNow();
        QVERIFY2(
            bench.outcome().startsWith(
                "Certificate 1 is issued, signed by Example Laboratory and time stamped by " + url),
            qPrintable(bench.outcome()));
        const QJsonObject verified = bench.verified(trust() + QStringList{"--at", "2040-01-01"});
        QCOMPARE(verified["status"].toString(), "valid");
        QVERIFY(verified["stamped_utc"].toString().endsWith('Z'));
    }

    void keyThatHasExpired_isSaid_andNothingIsTaken()
    {
        Bench bench(recording());
        bench.choose(SigningWay::KeyFile);
        bench.type("signingKeyFile", m_keys.path("past.all.pem"));
        bench.issueNow();
        QVERIFY2(bench.outcome().contains("take one that is valid"), qPrintable(bench.outcome()));
        QVERIFY(!QFile::exists(bench.job.registry()));
    }

    void withoutASignature_isSaid_andTheChoiceIsRemembered()
    {
        Bench bench(recording());
        bench.issueNow();
        QVERIFY2(bench.outcome().startsWith("Certificate 1 is issued, not signed: "),
            qPrintable(bench.outcome()));
        QCOMPARE(bench.verified({})["status"].toString(), "unsigned");
        bench.choose(SigningWay::Service);
        bench.type("signingService", "false");
        bench.find<QLineEdit>("issueReason")->setText("signed now");
        bench.issueNow();
        QVERIFY2(bench.outcome().contains("did not give a signature"), qPrintable(bench.outcome()));
        delete bench.issuing;
        bench.showIssuing();
        QCOMPARE(bench.find<QComboBox>("signingWay")->currentData().toString(),
            signingWayName(SigningWay::Service));
        QCOMPARE(bench.find<QLineEdit>("signingService")->text(), QString("false"));
    }
};

DYNCAL_TEST(TestSignedFromWindow)
#include "tst_signed_from_window.moc"
