// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/shell/banner/banner.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QtTest>

using namespace dyncal;

namespace {

const QString kLong = QStringLiteral(
    "The recording /data/calibrations/2026/spring/shot_2.h5 is no longer as it was when it was "
    "opened; what is shown was computed from what was read before. 2 more files likewise.");

/// The central widget of a window, with a banner above its page.
struct Window : QWidget
{
    explicit Window(int width)
    {
        auto *column = new QVBoxLayout(this);
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(0);
        column->addWidget(banner);
        column->addWidget(page, 1);
        resize(width, 600);
        show();
    }
    Banner *banner = new Banner("source", this);
    QWidget *page = new QWidget(this);
};

/// Where everything of the window stands.
QString places(const Window &window)
{
    QStringList said;
    for (const QWidget *widget : window.findChildren<QWidget *>())
        if (widget->isVisible()) {
            const QRect at(widget->mapTo(&window, QPoint()), widget->size());
            said << QString("%1 %2,%3 %4x%5")
                        .arg(widget->objectName())
                        .arg(at.x())
                        .arg(at.y())
                        .arg(at.width())
                        .arg(at.height());
        }
    return said.join('\n');
}

} // namespace

class TestBanner : public QObject
{
    Q_OBJECT

private slots:
    void presented_standsAtOnceWhereItStays_data();
    void presented_standsAtOnceWhereItStays();
    void longerSentence_growsAtOnce();
};

void TestBanner::presented_standsAtOnceWhereItStays_data()
{
    QTest::addColumn<int>("width");
    for (const int width : {700, 1000, 1366, 1900})
        QTest::addRow("%d px", width) << width;
}

void TestBanner::presented_standsAtOnceWhereItStays()
{
    QFETCH(int, width);
    Window window(width);
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.banner->present(kLong, {BannerAction::ReadAgain, BannerAction::Locate});
    const QString first = places(window);
    const auto *sentence = window.banner->findChild<QLabel *>("sourceSentence");
    QCOMPARE(window.banner->width(), width);
    QVERIFY2(sentence->height() >= sentence->heightForWidth(sentence->width()), qPrintable(first));
    for (const char *name : {"readAgain", "locateRecordings"}) {
        const auto *button = window.banner->findChild<QPushButton *>(name);
        QVERIFY2(window.banner->rect().contains(button->geometry()), qPrintable(first));
        QVERIFY2(!sentence->geometry().intersects(button->geometry()), qPrintable(first));
    }
    QCOMPARE(window.page->y(), window.banner->height());
    QTest::qWait(50);
    QCOMPARE(places(window), first); // nothing jumps under the hand
}

void TestBanner::longerSentence_growsAtOnce()
{
    Window window(1000);
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.banner->present("Short.", {BannerAction::Close});
    QTest::qWait(50);
    window.banner->present(kLong + ' ' + kLong, {BannerAction::ReadAgain, BannerAction::Locate});
    const QString first = places(window);
    QTest::qWait(50);
    QCOMPARE(places(window), first);
}

DYNCAL_TEST(TestBanner)
#include "tst_banner.moc"
