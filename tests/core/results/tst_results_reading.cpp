// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_reading.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using ReadJson = nlohmann::json;

namespace {

std::string whyNotRead(const std::string &text)
{
    const auto read = parseResults(text, "out/results.json");
    return read ? std::string() : english(read.error().message);
}

bool refuses(const std::string &text, const char *words)
{
    return whyNotRead(text).find(words) != std::string::npos;
}

} // namespace

class TestResultsReading : public QObject
{
    Q_OBJECT

private slots:
    void values_thatAreNotThere_areNoNumbers()
    {
        const ReadJson json{{"text", "word"}, {"number", 3}, {"list", {1.5, nullptr, "x"}}};
        QCOMPARE(textAt(json, "text"), std::string("word"));
        QCOMPARE(textAt(json, "number"), std::string());
        QCOMPARE(numberAt(json, "number"), 3.0);
        QVERIFY(std::isnan(numberAt(json, "text")));
        QVERIFY(std::isnan(numberAt(ReadJson(7), "text")));
        QVERIFY(valueAt(json, "nothing").is_null());
        QVERIFY(valueAt(ReadJson::array(), "0").is_null());
        const Eigen::VectorXd list = numbersAt(json, "list");
        QCOMPARE(list.size(), Index(3));
        QVERIFY(list[0] == 1.5 && std::isnan(list[1]) && std::isnan(list[2]));
        QCOMPARE(numbersAt(json, "number").size(), Index(0));
    }

    void ownSchema_isRead()
    {
        const auto read = parseResults(R"({"schema": "dyncal-results/1", "shots": []})", "r");
        QVERIFY(read.has_value());
        QVERIFY(read->contains("shots"));
    }

    void otherSchema_isNamed()
    {
        QVERIFY(refuses(R"({"schema": "dyncal-recipe/1"})", "its schema is \"dyncal-recipe/1\""));
        QVERIFY(refuses("{}", "is no results.json of a calibration"));
        QVERIFY(refuses("[]", "is no results.json of a calibration"));
    }

    void laterSchema_isSaidToBeThat()
    {
        QVERIFY(refuses(R"({"schema": "dyncal-results/2"})", "written by a later version"));
        QVERIFY(refuses(R"({"schema": "dyncal-results/10"})", "\"dyncal-results/10\""));
    }

    void damagedText_namesItsPlace()
    {
        QVERIFY(refuses("{\n\"schema\": ", "line 2"));
        QVERIFY(refuses("", "out/results.json is not valid JSON"));
        QVERIFY(refuses(R"({"schema": "dyncal-results/1", "schema": "x"})", "twice"));
    }
};

DYNCAL_TEST(TestResultsReading)
#include "tst_results_reading.moc"
