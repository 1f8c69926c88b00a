// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/history/history_section.h"
#include "tests/core/history/made_history.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

const CertificateTable *tableOf(const CertificateSection &section, const char *id)
{
    const auto found = std::ranges::find(section.tables, id, &CertificateTable::id);
    return found == section.tables.end() ? nullptr : &*found;
}

std::string rowText(const CertificateTable &table, std::size_t row)
{
    std::string text;
    for (const Message &cell : table.rows.at(row))
        text += (text.empty() ? "" : " | ") + english(cell);
    return text;
}

std::string notesOf(const CertificateSection &section)
{
    std::string text;
    for (const Message &note : section.notes)
        text += english(note) + '\n';
    return text;
}

bool hasFigure(const CertificateSection &section, const char *id)
{
    return std::ranges::find(section.figures, id, &CertificateFigure::id) != section.figures.end();
}

} // namespace

/// The history of a sensor as a section of its certificate.
class TestHistorySection : public QObject
{
    Q_OBJECT

private slots:
    void row_hasDayNumberValueAndItsU();
    void En_isAgainstTheLineBefore();
    void first_isOneLine_withoutFigureAndDrift();
    void chart_needsFive_andNamesWhatIsBeyond();
    void drift_isStatedWithItsU_andJudgedByIt();
    void notStated_isADash_andAQuantityOfNobodyHasNoTable();
    void everyRow_hasACellForEachColumn();
};

/// U = 2 u = 1e-7 V/Pa is 0.10 uV/Pa: the value ends where U ends.
void TestHistorySection::row_hasDayNumberValueAndItsU()
{
    const CertificateSection section = historySection(madeHistory({5e-6, 5.012e-6}));
    QCOMPARE(section.id, std::string("history"));
    const CertificateTable *table = tableOf(section, "history-sensitivity");
    QVERIFY(table);
    QCOMPARE(rowText(*table, 0), std::string("2020-01-01 | 11 | 5.00 µV/Pa | 0.10 µV/Pa | – | –"));
    QCOMPARE(
        rowText(*table, 1), std::string("2021-01-01 | 12 | 5.01 µV/Pa | 0.10 µV/Pa | 0.085 | –"));
}

/// (5.2 - 5.0)/sqrt(0.1^2 + 0.1^2) = sqrt(2).
void TestHistorySection::En_isAgainstTheLineBefore()
{
    const CertificateSection section = historySection(madeHistory({5e-6, 5.2e-6}));
    const CertificateTable *table = tableOf(section, "history-sensitivity");
    QCOMPARE(english(table->rows.at(1).at(4)), std::string("1.4"));
}

void TestHistorySection::first_isOneLine_withoutFigureAndDrift()
{
    const CertificateSection section = historySection(madeHistory({5e-6}));
    QCOMPARE(tableOf(section, "history-sensitivity")->rows.size(), std::size_t(1));
    QVERIFY(section.figures.empty());
    QCOMPARE(section.notes.size(), std::size_t(1));
}

void TestHistorySection::chart_needsFive_andNamesWhatIsBeyond()
{
    const auto chart = [](const std::vector<double> &values) {
        const CertificateSection section = historySection(madeHistory(values));
        return english(tableOf(section, "history-sensitivity")->rows.back().back());
    };
    QCOMPARE(chart({5e-6, 5.01e-6, 5e-6, 5.01e-6}), std::string("–"));
    QCOMPARE(chart({5e-6, 5.01e-6, 5e-6, 5.01e-6, 5e-6}), std::string("inside"));
    std::vector<double> jump(12, 5e-6);
    for (std::size_t i = 0; i < jump.size(); i += 2)
        jump[i] += 1e-8;
    jump.push_back(5.3e-6);
    QCOMPARE(chart(jump), std::string("beyond the action limits"));
}

void TestHistorySection::drift_isStatedWithItsU_andJudgedByIt()
{
    // 0.1 uV/Pa a year over four years, u = 5e-9 V/Pa: U(b) = 2 u/sqrt(10) = 3.16e-9 V/Pa
    const std::string rising
        = notesOf(historySection(madeHistory({5e-6, 5.1e-6, 5.2e-6, 5.3e-6, 5.4e-6}, 5e-9)));
    QVERIFY2(rising.find("Sensitivity: it drifts by 1.000 ×10^-7 V/Pa/a ± 0.032 ×10^-7 V/Pa/a")
            != rising.npos,
        rising.c_str());
    const std::string steady = notesOf(historySection(madeHistory({5e-6, 5.001e-6, 5e-6})));
    QVERIFY2(steady.find("Sensitivity: the drift of ") != steady.npos, steady.c_str());
    QVERIFY2(steady.find("is within its U") != steady.npos, steady.c_str());
}

void TestHistorySection::notStated_isADash_andAQuantityOfNobodyHasNoTable()
{
    SensorHistory history = madeHistory({5e-6, 5.1e-6});
    history.series[2].entries[0].stated.value = kUnknown;
    const CertificateSection some = historySection(history);
    QCOMPARE(rowText(*tableOf(some, "history-sensitivity"), 0),
        std::string("2020-01-01 | 11 | – | – | – | –"));
    history.series[2].entries[1].stated.value = kUnknown;
    QVERIFY(!tableOf(historySection(history), "history-sensitivity"));
    QVERIFY(tableOf(historySection(history), "history-f0_hz"));
}

void TestHistorySection::everyRow_hasACellForEachColumn()
{
    const CertificateSection section
        = historySection(madeHistory({5e-6, 5.1e-6, 5e-6, 5e-6, 5e-6}));
    QCOMPARE(section.tables.size(), std::size_t(3));
    for (const CertificateTable &table : section.tables) {
        QCOMPARE(table.rows.size(), std::size_t(5));
        QVERIFY(hasFigure(section, table.id.c_str()));
        for (const auto &row : table.rows)
            QCOMPARE(row.size(), table.columns.size());
    }
}

DYNCAL_TEST(TestHistorySection)
#include "tst_history_section.moc"
