// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/stages/frame/calendar_button.h"

#include <QCalendarWidget>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

using namespace dyncal;

namespace {

/// A field with its calendar, and what it told.
struct Bench
{
    QWidget window;
    QLineEdit *field = new QLineEdit;
    CalendarButton *button = new CalendarButton(*field);
    QSignalSpy finished{field, &QLineEdit::editingFinished};

    explicit Bench(const QString &text)
    {
        auto *row = new QHBoxLayout(&window);
        row->addWidget(field);
        row->addWidget(button);
        field->setText(text);
        window.show();
    }

    QCalendarWidget *open()
    {
        button->click();
        return window.findChild<QCalendarWidget *>();
    }
    void press(const char *name) { window.findChild<QPushButton *>(name)->click(); }
    bool isClosed()
    {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return !window.findChild<QCalendarWidget *>();
    }
};

} // namespace

class TestCalendarButton : public QObject
{
    Q_OBJECT

private slots:
    void opens_atTheDateOfTheField_elseToday()
    {
        QCOMPARE(Bench("2024-02-29").open()->selectedDate(), QDate(2024, 2, 29));
        for (const char *none : {"", "banana", "31/12", "2023-02-29"}) {
            const QDate before = QDate::currentDate();
            const QDate shown = Bench(none).open()->selectedDate();
            QVERIFY2(shown >= before && shown <= QDate::currentDate(), none);
        }
    }
    void dayClicked_isInTheField_once()
    {
        Bench bench("");
        emit bench.open()->clicked(QDate(2026, 1, 31));
        QCOMPARE(bench.field->text(), QString("2026-01-31"));
        QCOMPARE(bench.finished.size(), 1);
        QVERIFY(bench.isClosed());
    }
    void keys_moveAndChoose()
    {
        Bench bench("2026-02-27");
        QCalendarWidget *calendar = bench.open();
        QWidget *view = calendar->findChild<QWidget *>("qt_calendar_calendarview");
        QVERIFY(view);
        QTest::keyClick(view, Qt::Key_Right);
        QTest::keyClick(view, Qt::Key_Return);
        QCOMPARE(bench.field->text(), QString("2026-02-28"));
        QVERIFY(bench.isClosed());
    }
    void escape_changesNothing()
    {
        Bench bench("banana");
        QTest::keyClick(bench.open()->parentWidget(), Qt::Key_Escape);
        QCOMPARE(bench.field->text(), QString("banana"));
        QCOMPARE(bench.finished.size(), 0);
    }
    void none_emptiesTheField_andTodayIsToday()
    {
        Bench bench("2026-01-31");
        bench.open();
        bench.press("calendarNone");
        QCOMPARE(bench.field->text(), QString());
        QCOMPARE(bench.finished.size(), 1);
        QVERIFY(bench.isClosed());
        const QDate before = QDate::currentDate();
        bench.open();
        bench.press("calendarToday");
        const QDate chosen = QDate::fromString(bench.field->text(), Qt::ISODate);
        QVERIFY(chosen >= before && chosen <= QDate::currentDate());
    }
    /// Whatever the language, the recipe gets ISO 8601 with Latin digits.
    void text_isIso_inEveryLanguage()
    {
        const QLocale before;
        for (const auto &locale : {QLocale("sv_SE"), QLocale("de_DE"), QLocale("ar_EG")}) {
            QLocale::setDefault(locale);
            Bench bench("");
            emit bench.open()->activated(QDate(2026, 11, 5));
            QCOMPARE(bench.field->text(), QString("2026-11-05"));
        }
        QLocale::setDefault(before);
    }
};

DYNCAL_TEST(TestCalendarButton)
#include "tst_calendar_button.moc"
