// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/http_post.h"
#include "tests/support/answering_server.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

/// The client that asks a time-stamping authority, against servers on 127.0.0.1.
class TestHttpPost : public QObject
{
    Q_OBJECT

private:
    static Result<std::string> posted(const std::string &url, const AnswerLimits &limits = {})
    {
        return postedTo(url, "text/plain", std::string("a\0b", 3), {}, limits);
    }
    static ErrorKind failure(const Result<std::string> &result)
    {
        return result ? ErrorKind::Internal : result.error().kind;
    }

private slots:
    void bytes_goOutAndComeBack()
    {
        std::string seen;
        const AnsweringServer server([&](const std::string &head, const std::string &body) {
            seen = head;
            return httpAnswer("got:" + body);
        });
        const auto answer = posted(server.url("/a/b?c=d#e"));
        QVERIFY2(answer, answer ? "" : english(answer.error().message).c_str());
        QCOMPARE(*answer, std::string("got:a\0b", 7));
        QVERIFY2(seen.starts_with("POST /a/b?c=d HTTP/1.0\r\nHost: 127.0.0.1:"), seen.c_str());
        QVERIFY(
            seen.find("Content-Type: text/plain\r\nContent-Length: 3\r\n") != std::string::npos);
    }

    void largeBytes_goOutWhole()
    {
        const AnsweringServer server([](const std::string &, const std::string &body) {
            return httpAnswer(std::to_string(body.size()));
        });
        QCOMPARE(postedTo(server.url(), "a/b", std::string(5000000, 'x'), {}).value_or(""),
            std::string("5000000"));
    }

    void otherAnswers_areRefused_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("words");
        const auto row = [](const char *name, const QByteArray &bytes, const char *words) {
            QTest::newRow(name) << bytes << words;
        };
        row("not found", "HTTP/1.0 404 Not Found\r\n\r\n200", "(HTTP 404)");
        row("moved", "HTTP/1.0 301 Moved\r\nLocation: http://x/\r\n\r\nx", "(HTTP 301)");
        row("no body", "HTTP/1.0 200 OK\r\n\r\n", "(HTTP 200), but not with a whole");
        row("no head", "text", "answered (-)");
        row("nothing", "", "answered (-)");
        row("controls", "HTTP/1.0 500 \x1B[2J\r\n\r\n", "(HTTP 500)");
        row("too much", "HTTP/1.0 200 OK\r\n\r\n" + QByteArray(70000, 'x'),
            "more than 65536 bytes");
    }
    void otherAnswers_areRefused()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, words);
        const AnsweringServer server(
            [&](const std::string &, const std::string &) { return bytes.toStdString(); });
        const auto answer = posted(server.url());
        QCOMPARE(failure(answer), ErrorKind::FileUnreadable);
        const QString said = QString::fromStdString(english(answer.error().message));
        QVERIFY2(said.contains(words) && said.startsWith(server.url().c_str()), qPrintable(said));
    }

    void silence_ends()
    {
        using namespace std::chrono_literals;
        const AnsweringServer server(
            [](const std::string &, const std::string &) { return std::string("HTTP/1.0 200"); },
            3s);
        QElapsedTimer timer;
        timer.start();
        const auto late = posted(server.url(), {.time = 300ms});
        QCOMPARE(failure(late), ErrorKind::FileUnreadable);
        QVERIFY(english(late.error().message).find("within 0.3 s") != std::string::npos);
        QVERIFY(timer.elapsed() < 2000);
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(
            failure(postedTo(server.url(), "a/b", "x", stop.get_token())), ErrorKind::Cancelled);
    }

    void nobody_isSaid()
    {
        std::string url;
        {
            const AnsweringServer gone([](const std::string &, const std::string &) { return ""; });
            url = gone.url();
        }
        const auto answer = posted(url);
        QCOMPARE(failure(answer), ErrorKind::FileUnreadable);
        QVERIFY(english(answer.error().message).find("cannot be reached") != std::string::npos);
        QCOMPARE(failure(posted("http://nothing.invalid/")), ErrorKind::FileUnreadable);
    }

    void otherAddresses_areRefused_data()
    {
        QTest::addColumn<QString>("url");
        for (const char *url : {"https://a/b", "a", "", "http://", "http:///x", "http://a:/x",
                 "http://a:99x/", "http://a:999999/", "http://user@a/", "http://a/ b",
                 "http://a/\r\nX: y", "ftp://a/", "file:///etc/passwd"})
            QTest::newRow(url) << url;
    }
    void otherAddresses_areRefused()
    {
        QFETCH(QString, url);
        QCOMPARE(failure(posted(url.toStdString())), ErrorKind::Usage);
        QVERIFY(!checkHttpAddress(url.toStdString()));
        for (const char *good :
            {"http://a", "HTTP://a.b:80/c", "http://[::1]:8080/x", "http://[::1]/"})
            QVERIFY2(checkHttpAddress(good), good);
    }
};

DYNCAL_TEST(TestHttpPost)
#include "tst_http_post.moc"
