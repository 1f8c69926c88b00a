// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <string_view>

namespace dyncal {

/// ISO 3166-1: two capital letters that name a country ("SE"). "ZZ" names none.
bool isCountryCode(std::string_view code);
/// ISO 639-1: two small letters that name a language.
bool isLanguageCode(std::string_view code);

/// What a DCC has, which must have a country, where none is stated: a code of those that ISO 3166
/// leaves to the user.
inline constexpr const char *kNoCountry = "ZZ";

/// The country that an address names by its code: before the post code ("SE-501 15 Borås") or as
/// its last word ("Borås, SE"). kNoCountry where it does not; the name of a city is no answer.
std::string countryOf(std::string_view address);

} // namespace dyncal
