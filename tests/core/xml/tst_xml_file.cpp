// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/xml/xml_file.h"
#include "core/xml/xml_limits.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace dyncal;

/// The bytes of a file, as many as may be of use.
class TestXmlFile : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    std::string path(const char *name) const { return m_folder.filePath(name).toStdString(); }
    std::string written(const char *name, const QByteArray &bytes) const
    {
        QFile file(m_folder.filePath(name));
        return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() ? path(name)
                                                                                    : "(failed)";
    }

private slots:
    void bytes_areThoseOfTheFile()
    {
        const QByteArray every = QByteArray("<a>\r\n\0\xFF</a>", 11).repeated(20000);
        QCOMPARE(xmlFileBytes(written("every", every)).value(), every.toStdString());
        QCOMPARE(xmlFileBytes(written("none", {})).value(), std::string());
    }

    /// Of a file of holes, which may be larger than the memory.
    void largerThanMayBe_isReadOnlySoFar()
    {
        QFile file(m_folder.filePath("large"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.resize(qint64(1) << 36));
        file.close();
        const std::size_t size = xmlFileBytes(path("large")).value().size();
        QVERIFY(size > kMostXmlBytes && size < kMostXmlBytes + (std::size_t(1) << 20U));
    }

    void whatCannotBeRead_isSaid()
    {
        for (const std::string &one : {path("missing"), m_folder.path().toStdString()}) {
            const Result<std::string> bytes = xmlFileBytes(one);
            QVERIFY2(!bytes, one.c_str());
            QCOMPARE(bytes.error().kind, ErrorKind::FileUnreadable);
            QVERIFY(english(bytes.error().message).find(one) != std::string::npos);
        }
    }
};

DYNCAL_TEST(TestXmlFile)
#include "tst_xml_file.moc"
