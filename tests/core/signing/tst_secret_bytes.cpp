// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/file_descriptor.h"
#include "core/signing/signing_key.h"
#include "tests/support/made_keys.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <array>
#include <thread>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// The letter 13 places on: secrets are looked for by it, so that the search has no copy of them.
char turned(char c)
{
    const bool isSmall = c >= 'a' && c <= 'z', isCapital = c >= 'A' && c <= 'Z';
    const char first = isSmall ? 'a' : 'A';
    return isSmall || isCapital ? static_cast<char>(first + (c - first + 13) % 26) : c;
}

/// How often a text whose turned form this is lies in the memory that this process can write.
class OwnMemory
{
public:
    OwnMemory()
        : m_room(static_cast<char *>(
            ::mmap(nullptr, kRoom, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)))
        , m_memory(::open("/proc/self/mem", O_RDONLY | O_CLOEXEC))
    {
    }
    OwnMemory(const OwnMemory &) = delete;
    OwnMemory &operator=(const OwnMemory &) = delete;
    ~OwnMemory() { ::munmap(m_room, kRoom); }

    int count(const std::string &turnedText) const
    {
        int found = 0;
        std::ifstream maps("/proc/self/maps");
        for (std::string line; std::getline(maps, line);) {
            unsigned long begin = 0, end = 0;
            char write = '-';
            const bool isRegion
                = std::sscanf(line.c_str(), "%lx-%lx r%c", &begin, &end, &write) == 3;
            const auto room = reinterpret_cast<unsigned long>(m_room);
            const bool isOfSanitizer = end - begin > kLargestRegion;
            if (isRegion && write == 'w' && !isOfSanitizer && !(begin <= room && room < end))
                found += countIn(begin, end, turnedText);
        }
        return found;
    }

private:
    static constexpr std::size_t kRoom = 1U << 22U;
    /// Bytes: the notes of a sanitizer are terabytes, of which hardly a page exists.
    static constexpr unsigned long kLargestRegion = 1UL << 36U;

    int countIn(unsigned long begin, unsigned long end, const std::string &text) const
    {
        int found = 0;
        for (unsigned long place = begin; place < end; place += kRoom - text.size()) {
            const ssize_t got = ::pread(
                m_memory.get(), m_room, std::min(kRoom, end - place), static_cast<off_t>(place));
            const std::string_view read(m_room, got > 0 ? static_cast<std::size_t>(got) : 0);
            for (std::size_t i = 0; i + text.size() <= read.size(); ++i)
                found += std::equal(text.begin(), text.end(), read.begin() + static_cast<long>(i),
                             [](char a, char b) { return a == turned(b); })
                    ? 1
                    : 0;
        }
        return found;
    }

    char *m_room;
    FileDescriptor m_memory;
};

} // namespace

/// Passphrases: what is one, and that nothing of them or of a key's file is left behind.
class TestSecretBytes : public QObject
{
    Q_OBJECT

private:
    MadeKeys m_keys;
    OwnMemory m_memory;
    const std::string m_turned = "Urzyvtg Beq Bz Abgugvat"; ///< of the passphrase

