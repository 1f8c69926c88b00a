// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/seal_command.h"
#include "tests/support/made_keys.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <fcntl.h>
#include <unistd.h>

using namespace dyncal;
using namespace dyncal::testing;
using namespace std::chrono_literals;

/// What a seal command is given and what is taken from it, whatever it does.
class TestSealBounds : public QObject
{
    Q_OBJECT

private:
    MadeKeys m_keys;
    const std::string m_hash = std::string(32, 'a') + std::string(32, '7');

    /// A program in a folder with a blank and a quote in its name.
    std::string program(const std::string &lines) const
    {
        const std::string folder = m_keys.file("a folder's");
        std::filesystem::create_directory(folder);
        const std::string path = m_keys.write("a folder's/seal service", "#!/bin/sh\n" + lines);
        std::filesystem::permissions(path, std::filesystem::perms::owner_all);
        return '"' + path + '"';
    }
    Result<std::string> sealed(const std::string &lines, const std::string &arguments = "",
        const AnswerLimits &limits = {.time = 10s}) const
    {
        return sealedBy(program(lines) + arguments, m_hash, {}, limits);
    }
    std::string refusal(const std::string &lines, const AnswerLimits &limits = {.time = 10s}) const
    {
        const auto cms = sealed(lines, "", limits);
        return cms ? "(sealed)" : english(cms.error().message);
    }

private slots:
    void initTestCase() { QVERIFY(m_keys.isMade); }

    void argumentsAndInput_areExact()
    {
        const std::string seen = m_keys.file("seen");
        QVERIFY(!sealed("for one in \"$0\" \"$@\"; do printf '[%s]\\n' \"$one\"; done > '" + seen
                + "'\ncat >> '" + seen + "'\n",
            " 'two words' \"it's\" '' $HOME \\n"));
        const std::string path = m_keys.file("a folder's") + "/seal service";
        QCOMPARE(m_keys.content("seen"),
            "[" + path + "]\n[two words]\n[it's]\n[]\n[$HOME]\n[\\n]\n" + m_hash + "\n");
    }

    /// The hash is no secret, yet lists of processes are no place for it.
    void hash_isNoArgumentAndInNoEnvironment()
    {
        const std::string seen = m_keys.file("seen");
        QVERIFY(!sealed("tr '\\0' '\\n' < /proc/$$/cmdline > '" + seen
            + "'\ntr '\\0' '\\n' < /proc/$$/environ >> '" + seen + "'\n"));
        QVERIFY(m_keys.content("seen").find("seal service") != std::string::npos);
        QVERIFY(m_keys.content("seen").find(m_hash) == std::string::npos);
    }

    /// Files that are open here, as that of a PIN or of a registry, are not open there.
    void openFiles_areNotHandedOn()
    {
        const std::string secret = m_keys.write("open file", "secret");
        const int file = ::open(secret.c_str(), O_RDONLY | O_CLOEXEC);
        const std::string seen = m_keys.file("seen");
        QVERIFY(!sealed("ls -l /proc/$$/fd > '" + seen + "'\n"));
        ::close(file);
        const std::string list = m_keys.content("seen");
        QVERIFY(list.find(" 0 -> ") != std::string::npos);
        QVERIFY2(list.find("open file") == std::string::npos, list.c_str());
        QVERIFY2(list.find("memfd:hash") == list.rfind("memfd:hash"), list.c_str());
    }

    void signals_areAsAProgramExpectsThem()
    {
        const std::string seen = m_keys.file("seen");
        QVERIFY(!sealed("grep -E '^Sig(Blk|Ign)' /proc/self/status > '" + seen + "'\n"));
        const QByteArray list = QByteArray::fromStdString(m_keys.content("seen"));
        QVERIFY2(list.contains("SigBlk:\t0000000000000000"), list);
        // The C library keeps 32 and 33 for itself.
        const QByteArray ignored = list.mid(list.indexOf("SigIgn:\t") + 8).trimmed();
        QVERIFY2(
            ignored.size() == 16 && (ignored.toULongLong(nullptr, 16) & 0x7fffffff) == 0, list);
    }

