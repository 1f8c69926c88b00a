// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/template_logo.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

/// The head of a PNG as the standard has it; what follows is not looked at here.
std::string pngHead(unsigned width, unsigned height)
{
    const auto whole = [](unsigned value) {
        std::string bytes;
        for (int shift = 24; shift >= 0; shift -= 8)
            bytes += static_cast<char>(value >> static_cast<unsigned>(shift));
        return bytes;
    };
    return std::string("\x89PNG\r\n\x1a\n", 8) + whole(13) + "IHDR" + whole(width) + whole(height);
}

constexpr const char *kSvg
    = R"svg(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10"><path d="M0 0h9" fill="url(#g)"/>%1</svg>)svg";

std::string svgWith(const char *part)
{
    return QString(kSvg).arg(part).toStdString();
}

} // namespace

/// Which pictures a template may bring.
class TestTemplateLogo : public QObject
{
    Q_OBJECT

private slots:
    void png_upToItsSize_isTaken()
    {
        QVERIFY(checkLogo("a.png", pngHead(1, 1)));
        QVERIFY(checkLogo("a.png", pngHead(4000, 4000)));
        QVERIFY(!checkLogo("a.png", pngHead(4001, 1)));
        QVERIFY(!checkLogo("a.png", pngHead(1, 0xFFFFFFFF)));
        QVERIFY(!checkLogo("a.png", pngHead(0, 10)));
    }
    void png_thatIsNone_isRefusedByName()
    {
        for (std::size_t length = 0; length < 24; ++length)
            QVERIFY(!checkLogo("a.png", pngHead(9, 9).substr(0, length)));
        const Result<void> checked = checkLogo("lab.png", svgWith(""));
        QVERIFY(!checked);
        QCOMPARE(english(checked.error().message),
            std::string(
                "The logo lab.png is no PNG image of at most 4000 x 4000 pixels; make it smaller, or use an SVG."));
    }
    void svg_thatStandsByItself_isTaken()
    {
        QVERIFY(checkLogo("a.svg", svgWith("")));
        QVERIFY(checkLogo("a.svg", svgWith("<g style='fill:url(#g)'/>")));
    }
    void svg_thatReachesOut_isRefused()
    {
        for (const char *part : {"<image xlink:href='/etc/passwd'/>", "<use HREF='#a'/>",
                 "<script>x</script>", "<style>@import 'a';</style>", "<g fill='url(http://a/b)'/>",
                 "<g fill=\"URL('/a')\"/>", "<?xml-stylesheet a?>"})
            QVERIFY2(!checkLogo("a.svg", svgWith(part)), part);
        QVERIFY(!checkLogo("a.svg", "<!DOCTYPE svg [<!ENTITY a 'b'>]>" + svgWith("&amp;")));
        QVERIFY(!checkLogo("a.svg", "plain text"));
        QVERIFY(!checkLogo("a.svg", svgWith("") + std::string(1, '\0')));
        QVERIFY(!checkLogo("a.svg", pngHead(9, 9)));
    }
};

DYNCAL_TEST(TestTemplateLogo)
#include "tst_template_logo.moc"
