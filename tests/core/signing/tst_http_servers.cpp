// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/http_post.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <array>
#include <atomic>
#include <functional>
#include <thread>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

using namespace dyncal;
using namespace std::chrono_literals;

namespace {

/// Takes connections, one after the other, and lets a test do with them what it likes.
class RudeServer
{
public:
    explicit RudeServer(std::function<void(int connection)> treat, int family = AF_INET)
        : m_treat(std::move(treat))
        , m_family(family)
        , m_socket(::socket(family, SOCK_STREAM | SOCK_CLOEXEC, 0))
    {
        sockaddr_in6 six{};
        six.sin6_family = AF_INET6;
        six.sin6_addr = in6addr_loopback;
        sockaddr_in four{};
        four.sin_family = AF_INET;
        four.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        auto *address = family == AF_INET ? reinterpret_cast<sockaddr *>(&four)
                                          : reinterpret_cast<sockaddr *>(&six);
        socklen_t size = family == AF_INET ? sizeof four : sizeof six;
        isListening = ::bind(m_socket, address, size) == 0 && ::listen(m_socket, 8) == 0
            && ::getsockname(m_socket, address, &size) == 0;
        m_port = ntohs(family == AF_INET ? four.sin_port : six.sin6_port);
        m_thread = std::jthread([this](const std::stop_token &stop) {
            while (!stop.stop_requested()) {
                const int connection = ::accept(m_socket, nullptr, nullptr);
                if (connection < 0)
                    continue;
                ++connections;
                m_treat(connection);
                ::close(connection);
            }
        });
    }
    RudeServer(const RudeServer &) = delete;
    RudeServer &operator=(const RudeServer &) = delete;
    ~RudeServer()
    {
        m_thread.request_stop();
        ::shutdown(m_socket, SHUT_RDWR);
        m_thread.join();
        ::close(m_socket);
    }

    bool isListening = false;
    std::atomic<int> connections = 0;

    std::string url() const
    {
        return (m_family == AF_INET ? "http://127.0.0.1:" : "http://[::1]:")
            + std::to_string(m_port) + "/tsa";
    }

private:
    std::function<void(int)> m_treat;
    int m_family;
    int m_socket;
    int m_port = 0;
    std::jthread m_thread;
};

void say(int connection, const std::string &bytes)
{
    static_cast<void>(::send(connection, bytes.data(), bytes.size(), MSG_NOSIGNAL));
}

/// The request as far as it came in one piece.
std::string hear(int connection)
{
    std::array<char, 4096> block{};
    const ssize_t got = ::read(connection, block.data(), block.size());
    return {block.data(), got > 0 ? static_cast<std::size_t>(got) : 0};
}

const std::string kGood = "HTTP/1.1 200 OK\r\n";

} // namespace

/// The client against servers that are slow, rude, wrong or of another kind.
class TestHttpServers : public QObject
{
    Q_OBJECT

private:
    static Result<std::string> posted(
        const std::string &url, const AnswerLimits &limits = {.time = 10s})
    {
        return postedTo(url, "text/plain", "request", {}, limits);
    }
    static std::string bodyOf(const std::string &answer)
    {
        const RudeServer server([&](int connection) {
            hear(connection);
            say(connection, answer);
        });
        return posted(server.url()).value_or("(refused)");
    }

private slots:
    void wholeAnswers_areTaken()
    {
        QCOMPARE(bodyOf(kGood + "\r\nbody"), std::string("body"));
        QCOMPARE(bodyOf(kGood + "Content-Length: 4\r\n\r\nbody"), std::string("body"));
        QCOMPARE(bodyOf(kGood + "content-length:4 \r\nX: y\r\n\r\nbody"), std::string("body"));
        QCOMPARE(bodyOf(kGood + "X: y\r\n\r\na\r\n\r\nb"), std::string("a\r\n\r\nb"));
        QCOMPARE(bodyOf(kGood + "\r\n" + std::string(60000, 'x')), std::string(60000, 'x'));
    }

    /// An answer that is not whole, or is in pieces (which HTTP/1.0 does not have), is none.
    void partsOfAnswers_areRefused()
    {
        const std::string none = "(refused)";
        QCOMPARE(bodyOf(kGood + "Content-Length: 5\r\n\r\nbody"), none);
        QCOMPARE(bodyOf(kGood + "CONTENT-LENGTH: 70000\r\n\r\nbody"), none);
        QCOMPARE(bodyOf(kGood + "Content-Length: 3\r\n\r\nbody"), none);
        QCOMPARE(bodyOf(kGood + "Content-Length: four\r\n\r\nbody"), none);
        QCOMPARE(bodyOf(kGood + "Transfer-Encoding: chunked\r\n\r\n4\r\nbody\r\n0\r\n\r\n"), none);
        QCOMPARE(bodyOf(kGood + "transfer-encoding: gzip\r\n\r\nbody"), none);
        QCOMPARE(bodyOf("HTTP/1.1 100 Continue\r\n\r\n" + kGood + "\r\nbody"), none);
        QCOMPARE(bodyOf("HTTP/1.1 204 No Content\r\n\r\nbody"), none);
        QCOMPARE(bodyOf("HTTP/1.1 2000 OK\r\n\r\nbody"), none);
        QCOMPARE(bodyOf("HTTP/2 200\r\n\r\nbody"), none);
        QCOMPARE(bodyOf("ICY 200 OK\r\n\r\nbody"), none);
        QCOMPARE(bodyOf(kGood + "X: 200\r\nbody"), none);
        QCOMPARE(bodyOf(kGood + "\r\n" + std::string(65536, 'x')), none); // head and body together
    }

