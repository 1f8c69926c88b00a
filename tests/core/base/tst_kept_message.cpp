// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/kept_message.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using Json = nlohmann::json;

class TestKeptMessage : public QObject
{
    Q_OBJECT

private slots:
    void keptAndReadBack_isTheSameMessage()
    {
        const Message message{
            "%1: %M1", {"CAP-018"}, {{"%1 is odd.", {"a \"b\"\n.h5"}}, {"And more.", {}}}};
        const KeptMessage kept
            = messageOfJson(Json::parse(messageJson(keptMessage(message)).dump()));
        QVERIFY(kept.message() == message);
        QCOMPARE(english(kept.message()), english(message));
    }

    void none_isNull()
    {
        QVERIFY(messageJson({}).is_null());
        QVERIFY(messageOfJson({}) == KeptMessage());
        QCOMPARE(english(KeptMessage().message()), std::string());
    }

    void noMessage_isRefused()
    {
        std::string deep = R"({"text": "a"})";
        for (int i = 0; i < 5000; ++i)
            deep = R"({"text": "a", "below": [)" + deep + "]}";
        for (const std::string &text : {std::string("3"), std::string("[]"), std::string("{}"),
                 std::string(R"({"text": 3})"), std::string(R"({"text": "a", "arguments": "b"})"),
                 std::string(R"({"text": "a", "below": [3]})"), deep}) {
            try {
                messageOfJson(Json::parse(text));
                QFAIL(text.substr(0, 60).c_str());
            } catch (const Json::exception &) {
            }
        }
    }
};

DYNCAL_TEST(TestKeptMessage)
#include "tst_kept_message.moc"
