// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "ui/shell/registry/history_rows.h"

#include <QJsonDocument>
#include <QtTest>

#include <cmath>

using namespace dyncal;

namespace {

/// Three calibrations; the second is 4 % higher, the third is blocked.
QJsonObject answer()
{
    return QJsonDocument::fromJson(R"({"points": [
        {"time": "2024-07-02", "certificate": 3, "methods_changed": null, "blocked": null, "remarks": []},
        {"time": "2025-07-02T08:00:00Z", "certificate": null, "methods_changed": "response 8 to 9",
         "blocked": null, "remarks": []},
        {"time": "2026-01-07", "certificate": null, "methods_changed": null, "blocked": "SHK-001", "remarks": []}],
      "series": [
        {"quantity": "sensitivity", "asked_hz": null, "frequency_hz": null, "unit": "V/Pa",
         "limits": null, "drift": null, "values": [
          {"value": 5e-6, "u": 5e-8, "k": 2.0, "u_expanded": 1e-7, "unit": "V/Pa", "e_n": null, "control_state": null},
          {"value": 5.2e-6, "u": 5e-8, "k": 2.0, "u_expanded": 1e-7, "unit": "V/Pa", "e_n": 1.41, "control_state": null},
          {"value": null, "u": null, "k": null, "u_expanded": null, "unit": null, "e_n": null, "control_state": null}]},
        {"quantity": "magnitude", "asked_hz": 1250.0, "frequency_hz": 1258.93, "unit": "V/Pa",
         "limits": {"mean": 5e-6, "sigma": 1e-7}, "drift": {"per_year": 1e-8, "u": 1e-9, "k": 12.7,
         "u_expanded": 1.27e-8, "calibrations": 3}, "values": [
          {"value": 5e-6, "u": null, "k": 2.0, "u_expanded": null, "unit": "V/Pa", "e_n": null, "control_state": "inside"},
          {"value": 6, "u": null, "k": 2.0, "u_expanded": null, "unit": "1", "e_n": null, "control_state": null},
          {"value": null, "u": null, "k": null, "u_expanded": null, "unit": null, "e_n": null, "control_state": null}]}],
      "left_out": [{"file": "a/results.json", "certificate": 1, "why": "not_in_force", "reason": "x"},
                   {"file": "b/results.json", "certificate": null, "why": "same_recordings", "reason": "x"}]})")
        .object();
}

} // namespace

/// The window's words and figures of a history, from an answer written down.
class TestHistoryRows : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void rows_sayWhatIsStated()
    {
        const auto rows = historyRows(answer(), 0);
        QCOMPARE(rows.size(), std::size_t(3));
        QCOMPARE(rows[0],
            (QVariantList{"2024-07-02", 3, "5.00 µV/Pa", "0.10 µV/Pa", "2", "–", "–", ""}));
        QCOMPARE(rows[1][0], QVariant("2025-07-02"));
        QVERIFY(!rows[1][1].isValid());
        QCOMPARE(rows[1][5], QVariant("1.4"));
        QVERIFY(rows[1][7].toString().contains("by more than U"));
        QVERIFY(rows[1][7].toString().contains("other versions"));
        QCOMPARE(rows[2][2], QVariant("–"));
        QVERIFY(rows[2][7].toString().contains("blocked"));
        QVERIFY(historyRows(answer(), 1)[0][7].toString().contains("without complete U"));
        QVERIFY(historyRows(answer(), 1)[0][6].toString().contains("inside"));
    }

    void figure_holdsTheSameNumbers()
    {
        const PlotContent content = historyContent(answer(), 0);
        QCOMPARE(content.curves.size(), std::size_t(4));
        QCOMPARE(content.curves[1].y, std::vector<double>{5e-6});
        QCOMPARE(content.curves[3].y, std::vector<double>{5.2e-6}); // |E_n| above 1
        QVERIFY(std::abs(content.curves[1].x[0] - 2024.5) < 2.0 / 366.0); // 2 July, a leap year
        // Another unit than the newest one's stays in the table.
        QCOMPARE(historyContent(answer(), 1).curves[1].y, std::vector<double>{5e-6});
        QCOMPARE(historyContent(answer(), 1).levels.size(), std::size_t(5));
    }

    void titles_nameTheRow()
    {
        QCOMPARE(seriesTitle(answer()["series"][0]), QString("Sensitivity"));
        QVERIFY2(seriesTitle(answer()["series"][1]).contains("1.259 kHz"),
            qPrintable(seriesTitle(answer()["series"][1])));
    }

    void summary_saysDriftLimitsAndWhatIsLeftOut()
    {
        const QString few = historySummary(answer(), 0);
        QVERIFY2(few.contains("from 3 calibrations") && few.contains("from 5 calibrations"),
            qPrintable(few));
        QVERIFY(few.contains("withdrawn or replaced: a/results.json"));
        QVERIFY(few.contains("same recordings counts: b/results.json"));
        const QString stated = historySummary(answer(), 1);
        QVERIFY2(stated.contains("nV/Pa") && stated.contains("3 calibrations"), qPrintable(stated));
        QVERIFY(!stated.contains("limits are drawn"));
    }

    void swedish_hasItsWords()
    {
        const test::InSwedish swedish;
        QVERIFY(historyRows(answer(), 0)[2][7].toString() != "blocked: it states nothing");
        QVERIFY(seriesTitle(answer()["series"][0]) != "Sensitivity");
    }

    /// Whatever a file says, nothing but text is shown and nothing breaks.
    void oddAnswers_breakNothing()
    {
        for (const char *json :
            {"{}", R"({"series": [{}], "points": [{}]})",
                R"({"series": [{"values": 3, "limits": 5, "drift": []}], "points": "no"})",
                R"({"series": [{"quantity": "f0_hz", "unit": "<b>\u202eHz", "values": [{"value": 1e400}]}],
                     "points": [{"time": "not a day", "remarks": 1}]})"}) {
            const QJsonObject odd = QJsonDocument::fromJson(json).object();
            historyRows(odd, 0);
            historyContent(odd, 0);
            historySummary(odd, 0);
            historyRows(odd, 7);
        }
    }
};

DYNCAL_TEST(TestHistoryRows)
#include "tst_history_rows.moc"
