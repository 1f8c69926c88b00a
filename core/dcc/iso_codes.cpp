// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/iso_codes.h"

#include <algorithm>

namespace dyncal {
namespace {

constexpr std::string_view kCountries
    = "AD AE AF AG AI AL AM AO AQ AR AS AT AU AW AX AZ BA BB BD BE BF BG BH BI BJ BL BM BN BO BQ BR BS "
      "BT BV BW BY BZ CA CC CD CF CG CH CI CK CL CM CN CO CR CU CV CW CX CY CZ DE DJ DK DM DO DZ EC EE "
      "EG EH ER ES ET FI FJ FK FM FO FR GA GB GD GE GF GG GH GI GL GM GN GP GQ GR GS GT GU GW GY HK HM "
      "HN HR HT HU ID IE IL IM IN IO IQ IR IS IT JE JM JO JP KE KG KH KI KM KN KP KR KW KY KZ LA LB LC "
      "LI LK LR LS LT LU LV LY MA MC MD ME MF MG MH MK ML MM MN MO MP MQ MR MS MT MU MV MW MX MY MZ NA "
      "NC NE NF NG NI NL NO NP NR NU NZ OM PA PE PF PG PH PK PL PM PN PR PS PT PW PY QA RE RO RS RU RW "
      "SA SB SC SD SE SG SH SI SJ SK SL SM SN SO SR SS ST SV SX SY SZ TC TD TF TG TH TJ TK TL TM TN TO "
      "TR TT TV TW TZ UA UG UM US UY UZ VA VC VE VG VI VN VU WF WS YE YT ZA ZM ZW";

constexpr std::string_view kLanguages
    = "aa ab ae af ak am an ar as av ay az ba be bg bi bm bn bo br bs ca ce ch co cr cs cu cv cy da de "
      "dv dz ee el en eo es et eu fa ff fi fj fo fr fy ga gd gl gn gu gv ha he hi ho hr ht hu hy hz ia "
      "id ie ig ii ik io is it iu ja jv ka kg ki kj kk kl km kn ko kr ks ku kv kw ky la lb lg li ln lo "
      "lt lu lv mg mh mi mk ml mn mr ms mt my na nb nd ne ng nl nn no nr nv ny oc oj om or os pa pi pl "
      "ps pt qu rm rn ro ru rw sa sc sd se sg si sk sl sm sn so sq sr ss st su sv sw ta te tg th ti tk "
      "tl tn to tr ts tt tw ty ug uk ur uz ve vi vo wa wo xh yi yo za zh zu";

bool isIn(std::string_view codes, std::string_view code)
{
    constexpr std::size_t kLetters = 2, kStride = 3;
    if (code.size() != kLetters || code.find(' ') != code.npos)
        return false;
    const std::size_t at = codes.find(code);
    return at != codes.npos && at % kStride == 0;
}

/// "SE" of "SE-501"
std::string_view beforePostCode(std::string_view word)
{
    constexpr std::size_t kLetters = 2;
    const bool isMarked = word.size() > kLetters + 1 && word[kLetters] == '-'
        && word[kLetters + 1] >= '0' && word[kLetters + 1] <= '9';
    return isMarked ? word.substr(0, kLetters) : std::string_view();
}

} // namespace

bool isCountryCode(std::string_view code)
{
    return isIn(kCountries, code);
}

bool isLanguageCode(std::string_view code)
{
    return isIn(kLanguages, code);
}

std::string countryOf(std::string_view address)
{
    constexpr std::string_view kBetween = " \t\r\n,;.";
    std::string_view last;
    for (std::size_t at = address.find_first_not_of(kBetween); at != address.npos;) {
        const std::size_t end = std::min(address.find_first_of(kBetween, at), address.size());
        last = address.substr(at, end - at);
        if (const auto marked = beforePostCode(last); isCountryCode(marked))
            return std::string(marked);
        at = address.find_first_not_of(kBetween, end);
    }
    return isCountryCode(last) ? std::string(last) : kNoCountry;
}

} // namespace dyncal
