// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/calendar_date.h"
#include "tests/support/test_program.h"

#include <QDate>
#include <QTest>

using namespace dyncal;

/// Moments as days; what a day of the calendar is has core_required_fields.
class TestCalendarDate : public QObject
{
    Q_OBJECT

private slots:
    void knownMoments_areKnownDays()
    {
        QCOMPARE(*daysSince1970("1970-01-01T00:00:00Z"), 0.0);
        QCOMPARE(*daysSince1970("1970-01-02T06:00:00Z"), 1.25);
        QCOMPARE(*daysSince1970("2000-03-01T00:00:00Z"), 11017.0);
        QCOMPARE(*daysSince1970("2026-01-01T00:00:00Z") * 86400.0, 1767225600.0);
        QCOMPARE(*daysSince1970("1969-12-31T12:00:00Z"), -0.5);
    }

    void moment_hasItsDay()
    {
        QCOMPARE(dayOfMoment("2026-01-31T04:23:11Z"), std::string("2026-01-31"));
        QCOMPARE(dayOfMoment("2026-01-31"), std::string("2026-01-31"));
        QCOMPARE(dayOfMoment(""), std::string());
    }

    void dayAlone_isItsNoon()
    {
        QCOMPARE(*daysSince1970("1970-01-01"), 0.5);
        QCOMPARE(*daysSince1970("2024-02-29"), *daysSince1970("2024-02-29T12:00:00Z"));
    }

    /// An independent calendar.
    void everyDay_isThatOfQt()
    {
        const QDate first(1970, 1, 1);
        for (QDate day(1999, 12, 25); day < QDate(2005, 1, 5); day = day.addDays(1)) {
            const std::string text = day.toString(Qt::ISODate).toStdString() + "T18:00:00Z";
            QCOMPARE(*daysSince1970(text), static_cast<double>(first.daysTo(day)) + 0.75);
        }
    }

    void odd_isNone()
    {
        for (const char *text :
            {"", "2026", "2026-02-30", "2026-13-01", " 2026-01-01", "2026-01-01 ",
                "2026-01-01T00:00:00", "2026-01-01 00:00:00Z", "2026-01-01T24:00:00Z",
                "2026-01-01T00:60:00Z", "2026-01-01T00:00:60Z", "2026-02-30T00:00:00Z",
                "2026-01-01T00:00:00+01:00", "2026-01-01T0x:00:00Z", "today"})
            QVERIFY2(!daysSince1970(text), text);
    }
};

DYNCAL_TEST(TestCalendarDate)
#include "tst_calendar_date.moc"
