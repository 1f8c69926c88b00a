// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A certificate of anybody is read: names, texts, paths, and what is refused.

#include "core/dcc/dcc_rules.h"
#include "core/dcc/dcc_tree.h"
#include "tests/core/dcc/example_dcc.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
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

    /// Without a document type nobody declares it (XML 1.0, 4.1), so the document is none.
    void unknownEntity_isRefused()
    {
        QVERIFY(DccTree::read(dcc("<a>&lt;</a>")));
        const Result<DccTree> tree = DccTree::read(dcc("<a>&e;</a>"));
        QVERIFY(!tree && tree.error().kind == ErrorKind::FileUnreadable);
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
        row("nothing", "", "malformed");
        row("no XML", "certificate", "malformed");
        row("cut off", dcc("<a>").substr(0, 20), "malformed");
        row("ends crossed", dcc("<a><b></a></b>"), "malformed");
        row("end of another", "<digitalCalibrationCertificate></a>", "malformed");
        row("two documents", dcc("") + dcc(""), "several elements that hold everything");
        row("another behind it", dcc("") + "<!-- c --><b/>", "several elements");
        row("another document", "<html/>", "first element is another");
        row("longer name", "<digitalCalibrationCertificates/>", "first element is another");
        row("document type", type + dcc("&e;"), "document type");
        row("document type of UTF-16", inUtf16(type + dcc("&e;")), "document type");
        row("too deep", nested(101), "nested deeper");
        row("much too deep", nested(20000), "nested deeper");
        row("too large", dcc(std::string(kMostXmlBytes, ' ')), "more than the 67108864 bytes");
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

    /// A file may have all its elements on one level; each path is found without a look at the
    /// others, of which there are 10 000 million pairs here.
    void paths_ofManyBesideEachOther_areFoundAtOnce()
    {
        constexpr int kMany = 100000;
        std::string body;
        for (int i = 0; i < kMany; ++i)
            body += "<measurementResult/>";
        const std::string xml = dcc("<r>" + body + "</r>");
        QElapsedTimer timer;
        timer.start();
        const Result<DccTree> tree = DccTree::read(xml);
        QVERIFY(tree.has_value());
        const std::vector<DccNode> nodes = tree->all("measurementResult");
        QCOMPARE(nodes.size(), std::size_t(kMany));
        for (int i = 0; i < kMany; ++i)
            QVERIFY(nodes[static_cast<std::size_t>(i)].path()
                == "r/measurementResult[" + std::to_string(i + 1) + "]");
        const Result<DccCheck> check = ruleFindings(xml);
        QVERIFY(check.has_value());
        QVERIFY(check->findings.size() >= 2 * std::size_t(kMany)); // each lacks both
        QVERIFY2(timer.elapsed() < 20000, qPrintable(QString::number(timer.elapsed())));
    }

    void parents_andChildren_areEachOthers()
    {
        const Result<DccTree> tree = DccTree::read(testing::exampleDcc());
        QVERIFY(tree.has_value());
        std::size_t children = 0;
        for (const DccNode &node : tree->all())
            for (const DccNode &child : node.children()) {
                QVERIFY(child.parent() == node && node < child);
                ++children;
            }
        QCOMPARE(children + 1, tree->all().size()); // the root is nobody's
        QVERIFY(tree->root().parent() == tree->root());
        QCOMPARE(tree->root().parentName(), std::string());
    }
};

DYNCAL_TEST(TestDccTree)
#include "tst_dcc_tree.moc"