    void redirections_areNotFollowed()
    {
        const RudeServer other([](int connection) { say(connection, kGood + "\r\nother"); });
        for (const char *status : {"301 Moved", "302 Found", "303 See Other", "307 Temporary",
                 "308 Permanent", "300 Choices"}) {
            const RudeServer server([&](int connection) {
                hear(connection);
                say(connection,
                    "HTTP/1.1 " + std::string(status) + "\r\nLocation: " + other.url()
                        + "\r\n\r\nbody");
            });
            QVERIFY2(!posted(server.url()), status);
            QCOMPARE(server.connections.load(), 1);
        }
        QCOMPARE(other.connections.load(), 0);
    }

    void serversThatClose_areRefusedAtOnce_data()
    {
        QTest::addColumn<int>("how");
        QTest::newRow("at once") << 0;
        QTest::newRow("after the request") << 1;
        QTest::newRow("by a reset") << 2;
        QTest::newRow("within the head") << 3;
    }
    void serversThatClose_areRefusedAtOnce()
    {
        QFETCH(int, how);
        const RudeServer server([&](int connection) {
            const linger hard{1, 0};
            if (how != 0)
                hear(connection);
            if (how == 2)
                ::setsockopt(connection, SOL_SOCKET, SO_LINGER, &hard, sizeof hard);
            if (how == 3)
                say(connection, "HTTP/1.1 200 OK\r\nContent-");
        });
        QElapsedTimer timer;
        timer.start();
        // Large, so that the client is still sending when the other end is gone.
        const auto answer = postedTo(
            server.url(), "text/plain", std::string(how == 0 ? 20000000 : 10, 'x'), {}, {});
        QVERIFY(!answer);
        QCOMPARE(answer.error().kind, ErrorKind::FileUnreadable);
        QVERIFY(timer.elapsed() < 5000);
    }

    void slowServers_haveAllOfTheTimeAndNoMore()
    {
        const auto dripping = [](int drops) {
            return [drops](int connection) {
                hear(connection);
                const std::string answer = kGood + "Content-Length: 5\r\n\r\n12345";
                for (int i = 0; i < drops && i < static_cast<int>(answer.size()); ++i) {
                    say(connection, answer.substr(static_cast<std::size_t>(i), 1));
                    std::this_thread::sleep_for(20ms);
                }
                if (drops < static_cast<int>(answer.size()))
                    std::this_thread::sleep_for(1s);
            };
        };
        const RudeServer patient(dripping(1000)), silent(dripping(10));
        QCOMPARE(posted(patient.url()).value_or(""), std::string("12345"));
        for (const RudeServer *server : {&patient, &silent}) {
            QElapsedTimer timer;
            timer.start();
            const auto answer = posted(server->url(), {.time = 300ms});
            QVERIFY(!answer && answer.error().kind == ErrorKind::FileUnreadable);
            QVERIFY(timer.elapsed() >= 250 && timer.elapsed() < 2000);
        }
    }

    void serverThatDoesNotRead_isLeft()
    {
        const RudeServer deaf([](int) { std::this_thread::sleep_for(1s); });
        QElapsedTimer timer;
        timer.start();
        const auto answer
            = postedTo(deaf.url(), "text/plain", std::string(50000000, 'x'), {}, {.time = 300ms});
        QVERIFY(!answer && answer.error().kind == ErrorKind::FileUnreadable);
        QVERIFY(timer.elapsed() < 2000);
    }

    void flood_isCutOff()
    {
        const RudeServer flood([](int connection) {
            hear(connection);
            const std::string block(1U << 16U, 'x');
            say(connection, kGood + "\r\n");
            while (::send(connection, block.data(), block.size(), MSG_NOSIGNAL) > 0) { }
        });
        QElapsedTimer timer;
        timer.start();
        QVERIFY(!posted(flood.url(), {.time = 60s}));
        QVERIFY(timer.elapsed() < 5000);
    }

    void versionSix_hasItsBrackets()
    {
        std::string head;
        const RudeServer server(
            [&](int connection) {
                head = hear(connection);
                say(connection, kGood + "\r\nsix");
            },
            AF_INET6);
        if (!server.isListening)
            QSKIP("there is no IPv6 here");
        const std::string url = server.url();
        QCOMPARE(posted(url).value_or("(refused)"), std::string("six"));
        const std::string host = url.substr(7, url.rfind('/') - 7); // RFC 3986, 3.2.2
        QVERIFY2(head.find("\r\nHost: " + host + "\r\n") != std::string::npos, head.c_str());
    }

    void refusals_nameTheAddressOnly()
    {
        const RudeServer server([](int connection) {
            hear(connection);
            say(connection, "HTTP/1.1 500 <script>secret</script>\r\n\r\nsecret");
        });
        const auto answer = posted(server.url());
        QVERIFY(!answer);
        const std::string said = english(answer.error().message);
        QVERIFY2(said.find(server.url()) != std::string::npos, said.c_str());
        QVERIFY(said.find("secret") == std::string::npos);
    }
};

DYNCAL_TEST(TestHttpServers)
#include "tst_http_servers.moc"
