// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A certificate of anybody is read: names, texts, paths, and what is refused.

#include "core/dcc/dcc_tree.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

std::string dcc(const std::string &body)
{
    return "<digitalCalibrationCertificate>" + body + "</digitalCalibrationCertificate>";
}

/// The text of the only `a` of the body.
QString textOfA(const std::string &body)
{
    const Result<DccTree> tree = DccTree::read(dcc(body));
    if (!tree || tree->all("a").size() != 1)
        return "(none)";
    return QString::fromStdString(tree->all("a").front().text());
}

/// As a program that writes UTF-16 does, with its mark.
std::string inUtf16(const std::string &ascii)
{
    std::string wide = "\xFF\xFE";
    for (const char c : ascii)
        wide.append({c, '\0'});
    return wide;
}

std::string nested(int elements)
{
    std::string text = "x";
    for (int i = 1; i < elements; ++i)
        text = "<a>" + text + "</a>";
    return dcc(text);
}

} // namespace

class TestDccTree : public QObject
{
    Q_OBJECT

private slots:
    void names_areWithoutTheirPrefix()
    {
        const Result<DccTree> tree = DccTree::read(
            "<x:digitalCalibrationCertificate schemaVersion='3.3.0'><y:a>1</y:a><a/>"
            "</x:digitalCalibrationCertificate>");
        QVERIFY(tree.has_value());
        const DccNode root = tree->root();
        QCOMPARE(root.name(), std::string("digitalCalibrationCertificate"));
        QCOMPARE(root.attribute("schemaVersion"), std::string("3.3.0"));
        QCOMPARE(root.attribute("other"), std::string());
        QCOMPARE(root.children().size(), std::size_t(2));
        QCOMPARE(tree->all("a").size(), std::size_t(2));
        QCOMPARE(tree->all("y:a").size(), std::size_t(0));
        QVERIFY(root.hasChild("a") && !root.hasChild("b"));
        QCOMPARE(root.childText("a"), std::string("1"));
        QCOMPARE(root.childText("b"), std::string());
    }

    void all_isInTheOrderOfTheDocument()
    {
        const Result<DccTree> tree = DccTree::read(dcc("<a><b/><c><d/></c></a><e/>"));
        QStringList names;
        for (const DccNode &node : tree->all())
            names << QString::fromStdString(node.name());
        QCOMPARE(names.join(' '), QString("digitalCalibrationCertificate a b c d e"));
    }

    void text_isAsItStands_data()
    {
        QTest::addColumn<QString>("body");
        QTest::addColumn<QString>("text");
        QTest::newRow("blanks stay") << "<a> 1  2 </a>"
                                     << " 1  2 ";
        QTest::newRow("none") << "<a/>"
                              << "";
        QTest::newRow("escaped") << "<a>&lt;&amp;&#65;&gt;</a>"
                                 << "<&A>";
        QTest::newRow("unknown entity") << "<a>&e;</a>"
                                        << "&e;";
        QTest::newRow("cdata") << "<a><![CDATA[<b>&amp;]]></a>"
                               << "<b>&amp;";
        QTest::newRow("parted by a comment") << "<a>1 2<!-- and --> 3</a>"
                                             << "1 2 3";
        QTest::newRow("parted by cdata") << "<a>1<![CDATA[ 2]]> 3</a>"
                                         << "1 2 3";
        QTest::newRow("parted by a program's") << "<a>1<?p q?> 2</a>"
                                               << "1 2";
        QTest::newRow("parted by a child") << "<a>1<b>9</b> 2</a>"
                                           << "1 2";
        QTest::newRow("line ends") << "<a>1\r\n2</a>"
                                   << "1\n2";
    }
    void text_isAsItStands()
    {
        QFETCH(QString, body);
        QFETCH(QString, text);
        QCOMPARE(textOfA(body.toStdString()), text);
    }

    void path_saysWhichOfSeveral()
    {
        const Result<DccTree> tree = DccTree::read(dcc("<r><q/><p:s/><q/><q><t/></q></r>"));
        QStringList paths;
        for (const DccNode &node : tree->all())
            paths << QString::fromStdString(node.path());
        QCOMPARE(paths.join(' '), QString(" r r/q[1] r/s r/q[2] r/q[3] r/q[3]/t"));
    }

