// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace dyncal::testing {

/// How the numbers of a column are written.
enum class Print {
    Fixed, ///< all with the same digits behind the mark
    Exponent, ///< all with the same digits behind the mark and in the exponent
    Lossless, ///< 17 digits
    Whole, ///< up to 2^53
    Mixed, ///< anything that a program may print
};

struct RandomColumn
{
    std::string name, unit;
    Print print = Print::Fixed;
    std::vector<std::string> cells; ///< with "." as decimal mark
    std::vector<double> values; ///< what the C library reads in them; NaN = no sample
};

/// A table of numbers in some dialect, with what a reader must find in it. Everything is certain:
/// either the dialect has only one reading, or the header says what it is.
struct RandomTable
{
    std::vector<RandomColumn> columns;
    std::optional<std::size_t> time; ///< this column holds the times
    double secondsPerUnit = 1.0;
    double first_s = 0.0, rate_Hz = 0.0; ///< of the times, or as a note says; 0 = unknown
    char separator = ','; ///< ' ' = blanks
    char decimal = '.';
    std::vector<std::string> header;
    std::vector<std::string> rows; ///< lines without their ends
    std::string lineEnd;
    bool lastLineEnds = true;

    std::string text() const
    {
        std::string all;
        for (const std::string &line : header)
            all += line + lineEnd;
        for (const std::string &line : rows)
            all += line + lineEnd;
        return lastLineEnds ? all : all.substr(0, all.size() - lineEnd.size());
    }
};

/// Makes tables from a seed: the same table whenever it is asked again.
class TableMaker
{
public:
    explicit TableMaker(std::uint64_t seed)
        : m_random(seed)
    {
    }

    RandomTable make()
    {
        chooseDialect();
        chooseColumns();
        writeHeader();
        for (std::size_t k = 0; k < m_table.columns[0].cells.size(); ++k)
            m_table.rows.push_back(row(k));
        return m_table;
    }

private:
    std::size_t below(std::size_t count) { return m_random() % count; }
    bool chance(double share)
    {
        return std::uniform_real_distribution<>(0.0, 1.0)(m_random) < share;
    }

    template <std::size_t N>
    std::string oneOf(const std::array<const char *, N> &words)
    {
        return words[below(N)];
    }

    void chooseDialect()
    {
        m_table.separator = std::array{',', ';', '\t', '|', ' '}[below(5)];
        m_quoted = chance(0.2);
        const bool commaIsTaken = m_table.separator == ',' && !m_quoted;
        m_table.decimal = !commaIsTaken && chance(0.5) ? ',' : '.';
        m_table.lineEnd = oneOf(std::array{"\n", "\r\n", "\r"});
        m_table.lastLineEnds = chance(0.7);
        m_padding = chance(0.3) ? std::string(1 + below(3), ' ') : std::string();
        m_emptyTail = m_table.separator != ' ' && chance(0.2);
    }

    void chooseColumns()
    {
        const std::size_t rows = 10 + below(50);
        const std::size_t samples = 1 + below(4);
        // One column with decimal commas can be two columns as well.
        const bool times = chance(0.6) || (samples == 1 && m_table.decimal == ',');
        for (std::size_t i = 0; i < samples; ++i)
            m_table.columns.push_back(sampleColumn(i, rows));
        if (!times)
            return;
        m_table.time = chance(0.8) ? 0 : below(samples + 1);
        m_table.columns.insert(
            m_table.columns.begin() + static_cast<std::ptrdiff_t>(*m_table.time), timeColumn(rows));
    }

    /// Times that are exact as printed: whole multiples of one digit.
    RandomColumn timeColumn(std::size_t rows)
    {
        struct Unit
        {
            const char *name;
            double seconds;
        };
        constexpr std::array<Unit, 6> kUnits{{{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6},
            {"\u00B5s", 1e-6}, {"ns", 1e-9}, {"sec", 1.0}}};
        const Unit unit = kUnits[below(kUnits.size())];
        const int digits = static_cast<int>(below(9));
        const auto step = static_cast<std::int64_t>(std::array{1, 2, 5, 25, 125, 1280}[below(6)]);
        const auto first = static_cast<std::int64_t>(below(2000)) * (chance(0.3) ? -step : step);
        RandomColumn column{
            oneOf(std::array{"time", "Time", "t", "Zeit", "tid"}), unit.name, Print::Fixed, {}, {}};
        for (std::size_t k = 0; k < rows; ++k)
            addCell(column, fixedDecimals(first + static_cast<std::int64_t>(k) * step, digits));
        const double digit_s = unit.seconds / std::pow(10.0, digits);
        m_table.secondsPerUnit = unit.seconds;
        m_table.rate_Hz = 1.0 / (static_cast<double>(step) * digit_s);
        m_table.first_s = static_cast<double>(first) * digit_s;
        return column;
    }

    /// 12345 with 3 digits: "12.345".
    static std::string fixedDecimals(std::int64_t number, int digits)
    {
        std::string text = std::to_string(std::abs(number));
        const auto behind = static_cast<std::size_t>(digits);
        if (text.size() <= behind)
            text.insert(0, behind + 1 - text.size(), '0');
        if (behind > 0)
            text.insert(text.size() - behind, 1, '.');
        return number < 0 ? "-" + text : text;
    }

