// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/content_hash.h"
#include "core/signing/cms_signature.h"
#include "core/signing/seal_command.h"
#include "tests/support/made_keys.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <thread>

using namespace dyncal;
using namespace dyncal::testing;

/// Seals by another program, written in Python with a CMS of its own making.
class TestSealCommand : public QObject
{
    Q_OBJECT

private:
    MadeKeys m_keys;
    const std::string m_hash = sha256Hex(std::string_view("content"));

    std::string service() const
    {
        return std::string("python3 '")
            .append(qEnvironmentVariable("DYNCAL_SOURCE_DIR").toStdString())
            .append("/tests/support/seal_service.py' '")
            .append(m_keys.file("lab.key"))
            .append("' \"")
            .append(m_keys.file("lab.pem"))
            .append("\"");
    }
    /// A shell script as a command.
    std::string script(const std::string &lines) const
    {
        return "sh '" + m_keys.write("script.sh", lines) + "'";
    }

private slots:
    void initTestCase()
    {
        QVERIFY(m_keys.isMade);
        QVERIFY(m_keys.make("lab", "Lab's own"));
    }

    void hashOut_cmsIn()
    {
        const auto cms = sealedBy(service(), m_hash, {});
        QVERIFY2(cms, cms ? "" : english(cms.error().message).c_str());
        const SignatureCheck found = checkCms(
            *cms, {"content"}, MadeKeys::kNow, {m_keys.content("root.pem"), MadeKeys::kNow});
        QVERIFY(found.status == SignatureCheck::Status::Valid);
        QCOMPARE(found.signer, std::string("Lab's own"));
    }

    void command_getsTheHashOnly()
    {
        const auto cms
            = sealedBy(script("cat > '" + m_keys.file("seen") + "'; exit 1\n"), m_hash, {});
        QVERIFY(!cms);
        QCOMPARE(m_keys.content("seen"), m_hash + "\n");
    }

    void nothingHasAMeaningToAShell()
    {
        const std::string trap = m_keys.file("trap");
        for (const std::string &evil :
            {"; touch " + trap, "$(touch " + trap + ")", "`touch " + trap + "`", "&& touch " + trap,
                "> " + trap, "| touch " + trap, "\n touch " + trap})
            static_cast<void>(sealedBy("true " + evil, m_hash, {}));
        QVERIFY(!QFile::exists(m_keys.path("trap")));
        using Words = std::vector<std::string>;
        QCOMPARE(*wordsOfCommand("  a  b\tc "), (Words{"a", "b", "c"}));
        QCOMPARE(*wordsOfCommand("'a b' \"c 'd\" e'f'g ''"), (Words{"a b", "c 'd", "efg", ""}));
        QCOMPARE(*wordsOfCommand("a $HOME \\n *"), (Words{"a", "$HOME", "\\n", "*"}));
        for (const std::string &bad : {std::string(), std::string(" "), std::string("'a"),
                 std::string("a \"b"), std::string("'' a"), std::string("a\0b", 3)})
            QVERIFY(!wordsOfCommand(bad));
    }

    void failures_areOneSentence_data()
    {
        QTest::addColumn<QString>("command");
        QTest::addColumn<int>("kind");
        const auto row = [](const char *name, const std::string &command, ErrorKind kind) {
            QTest::newRow(name) << QString::fromStdString(command) << static_cast<int>(kind);
        };
        row("no program", "/nowhere/at/all", ErrorKind::FileUnreadable);
        row("refuses", "false", ErrorKind::FileUnreadable);
        row("says nothing", "true", ErrorKind::FileUnreadable);
        row("ended by a signal", "sh -c 'echo x; kill -9 $$'", ErrorKind::FileUnreadable);
        row("too much", "cat /dev/zero", ErrorKind::FileUnreadable);
        row("too late", "sleep 20", ErrorKind::FileUnreadable);
        row("closes and stays", "sh -c 'exec >&-; sleep 20'", ErrorKind::FileUnreadable);
        row("no CMS", "echo text", ErrorKind::DataBlocked);
        row("open quote", "sh 'x", ErrorKind::Usage);
    }
    void failures_areOneSentence()
    {
        using namespace std::chrono_literals;
        QFETCH(QString, command);
        QFETCH(int, kind);
        QElapsedTimer timer;
        timer.start();
        const auto cms = sealedBy(command.toStdString(), m_hash, {}, {.time = 2s});
        QVERIFY(!cms);
        QCOMPARE(static_cast<int>(cms.error().kind), kind);
        QVERIFY(timer.elapsed() < 6000);
    }

    void otherHash_isRefused()
    {
        const std::string other = script("echo " + std::string(64, '0') + " | " + service() + "\n");
        const auto cms = sealedBy(other, m_hash, {});
        QVERIFY(!cms);
        QCOMPARE(cms.error().kind, ErrorKind::DataBlocked);
    }

    void stop_endsTheCommand()
    {
        std::stop_source stop;
        const std::jthread later([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
            stop.request_stop();
        });
        QElapsedTimer timer;
        timer.start();
        const auto cms = sealedBy("sleep 20", m_hash, stop.get_token());
        QCOMPARE(cms.error().kind, ErrorKind::Cancelled);
        QVERIFY(timer.elapsed() < 5000);
    }
};

DYNCAL_TEST(TestSealCommand)
#include "tst_seal_command.moc"
