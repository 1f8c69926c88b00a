// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Certificates that were damaged or made to harm: an answer or a sentence, never more. Long form:
// 10 000 of them.

#include "core/dcc_reading/certified_sensor.h"
#include "tests/support/made_dcc.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QElapsedTimer>
#include <QTest>

#include <cmath>
#include <random>
#include <string>

using namespace dyncal;

namespace {

std::string certificate()
{
    using namespace testing;
    return dccOf(
        dccList(dccQuantity("1 10 100", "\\kilo\\hertz")
            + dccQuantity("0.1 0.2 0.3", "\\volt\\mega\\pascal\\tothe{-1}", "0.002")
            + dccQuantity("-1 -2 -3", "\\degree", "0.1")
            + dccComplex("3 3 3", "4 4 4", "\\volt", {"1 1 1", "0 0 0", "1 1 1"}, "\\volt\\volt"))
        + dccQuantity("5", "\\volt\\pascal\\tothe{-1}", "0.1"));
}

/// Whatever was read is sound: no value that the file does not state, no impossible uncertainty.
void checkSound(const StatedValues &stated)
{
    QVERIFY(!stated.values.empty());
    QVERIFY(stated.u.empty() || stated.u.size() == stated.values.size());
    QCOMPARE(stated.k.size(), stated.u.size());
    for (const double value : stated.values)
        QVERIFY(!std::isinf(value));
    for (const double u : stated.u)
        QVERIFY(std::isnan(u) || u >= 0.0);
    for (const double k : stated.k)
        QVERIFY(std::isnan(k) || k > 0.0);
}

void checkOne(const std::string &bytes)
{
    const Result<DccContents> contents = readDcc(bytes);
    if (!contents) {
        QVERIFY(contents.error().kind == ErrorKind::FileUnreadable);
        QVERIFY(!english(contents.error().message).empty());
        return;
    }
    for (const StatedTable &table : contents->tables)
        for (const StatedQuantity &column : table.columns)
            checkSound(column.stated.values);
    const CertifiedSensor sensor = certifiedSensor(*contents);
    for (const Message &one : sensor.leftOut)
        QVERIFY(!english(one).empty());
    if (!sensor.response)
        return;
    checkSound(sensor.response->magnitude);
    for (const double f_Hz : sensor.response->frequency_Hz)
        QVERIFY(f_Hz > 0.0 && std::isfinite(f_Hz));
}

using Random = std::mt19937;

std::size_t anyOf(Random &random, std::size_t count)
{
    return count == 0 ? 0 : random() % count;
}

/// Where a random element begins and ends, closing tag and all; empty where it finds none.
std::pair<std::size_t, std::size_t> anyElement(const std::string &text, Random &random)
{
    const std::size_t begin = text.find('<', anyOf(random, text.size()));
    if (begin == text.npos || begin + 1 >= text.size()
        || !std::isalpha(static_cast<unsigned char>(text[begin + 1])))
        return {0, 0};
    const std::string name = text.substr(begin + 1, text.find_first_of(" >", begin) - begin - 1);
    const std::size_t end = text.find("</" + name + ">", begin);
    return end == text.npos ? std::pair<std::size_t, std::size_t>{0, 0}
                            : std::pair{begin, end + name.size() + 3};
}

void changeByte(std::string &text, Random &random)
{
    text[anyOf(random, text.size())] = static_cast<char>(random() % 256);
}

void removeElement(std::string &text, Random &random)
{
    const auto [begin, end] = anyElement(text, random);
    text.erase(begin, end - begin);
}

void repeatElement(std::string &text, Random &random)
{
    const auto [begin, end] = anyElement(text, random);
    const std::string element = text.substr(begin, end - begin);
    for (auto times = 1 + random() % 3; times > 0; --times)
        text.insert(begin, element);
}

void moveElement(std::string &text, Random &random)
{
    const auto [begin, end] = anyElement(text, random);
    const std::string element = text.substr(begin, end - begin);
    text.erase(begin, end - begin);
    text.insert(text.find('<', anyOf(random, text.size())) % (text.size() + 1), element);
}

void replaceNumber(std::string &text, Random &random)
{
    constexpr const char *kOdd[]{"NaN", "INF", "-0", "1e308", "1e-320", "1,5", "", "9e999",
        "0 0 0 0", "\xEF\xBC\x91", "--1", "1e", "\\volt", "&#x0;", "&e;"};
    const std::size_t at = text.find_first_of("0123456789", anyOf(random, text.size()));
    if (at != text.npos)
        text.replace(at, 1, kOdd[anyOf(random, std::size(kOdd))]);
}

void cut(std::string &text, Random &random)
{
    text.resize(anyOf(random, text.size()));
}

void declareEntity(std::string &text, Random &random)
{
    constexpr const char *kTypes[]{"<!DOCTYPE x [<!ENTITY e 'eeeeeeee'>]>",
        "<!DOCTYPE x [<!ENTITY e SYSTEM 'file:///etc/passwd'>]>",
        "<!DOCTYPE x SYSTEM 'http://127.0.0.1/x.dtd'>", "<!DOCTYPE x [<!ENTITY % p 'q'> %p;]>"};
    text.insert(text.find("<dcc:") % (text.size() + 1), kTypes[anyOf(random, std::size(kTypes))]);
}

void nest(std::string &text, Random &random)
{
    const auto depth = random() % 300;
    const std::string name = random() % 2 == 0 ? "dcc:list" : "si:hybrid";
    const auto [begin, end] = anyElement(text, random);
    std::string open, close;
    for (unsigned long i = 0; i < depth; ++i) {
        open += "<" + name + ">";
        close += "</" + name + ">";
    }
    text.insert(end, close);
    text.insert(begin, open);
}

void lengthen(std::string &text, Random &random)
{
    const std::size_t at = text.find_first_of("0123456789", anyOf(random, text.size()));
    if (at == text.npos)
        return;
    std::string list;
    for (auto count = random() % 2000; count > 0; --count)
        list += std::to_string(random()) + ' ';
    text.insert(at, list);
}

void encodeOtherwise(std::string &text, Random &random)
{
    constexpr const char *kNames[]{"UTF-16", "ISO-8859-1", "windows-1252", "UTF-7", "EBCDIC"};
    const std::size_t at = text.find("UTF-8");
    if (at != text.npos)
        text.replace(at, 5, kNames[anyOf(random, std::size(kNames))]);
    if (random() % 2 == 0)
        return;
    std::string wide = "\xFF\xFE";
    for (const char c : text)
        wide += {c, '\0'};
    text = wide;
}

using Change = void (*)(std::string &text, Random &random);

std::string mutant(const std::string &whole, Random &random)
{
    constexpr Change kChanges[]{changeByte, removeElement, repeatElement, moveElement,
        replaceNumber, cut, declareEntity, nest, lengthen, encodeOtherwise};
    std::string text = whole;
    for (auto times = 1 + random() % 4; times > 0 && !text.empty(); --times)
        kChanges[anyOf(random, std::size(kChanges))](text, random);
    return text;
}

} // namespace

