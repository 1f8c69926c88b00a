// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/stages/certificate/page_images.h"
#include "ui/stages/certificate/page_stack.h"

#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>
#include <QtTest>

using namespace dyncal;

namespace {

/// Two pages of A4: the upper half of the first is black, the left half of the second blue.
std::string madePdf()
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins({});
    QPainter painter(&writer);
    const QRect page(0, 0, writer.width(), writer.height());
    painter.fillRect(QRect(page.topLeft(), QSize(page.width(), page.height() / 2)), Qt::black);
    writer.newPage();
    painter.fillRect(QRect(page.topLeft(), QSize(page.width() / 2, page.height())), Qt::blue);
    painter.end();
    return buffer.data().toStdString();
}

QColor at(const QImage &page, double x, double y)
{
    return page.pixelColor(static_cast<int>(x * page.width()), static_cast<int>(y * page.height()));
}

} // namespace

/// The pages of a document as pictures, and how they stand below one another.
class TestPageImages : public QObject
{
    Q_OBJECT

private slots:
    void pages_areAsTheyWereDrawn();
    void width_isTheOneAskedFor();
    void whatIsNoDocument_isRefused();
    void stop_isHeardBetweenPages();
    void stack_isAsHighAsItsPages_andKnowsThem();
    void stack_withoutPages();
};

void TestPageImages::pages_areAsTheyWereDrawn()
{
    const auto pages = pageImages(madePdf(), 400);
    QVERIFY(pages);
    QCOMPARE(pages->size(), std::size_t(2));
    QCOMPARE(at((*pages)[0], 0.5, 0.25), QColor(Qt::black));
    QCOMPARE(at((*pages)[0], 0.5, 0.75), QColor(Qt::white));
    QCOMPARE(at((*pages)[1], 0.25, 0.75), QColor(Qt::blue));
    QCOMPARE(at((*pages)[1], 0.75, 0.25), QColor(Qt::white));
}

void TestPageImages::width_isTheOneAskedFor()
{
    for (const int width : {1, 37, 400, 1600}) {
        const auto pages = pageImages(madePdf(), width);
        QVERIFY(pages);
        QVERIFY(std::abs(pages->front().width() - width) <= 1); // the renderer rounds up
        QVERIFY(std::abs(pages->front().height() - width * 297.0 / 210.0) <= 2.0);
    }
}

void TestPageImages::whatIsNoDocument_isRefused()
{
    const std::string whole = madePdf();
    for (const std::string &bytes :
        {std::string(), std::string("%PDF-1.4\n"), std::string("text"), whole.substr(0, 200)}) {
        const auto pages = pageImages(bytes, 400);
        QVERIFY(!pages);
        QVERIFY(pages.error().kind == ErrorKind::FileUnreadable);
    }
    QVERIFY(!pageImages(whole, 0));
    QVERIFY(!pageImages(whole, -5));
}

void TestPageImages::stop_isHeardBetweenPages()
{
    std::stop_source stop;
    stop.request_stop();
    const auto pages = pageImages(madePdf(), 400, {stop.get_token(), {}});
    QVERIFY(!pages);
    QVERIFY(pages.error().kind == ErrorKind::Cancelled);
}

void TestPageImages::stack_isAsHighAsItsPages_andKnowsThem()
{
    PageStack stack;
    QImage tall(100, 150, QImage::Format_RGB32);
    tall.fill(Qt::red);
    QImage wide(200, 100, QImage::Format_RGB32);
    wide.fill(Qt::green);
    stack.setPages({tall, wide});
    const int gaps = stack.heightOfPages(100) - 150 - 50;
    QVERIFY(gaps > 0);
    QCOMPARE(stack.heightOfPages(200), 300 + 100 + gaps);
    stack.resize(100, stack.heightOfPages(100));
    QCOMPARE(stack.pageAt(10), 0);
    QCOMPARE(stack.pageAt(150 + gaps / 2 + 10), 1);
    QCOMPARE(stack.pageAt(100000), 1);
    QImage shown(stack.size(), QImage::Format_RGB32);
    stack.render(&shown);
    QCOMPARE(shown.pixelColor(50, 75), QColor(Qt::red));
    QCOMPARE(shown.pixelColor(50, 150 + gaps / 2 + 25), QColor(Qt::green));
    stack.setPale(true);
    stack.render(&shown);
    QVERIFY(shown.pixelColor(50, 75).green() > 100); // on white paper
}

void TestPageImages::stack_withoutPages()
{
    PageStack stack;
    QCOMPARE(stack.pageAt(0), -1);
    QCOMPARE(stack.heightOfPages(500), 0);
    stack.setPages({QImage()}); // a picture of nothing takes no room
    QVERIFY(stack.heightOfPages(500) < 20);
}

DYNCAL_TEST(TestPageImages)
#include "tst_page_images.moc"