    /// Followed from the root, a path leads to its element and to no other.
    void paths_areUniqueAndLeadBack()
    {
        const Result<DccTree> tree = DccTree::read(testing::exampleDcc());
        QVERIFY(tree.has_value());
        std::vector<std::string> paths;
        for (const DccNode &node : tree->all()) {
            paths.push_back(node.path());
            const std::string above = node.parent().path();
            if (above.empty())
                continue;
            QVERIFY2(paths.back().starts_with(above + "/" + node.name()), paths.back().c_str());
            QCOMPARE(node.parentName(), node.parent().name());
        }
        const std::size_t all = paths.size();
        std::ranges::sort(paths);
        paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
        QVERIFY(all > 500);
        QCOMPARE(paths.size(), all);
    }

    void signature_hasItsOwnIds()
    {
        const Result<DccTree> tree
            = DccTree::read(dcc("<ds:Signature><ds:Object id='k'/></ds:Signature><SignatureOf/>"));
        QVERIFY(tree->all("Signature").front().isSignature());
        QVERIFY(tree->all("Object").front().isSignature());
        QVERIFY(!tree->all("SignatureOf").front().isSignature());
        QVERIFY(!tree->root().isSignature());
    }

    void foreign_isRefused_data()
    {
        QTest::addColumn<QByteArray>("xml");
        QTest::addColumn<QString>("why");
        const auto row = [](const char *name, const std::string &xml, const char *why) {
            QTest::newRow(name) << QByteArray::fromStdString(xml) << why;
        };
        const std::string type = "<!DOCTYPE x [<!ENTITY e SYSTEM 'file:///etc/passwd'>]>";
        row("nothing", "", "no well-formed");
        row("no XML", "certificate", "no well-formed");
        row("cut off", dcc("<a>").substr(0, 20), "no well-formed");
        row("ends crossed", dcc("<a><b></a></b>"), "no well-formed");
        row("end of another", "<digitalCalibrationCertificate></a>", "no well-formed");
        row("two documents", dcc("") + dcc(""), "no well-formed");
        row("another behind it", dcc("") + "<!-- c --><b/>", "no well-formed");
        row("another document", "<html/>", "first element is another");
        row("longer name", "<digitalCalibrationCertificates/>", "first element is another");
        row("document type", type + dcc("&e;"), "document type");
        row("document type of UTF-16", inUtf16(type + dcc("&e;")), "document type");
        row("too deep", nested(101), "nested deeper");
        row("much too deep", nested(20000), "nested deeper");
        row("too large", dcc(std::string((std::size_t(64) << 20U) + 1, ' ')), "larger than 64 MiB");
    }
    void foreign_isRefused()
    {
        QFETCH(QByteArray, xml);
        QFETCH(QString, why);
        const Result<DccTree> tree = DccTree::read(xml.toStdString());
        QVERIFY(!tree);
        QCOMPARE(tree.error().kind, ErrorKind::FileUnreadable);
        const QString sentence = QString::fromStdString(english(tree.error().message));
        QVERIFY2(sentence.contains(why), qPrintable(sentence));
    }

    void largestAndDeepest_areRead()
    {
        const Result<DccTree> deep = DccTree::read(nested(100));
        QVERIFY(deep.has_value());
        QCOMPARE(deep->all().size(), std::size_t(100));
        QVERIFY(DccTree::read(inUtf16(dcc("<a>1</a>"))).has_value());
    }

    /// A DCC that a transfer has cut anywhere is refused, and so is one with a byte too few.
    void cutAnywhere_isRefused()
    {
        const std::string whole = "<?xml version=\"1.0\"?>\n" + dcc("<a b='c'>1 &lt; <d/></a>");
        for (std::size_t size = 0; size < whole.size(); ++size)
            QVERIFY2(!DccTree::read(whole.substr(0, size)), std::to_string(size).c_str());
        QVERIFY(DccTree::read(whole).has_value());
    }

    void wordsIn_areBetweenBlanks()
    {
        using Words = std::vector<std::string>;
        QCOMPARE(wordsIn(""), Words());
        QCOMPARE(wordsIn(" \t\r\n"), Words());
        QCOMPARE(wordsIn("a"), Words{"a"});
        QCOMPARE(wordsIn("\n a\tb\r\nc  "), (Words{"a", "b", "c"}));
        QCOMPARE(wordsIn("a\xC2\xA0"
                         "b"),
            (Words{"a\xC2\xA0"
                   "b"}));
    }
};

DYNCAL_TEST(TestDccTree)
#include "tst_dcc_tree.moc"
