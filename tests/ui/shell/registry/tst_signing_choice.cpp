// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/shell/registry/signing_choice.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace dyncal;

/// Who signs, as `dyncal issue` is told it, and what is missing of it.
class TestSigningChoice : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    QString keyFile() const
    {
        QFile file(m_folder.filePath("lab.p12"));
        (void)file.open(QIODevice::WriteOnly);
        return file.fileName();
    }

private slots:
    void words_areThoseOfTheWay()
    {
        SigningChoice choice{SigningWay::Unsigned, "/a b/lab.p12", "pkcs11:token=lab;object=seal",
            "seal 'a b'", "http://tsa/"};
        QCOMPARE(choice.words(false), QStringList("--unsigned"));
        QCOMPARE(choice.words(true), QStringList("--unsigned")); // which has no key to open
        choice.way = SigningWay::KeyFile;
        QCOMPARE(choice.words(true),
            QStringList({"--key=/a b/lab.p12", "--pin-fd=0", "--tsa=http://tsa/"}));
        choice.way = SigningWay::Token;
        choice.authority.clear();
        QCOMPARE(
            choice.words(true), QStringList({"--key=pkcs11:token=lab;object=seal", "--pin-fd=0"}));
        QCOMPARE(choice.words(false), QStringList("--key=pkcs11:token=lab;object=seal"));
        choice.way = SigningWay::Service;
        QCOMPARE(choice.words(false), QStringList("--seal-command=seal 'a b'"));
    }

    void whatIsComplete_hasNoObstacles()
    {
        const QString key = keyFile();
        QVERIFY(SigningChoice{}.obstacles().isEmpty());
        for (const SigningWay way :
            {SigningWay::Unsigned, SigningWay::KeyFile, SigningWay::Token, SigningWay::Service})
            for (const char *authority : {"", "http://tsa.example.org/a"})
                QCOMPARE((SigningChoice{way, key, "pkcs11:token=lab;object=seal",
                             "seal --profile lab", authority}
                                 .obstacles()),
                    QStringList());
        // What another way would lack does not matter.
        QVERIFY((SigningChoice{SigningWay::KeyFile, key, {}, "'", {}}.obstacles().isEmpty()));
        QVERIFY(
            (SigningChoice{SigningWay::Unsigned, {}, {}, {}, "nonsense"}.obstacles().isEmpty()));
    }

    void whatIsMissing_isASentenceEach_data()
    {
        QTest::addColumn<int>("way");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("authority");
        QTest::addColumn<QStringList>("said");
        const auto row = [](const char *name, SigningWay way, const QString &text,
                             const QString &authority, const QStringList &said) {
            QTest::newRow(name) << static_cast<int>(way) << text << authority << said;
        };
        const QString stamps = "no address of a time-stamping authority";
        row("no file", SigningWay::KeyFile, "", "", {"file of the key"});
        row("file gone", SigningWay::KeyFile, m_folder.filePath("none.pem"), "",
            {"There is no key file"});
        row("folder", SigningWay::KeyFile, m_folder.path(), "", {"There is no key file"});
        row("no token", SigningWay::Token, "", "", {"pkcs11:"});
        row("no uri", SigningWay::Token, "lab", "", {"pkcs11:"});
        row("pin in it", SigningWay::Token, "pkcs11:token=lab?pin-value=1", "", {"holds a PIN"});
        row("source of it", SigningWay::Token, "pkcs11:token=lab?pin-source=/a", "",
            {"holds a PIN"});
        row("no command", SigningWay::Service, "", "", {"command of the service"});
        row("open quote", SigningWay::Service, "seal 'a", "", {"no command to seal with"});
        row("https", SigningWay::KeyFile, keyFile(), "https://tsa/", {stamps});
        row("both", SigningWay::KeyFile, "", "tsa", {"file of the key", stamps});
    }
    void whatIsMissing_isASentenceEach()
    {
        QFETCH(int, way);
        QFETCH(QString, text);
        QFETCH(QString, authority);
        QFETCH(QStringList, said);
        const SigningChoice choice{static_cast<SigningWay>(way), text, text, text, authority};
        const QStringList obstacles = choice.obstacles();
        QCOMPARE(obstacles.size(), said.size());
        for (int i = 0; i < said.size(); ++i) {
            QVERIFY2(obstacles[i].contains(said[i]), qPrintable(obstacles[i]));
            QVERIFY2(obstacles[i].endsWith('.'), qPrintable(obstacles[i]));
        }
    }

    void hostileName_isFitToShow()
    {
        const SigningChoice choice{SigningWay::KeyFile, QString("/none\u202e\n<b>"), {}, {}, {}};
        QVERIFY(!choice.obstacles().front().contains('\n'));
        QVERIFY(!choice.obstacles().front().contains(QChar(0x202e)));
    }

    void way_isRememberedByItsName()
    {
        for (const SigningWay way :
            {SigningWay::Unsigned, SigningWay::KeyFile, SigningWay::Token, SigningWay::Service})
            QCOMPARE(signingWayOf(signingWayName(way)), way);
        for (const char *none : {"", "of later versions"})
            QCOMPARE(signingWayOf(none), SigningWay::Unsigned);
    }
};

DYNCAL_TEST(TestSigningChoice)
#include "tst_signing_choice.moc"