    RandomColumn sampleColumn(std::size_t place, std::size_t rows)
    {
        constexpr std::array kUnits{"V", "mV", "bar", "m/s\u00B2", "psi", "Pa"};
        constexpr std::array kNames{"p", "Druck", "Kraft", "CH", "tryck_", "ACC."};
        RandomColumn column{
            oneOf(kNames) + std::to_string(place + 1), oneOf(kUnits), Print::Fixed, {}, {}};
        column.print = static_cast<Print>(below(5));
        m_digits = 1 + static_cast<int>(below(12));
        const double share = chance(0.3) ? 0.1 : 0.0;
        for (std::size_t k = 0; k < rows; ++k) {
            const bool invalid = k > 3 && k + 1 < rows && chance(share);
            const bool mayBeEmpty = m_table.separator != ' ' || m_quoted;
            addCell(column,
                !invalid                        ? number(column.print)
                    : mayBeEmpty && chance(0.5) ? std::string()
                                                : oneOf(std::array{"nan", "NaN", "NAN"}));
        }
        return column;
    }

    static void addCell(RandomColumn &column, const std::string &cell)
    {
        column.values.push_back(cell.empty() ? std::numeric_limits<double>::quiet_NaN()
                                             : std::strtod(cell.c_str(), nullptr));
        column.cells.push_back(cell);
    }

    static std::string printed(const char *format, int digits, double value)
    {
        std::array<char, 512> text;
        const int size = std::snprintf(text.data(), text.size(), format, digits, value);
        return {text.data(), static_cast<std::size_t>(size)};
    }

    std::string number(Print print)
    {
        const double unit = std::uniform_real_distribution<>(-1.0, 1.0)(m_random);
        switch (print) {
        case Print::Fixed:
            return printed("%.*f", m_digits, 100.0 * unit);
        case Print::Exponent:
            return printed(m_digits % 2 == 0 ? "%.*e" : "%.*E", m_digits, 1e-3 * unit);
        case Print::Lossless:
            return printed("%.*g", 17, unit * std::pow(10.0, double(below(30)) - 15.0));
        case Print::Whole:
            return std::to_string(static_cast<std::int64_t>(std::ldexp(unit, int(below(54)))));
        case Print::Mixed:
            break;
        }
        return mixed(unit);
    }

    std::string mixed(double unit)
    {
        switch (below(9)) {
        case 0:
            return std::to_string((std::int64_t(1) << 53) - static_cast<std::int64_t>(below(3)));
        case 1: // the smallest numbers there are, with few bits left
            return printed("%.*e", 16, std::ldexp(unit, -1022 - int(below(52))));
        case 2:
            return printed("%.*g", 17, std::ldexp(unit, 1000));
        case 3:
            return oneOf(
                std::array{"0", "-0", "0.0", "+0.50", "-.5", ".125e+01", "+7", "00012.50"});
        case 4: // more digits than a double has, up to all that it has
            return printed("%.*f", 20 + static_cast<int>(below(90)), unit);
        case 5:
            return printed("%.*e", 20 + static_cast<int>(below(30)), unit);
        case 6: // too small to be told from zero
            return unit < 0 ? "-1e-400" : "3.5E-0777";
        default:
            return printed("%.*g", 1 + static_cast<int>(below(17)), unit);
        }
    }

    std::string quoted(const std::string &cell) const { return m_quoted ? '"' + cell + '"' : cell; }

    std::string joined(const std::vector<std::string> &cells, bool tail) const
    {
        std::string line;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (i > 0)
                line += m_padding + m_table.separator + m_padding;
            line += quoted(cells[i]);
        }
        return tail ? line + m_table.separator : line;
    }

    std::string row(std::size_t k)
    {
        std::vector<std::string> cells;
        for (const RandomColumn &column : m_table.columns) {
            std::string cell = column.cells[k];
            if (const std::size_t mark = cell.find('.'); mark != std::string::npos)
                cell[mark] = m_table.decimal;
            cells.push_back(cell);
        }
        // Some programs write the separator behind every value, some only behind some.
        return joined(cells, m_emptyTail && chance(0.8));
    }

    void writeHeader()
    {
        const std::array notes{"made by a program", "", "# exported; as | text", "operator: N. N."};
        for (std::size_t k = below(3); k > 0; --k)
            m_table.header.push_back(oneOf(notes));
        if (!m_table.time && chance(0.5)) {
            m_table.header.push_back("Sample rate: 51.2 kHz");
            m_table.rate_Hz = 51200.0;
        }
        const std::size_t style = below(4);
        std::vector<std::string> names, units;
        for (const RandomColumn &column : m_table.columns) {
            const std::string blank = chance(0.7) ? " " : "";
            const std::array titles{column.name + blank + '(' + column.unit + ')',
                column.name + blank + '[' + column.unit + ']', column.name};
            names.push_back(titles[std::min<std::size_t>(style, 2)]);
            units.push_back(style == 2 ? '[' + column.unit + ']' : column.unit);
        }
        m_table.header.push_back(joined(names, m_emptyTail && chance(0.5)));
        if (style >= 2)
            m_table.header.push_back(joined(units, m_emptyTail && chance(0.5)));
    }

    std::mt19937_64 m_random;
    RandomTable m_table;
    bool m_quoted = false;
    bool m_emptyTail = false;
    std::string m_padding;
    int m_digits = 6;
};

} // namespace dyncal::testing