    void exitCodes_otherThan0_areRefusals()
    {
        for (const char *code : {"1", "2", "77", "126", "127", "255"})
            QVERIFY2(refusal("printf x; exit " + std::string(code)).find("did not give a signature")
                    != std::string::npos,
                code);
        for (const char *signal : {"TERM", "KILL", "SEGV", "PIPE"})
            QVERIFY2(refusal("printf x; kill -" + std::string(signal) + " $$")
                         .find("did not give a signature")
                    != std::string::npos,
                signal);
        QVERIFY(refusal("printf x").find("but not with a signature") != std::string::npos);
    }

    void answers_areTakenWithinTheirBounds()
    {
        const AnswerLimits limits{.time = 10s, .bytes = 1000};
        const auto writing
            = [](int bytes) { return "head -c " + std::to_string(bytes) + " /dev/zero\n"; };
        QVERIFY(refusal(writing(1000), limits).find("but not with a") != std::string::npos);
        QVERIFY(refusal(writing(1001), limits).find("at most 1000 bytes") != std::string::npos);
        QVERIFY(refusal(writing(0), limits).find("did not give") != std::string::npos);
        QElapsedTimer timer;
        timer.start();
        QVERIFY(refusal("yes\n", limits).find("at most 1000 bytes") != std::string::npos);
        QVERIFY(refusal("trap '' TERM INT HUP PIPE; while :; do echo x; sleep 0.01; done\n",
                    {.time = 1s})
                    .find("within 1 s")
            != std::string::npos);
        QVERIFY(timer.elapsed() < 5000);
    }

    /// It is ended, and nothing of it stays: not even as a process that nobody waited for.
    void commandThatHangs_isGone()
    {
        const std::string seen = m_keys.file("seen");
        QVERIFY(refusal("echo $$ > '" + seen + "'\nexec sleep 60\n", {.time = 500ms})
                    .find("did not give")
            != std::string::npos);
        const QString process = QString::fromStdString(m_keys.content("seen")).trimmed();
        QVERIFY(process.toInt() > 1);
        QVERIFY(!QFile::exists("/proc/" + process));
    }

    void answersThatAreNone_areNotRepeated()
    {
        for (const char *garbage : {"\\033[31mgarbage", "<script>garbage", "garbage\\n\\n\\n"}) {
            const std::string said = refusal("printf '" + std::string(garbage) + "'\n");
            QVERIFY2(said.find("but not with a signature over the hash") != std::string::npos,
                said.c_str());
            QVERIFY2(said.find("garbage") == std::string::npos, said.c_str());
        }
    }

    void programsThatAreNone_areSaid()
    {
        const std::string text = m_keys.write("text", "no program");
        for (const std::string &none : {text, m_keys.file("."), m_keys.file("nowhere"),
                 std::string("no-such-program-in-PATH"), "/" + std::string(10000, 'x')}) {
            const auto cms = sealedBy("'" + none + "'", m_hash, {}, {.time = 5s});
            QVERIFY(!cms);
            QCOMPARE(cms.error().kind, ErrorKind::FileUnreadable);
            QVERIFY(english(cms.error().message).find("must be startable") != std::string::npos);
        }
    }

    void words_areDividedInTime()
    {
        const auto many = wordsOfCommand(QByteArray("a ").repeated(500000).toStdString());
        QVERIFY(many);
        QCOMPARE(many->size(), std::size_t(500000));
        const auto one = wordsOfCommand("'" + std::string(5000000, ' ') + "'");
        QVERIFY(one && one->size() == 1 && one->front().size() == 5000000);
        QCOMPARE(*wordsOfCommand("a'b c'\"d e\"f"), std::vector<std::string>{"ab cd ef"});
        QCOMPARE(*wordsOfCommand("å\tä"), (std::vector<std::string>{"å", "ä"}));
    }
};

DYNCAL_TEST(TestSealBounds)
#include "tst_seal_bounds.moc"
