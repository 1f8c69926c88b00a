// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QTranslator>

#include <algorithm>
#include <cmath>

namespace dyncal::test {

/// A language in which every word is 40 % longer than in English and has accents: what fits in it
/// fits in most languages. Placeholders, tags and mnemonics stay.
class LongWords : public QTranslator
{
public:
    using QTranslator::QTranslator;

    bool isEmpty() const override { return false; }
    QString translate(const char *context, const char *source, const char *, int n) const override
    {
        if (context[0] == 'Q')
            return {}; // Qt's own
        QString text = longer(QString::fromUtf8(source));
        return n >= 0 ? text.replace("%n", QString::number(n)) : text;
    }

    static QString longer(const QString &text)
    {
        QString all;
        QString word;
        bool isTag = false;
        const auto endWord = [&] {
            all += word;
            // The least that makes words 40 % longer, from two letters on.
            const auto letters
                = static_cast<int>(std::ceil(0.4 * static_cast<double>(word.size())));
            if (word.size() > 1)
                all += QString(letters, QChar(0xE9));
            word.clear();
        };
        for (qsizetype i = 0; i < text.size(); ++i) {
            const QChar c = text[i];
            isTag = isTag || c == '<';
            if (c == '%' && i + 1 < text.size()) { // %1, %n, %L1
                endWord();
                all += c;
                while (i + 1 < text.size()
                    && (text[i + 1].isDigit() || text[i + 1] == 'n' || text[i + 1] == 'L'))
                    all += text[++i];
            } else if (!isTag && c.isLetter()) {
                word += accented(c);
            } else {
                endWord();
                all += c;
            }
            isTag = isTag && c != '>';
        }
        endWord();
        return all;
    }

private:
    static QChar accented(QChar c)
    {
        static const QString plain = "aeiouyAEIOU";
        static const QString marked = QString::fromUtf8("åéïöüýÅÉÏÖÜ");
        const auto at = plain.indexOf(c);
        return at < 0 ? c : marked[at];
    }
};

} // namespace dyncal::test
