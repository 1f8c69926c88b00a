// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/file_bytes.h"
#include "tests/support/test_program.h"
#include "ui/shell/preferences/preferences.h"
#include "ui/shell/registry/signing_panel.h"
#include "ui/stages/frame/prompts.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest>

#include <memory>

#include <sys/prctl.h>

using namespace dyncal;

namespace {

/// The panel with its own settings file and scripted dialogs.
struct Bench
{
    QTemporaryDir folder;
    Preferences preferences{folder.filePath("settings.ini")};
    Prompts prompts;
    std::unique_ptr<SigningPanel> panel;

    Bench()
    {
        prompts.setScripted();
        build();
    }
    void build()
    {
        panel = std::make_unique<SigningPanel>(preferences, prompts, nullptr);
        panel->show();
    }
    QLineEdit *field(const char *name) const { return panel->findChild<QLineEdit *>(name); }
    void choose(SigningWay way) const
    {
        auto *box = panel->findChild<QComboBox *>("signingWay");
        box->setCurrentIndex(box->findData(signingWayName(way)));
        emit box->activated(box->currentIndex());
    }
    QStringList shownFields() const
    {
        QStringList shown;
        for (const QLineEdit *edit : panel->findChildren<QLineEdit *>())
            if (edit->isVisible())
                shown << edit->objectName();
        shown.sort();
        return shown;
    }
    QByteArray settings() const { return testing::bytesOf(folder.filePath("settings.ini")); }
};

} // namespace

/// Who signs, chosen in the dialog: what is asked, what is remembered, and what never is.
class TestSigningPanel : public QObject
{
    Q_OBJECT

private slots:
    void way_hasItsOwnFields()
    {
        const Bench bench;
        QCOMPARE(bench.panel->choice().way, SigningWay::Unsigned);
        QCOMPARE(bench.shownFields(), QStringList());
        bench.choose(SigningWay::KeyFile);
        QCOMPARE(bench.shownFields(),
            QStringList({"signingAuthority", "signingKeyFile", "signingSecret"}));
        bench.choose(SigningWay::Token);
        QCOMPARE(bench.shownFields(),
            QStringList({"signingAuthority", "signingSecret", "signingToken"}));
        bench.choose(SigningWay::Service);
        QCOMPARE(bench.shownFields(), QStringList({"signingAuthority", "signingService"}));
        bench.choose(SigningWay::Unsigned);
        QCOMPARE(bench.shownFields(), QStringList());
    }

    void choice_isWhatWasTyped_andTold()
    {
        const Bench bench;
        QSignalSpy changed(bench.panel.get(), &SigningPanel::changed);
        bench.choose(SigningWay::Token);
        QCOMPARE(changed.size(), 1);
        bench.field("signingToken")->setText("  pkcs11:token=lab ");
        bench.field("signingAuthority")->setText("http://tsa/ ");
        QCOMPARE(changed.size(), 3);
        QCOMPARE(bench.panel->choice().words(true),
            QStringList({"--key=pkcs11:token=lab", "--pin-fd=0", "--tsa=http://tsa/"}));
    }

    void keyFile_isChosenInADialog()
    {
        Bench bench;
        bench.choose(SigningWay::KeyFile);
        bench.prompts.setNextFile("/keys/lab.p12");
        bench.panel->findChild<QPushButton *>("signingChoose")->click();
        QCOMPARE(bench.panel->choice().keyFile, QString("/keys/lab.p12"));
        bench.panel->findChild<QPushButton *>("signingChoose")->click(); // cancelled
        QCOMPARE(bench.panel->choice().keyFile, QString("/keys/lab.p12"));
    }

    void choice_isRemembered_theSecretIsNot()
    {
        Bench bench;
        bench.choose(SigningWay::KeyFile);
        bench.field("signingKeyFile")->setText("/keys/lab.p12");
        bench.field("signingAuthority")->setText("http://tsa/");
        bench.field("signingToken")->setText("pkcs11:token=lab?pin-value=4815");
        QTest::keyClicks(bench.field("signingSecret"), "hemligt-ord-77");
        bench.panel->remember();
        bench.build();
        QCOMPARE(bench.panel->choice().way, SigningWay::KeyFile);
        QCOMPARE(bench.panel->choice().keyFile, QString("/keys/lab.p12"));
        QCOMPARE(bench.panel->choice().authority, QString("http://tsa/"));
        QCOMPARE(bench.panel->choice().token, QString()); // it was never looked at
        QVERIFY(bench.field("signingSecret")->text().isEmpty());
        bench.choose(SigningWay::Token);
        bench.field("signingToken")->setText("pkcs11:token=lab");
        bench.panel->remember();
        QCOMPARE(
            bench.preferences.issuing(Preferences::Issuing::Token), QString("pkcs11:token=lab"));
        QVERIFY(!bench.settings().isEmpty()
            || !bench.preferences.issuing(Preferences::Issuing::Way).isEmpty());
        QVERIFY(!bench.settings().contains("hemligt") && !bench.settings().contains("4815"));
    }

    void secret_isNotShown_andLeavesItsField()
    {
        Bench bench;
        const auto isGone = [&] { return bench.field("signingSecret")->text().isEmpty(); };
        const auto type = [&] { QTest::keyClicks(bench.field("signingSecret"), "ord-77"); };
        bench.choose(SigningWay::KeyFile);
        type();
        QCOMPARE(bench.field("signingSecret")->echoMode(), QLineEdit::Password);
        QVERIFY(!bench.field("signingSecret")->displayText().contains("ord"));
        QVERIFY(bench.panel->takeSecret().isGiven());
        QVERIFY(isGone() && !bench.panel->takeSecret().isGiven());
        type();
        bench.choose(SigningWay::Token); // whose PIN is another
        QVERIFY(isGone());
        type();
        bench.panel->hide();
        QVERIFY(isGone());
    }

    void memoryWithASecret_isInNoCoreFile()
    {
        Bench bench;
        const int before = ::prctl(PR_GET_DUMPABLE);
        bench.choose(SigningWay::KeyFile);
        QTest::keyClicks(bench.field("signingSecret"), "o");
        QCOMPARE(::prctl(PR_GET_DUMPABLE), 0);
        (void)bench.panel->takeSecret();
        QCOMPARE(::prctl(PR_GET_DUMPABLE), before);
        QTest::keyClicks(bench.field("signingSecret"), "o");
        bench.panel.reset();
        QCOMPARE(::prctl(PR_GET_DUMPABLE), before);
    }
};

DYNCAL_TEST(TestSigningPanel)
#include "tst_signing_panel.moc"