class TestDccHostile : public QObject
{
    Q_OBJECT

private slots:
    void mutants_areReadOrRefused()
    {
        Random random(20);
        const std::string whole = certificate();
        QVERIFY(certifiedSensor(readDcc(whole).value()).response.has_value());
        const int trials = trials::count(600, 10000);
        for (int trial = 0; trial < trials && !QTest::currentTestFailed(); ++trial)
            checkOne(mutant(whole, random));
    }

    void everyBeginning_isReadOrRefused()
    {
        const std::string whole = certificate();
        for (std::size_t length = 0; length < whole.size(); length += 7)
            QVERIFY(!readDcc(whole.substr(0, length)));
    }

    /// Time grows with the size, whatever is repeated: nothing is searched again and again.
    void largeFiles_takeTheirTime()
    {
        using namespace testing;
        std::string numbers, lists;
        for (int i = 1; i <= 200000; ++i)
            numbers += std::to_string(i) + ' ';
        for (int i = 0; i < 3000; ++i)
            lists += dccList(dccQuantity("1 2", "\\hertz"), std::to_string(i));
        QElapsedTimer timer;
        timer.start();
        checkOne(dccOf(dccList(
            dccQuantity(numbers, "\\hertz") + dccQuantity(numbers, "\\volt\\per\\pascal", "1"))));
        checkOne(dccOf(lists));
        checkOne(dccOf(dccList(dccQuantity("1", std::string(1000000, '\\')))));
        constexpr int kAmple_ms = 15000;
        QVERIFY(timer.elapsed() < kAmple_ms);
    }
};

DYNCAL_TEST(TestDccHostile)
#include "tst_dcc_hostile.moc"