    bool shell(const std::string &script) const
    {
        m_keys.write("script.sh", "set -e\ncd '" + m_keys.file(".") + "'\n" + script);
        const ProgramAnswer answer = answerOf("sh", {m_keys.path("script.sh")});
        if (!answer.ran)
            qWarning("%s", answer.err.constData());
        return answer.ran;
    }
    /// As the command line opens a file and hands over the descriptor.
    Result<SecretBytes> secretIn(const std::string &name) const
    {
        const FileDescriptor file(::open(m_keys.file(name).c_str(), O_RDONLY | O_CLOEXEC));
        return SecretBytes::readFrom(file.get());
    }

private slots:
    /// Keys that this process has never read before it opens them.
    void initTestCase()
    {
        QVERIFY(m_keys.isMade);
        QVERIFY(shell("echo '" + m_turned + R"(' | tr A-Za-z N-ZA-Mn-za-m > secret
openssl req -x509 -newkey rsa:2048 -nodes -keyout own.key -out own.crt -subj /CN=Own -days 30
openssl pkcs12 -export -inkey own.key -in own.crt -passout file:secret -out own.p12
openssl pkey -in own.key -aes256 -passout file:secret -out locked.key
cat own.key own.crt > own.pem
cat locked.key own.crt > locked.pem
echo annat > wrong
sed -n 9p own.key | tr A-Za-z N-ZA-Mn-za-m > line
)"));
    }

    void secret_liesInOnePlaceAndIsWiped()
    {
        QCOMPARE(m_memory.count(m_turned), 0);
        {
            Result<SecretBytes> secret = secretIn("secret");
            QVERIFY(secret);
            QCOMPARE(secret->size(), m_turned.size());
            QCOMPARE(m_memory.count(m_turned), 1); // so the search does find it
            SecretBytes moved = std::move(*secret);
            QVERIFY(!secret->isGiven() && secret->size() == 0 && *secret->text() == '\0');
            SecretBytes other = *secretIn("secret");
            QCOMPARE(m_memory.count(m_turned), 2);
            other = std::move(moved);
            QCOMPARE(m_memory.count(m_turned), 1);
        }
        QCOMPARE(m_memory.count(m_turned), 0);
    }

    void openedKeys_leaveNothingBehind_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("secret");
        QTest::addColumn<bool>("opens");
        QTest::newRow("pkcs12") << "own.p12"
                                << "secret" << true;
        QTest::newRow("pkcs12, wrong") << "own.p12"
                                       << "wrong" << false;
        QTest::newRow("pem, locked") << "locked.pem"
                                     << "secret" << true;
        QTest::newRow("pem, wrong") << "locked.pem"
                                    << "wrong" << false;
        QTest::newRow("pem, open") << "own.pem"
                                   << "wrong" << true;
    }
    void openedKeys_leaveNothingBehind()
    {
        QFETCH(QString, name);
        QFETCH(QString, secret);
        QFETCH(bool, opens);
        const std::string line = m_keys.content("line");
        {
            const auto key = SigningKey::open(
                m_keys.file(name.toStdString()), *secretIn(secret.toStdString()));
            QCOMPARE(key.has_value(), opens);
            QCOMPARE(m_memory.count(m_turned), 0); // while the key is open
        }
        QCOMPARE(m_memory.count(m_turned), 0);
        QCOMPARE(line.size(), std::size_t(65));
        QCOMPARE(m_memory.count(line.substr(0, 40)), 0); // of the key's file
    }

    void secret_comesInPieces()
    {
        for (const std::size_t size : {1, 2, 100, 1023, 1024}) {
            int ends[2];
            QVERIFY(::pipe2(ends, O_CLOEXEC) == 0);
            FileDescriptor out(ends[0]), in(ends[1]);
            const std::jthread writing([&] {
                for (std::size_t i = 0; i < size; ++i)
                    if (::write(in.get(), "x", 1) != 1 || i % 500 == 499)
                        std::this_thread::sleep_for(std::chrono::milliseconds(5));
                static_cast<void>(::write(in.get(), "\nrest", 5));
                in = FileDescriptor();
            });
            const auto secret = SecretBytes::readFrom(out.get());
            QVERIFY(secret);
            QCOMPARE(std::string(secret->text()), std::string(size, 'x'));
        }
    }

    void lineOfWindows_hasNoCarriageReturn()
    {
        for (const auto &[bytes, line] :
            {std::pair{"4815\r\n", "4815"}, {"4815\r\nmore\r\n", "4815"}, {"4815\r", "4815\r"},
                {"48\r15\n", "48\r15"}, {"4815\r\r\n", "4815\r"}}) {
            m_keys.write("line", bytes);
            const auto secret = secretIn("line");
            QVERIFY(secret);
            QCOMPARE(std::string(secret->text()), std::string(line));
            QCOMPARE(secret->size(), std::string(line).size());
        }
    }

    void whatIsNone_isRefused_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("empty line") << QByteArray("\n");
        QTest::newRow("empty line of Windows") << QByteArray("\r\n");
        QTest::newRow("too long") << QByteArray(1025, 'x');
        QTest::newRow("too long a line") << QByteArray(1025, 'x') + "\n";
        QTest::newRow("much too long") << QByteArray(1000000, 'x');
        QTest::newRow("zero") << QByteArray("a\0b\n", 4);
        QTest::newRow("zeros") << QByteArray(1024, '\0');
    }
    void whatIsNone_isRefused()
    {
        QFETCH(QByteArray, bytes);
        m_keys.write("none", bytes.toStdString());
        const auto secret = secretIn("none");
        QVERIFY(!secret);
        QCOMPARE(secret.error().kind, ErrorKind::Usage);
        const std::string said = english(secret.error().message);
        QVERIFY2(said.find("1 to 1024 bytes") != std::string::npos, said.c_str());
        QCOMPARE(said.find("a byte that is zero") != std::string::npos, bytes.contains('\0'));
        QVERIFY(said.find("xx") == std::string::npos && said.size() < 300);
    }
};

DYNCAL_TEST(TestSecretBytes)
#include "tst_secret_bytes.moc"
