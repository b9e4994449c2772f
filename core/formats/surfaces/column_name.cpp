// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/column_name.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/formats/words.h"

namespace touchdown {

namespace {

/// Depth and Below count downwards, once; Turns changes the sign each time.
enum class Meaning : std::uint8_t { X, Y, Height, Depth, Below, Turns, None, Neutral };

struct Group {
    Meaning meaning;
    std::string_view words; // between blanks, in lower case
};

constexpr Group groups[] = {
    {Meaning::X, "x distance dist position pos lateral length track downtrack along scan travel circumferential "
                 "circumference tangential abscissa horizontal arc path location coordinate coord place weg strecke "
                 "laenge lange distanz entfernung \xE8\xB7\x9D\xE9\x9B\xA2 \xE4\xBD\x8D\xE7\xBD\xAE"},
    {Meaning::Y, "y across crosstrack transverse radial radius"},
    {Meaning::Height, "z h height hgt ht hoehe hohe topography topo topographie elevation elev altitude roughness "
                      "rauheit waviness welligkeit relief vertical ordinate hauteur altezza altura zeta "
                      "\xE9\xAB\x98\xE3\x81\x95"},
    {Meaning::Depth, "depth tiefe profondeur"},
    {Meaning::Below, "below down downward upside"},
    {Meaning::Turns, "inverted invert inv reversed reverse flipped negated negative neg minus"},
    {Meaning::None,
     "gap spacing clearance separation fly flying log ln lg exp sqrt root abs absolute inverse square squared sqr sq "
     "half double twice triple power "
     "std stdev stddev "
     "sd sigma standard deviation var variance rms rq ra rz rt sa pv error err uncertainty noise residual slope "
     "gradient "
     "grad derivative dz dh curvature psd spectrum spectral spectra acf autocorr autocorrelation correlation "
     "autocovariance fft "
     "amplitude amp phase deflection friction force current voltage volt potential count cts intensity reflectivity "
     "grey "
     "gray brightness time frequency freq wavelength period wavenumber thickness wear stiffness modulus adhesion "
     "density probability pdf histogram percent percentage difference diff delta quality min max minimum maximum peak "
     "range temperature pressure velocity speed load reciprocal normalized normalised norm normalization ratio "
     "indentation penetration magnitude bearing cumulative integral flatness product sum deflexion lsb digit rate "
     "index steigung kraft spannung zeit"},
    {Meaning::Neutral,
     "axis achse value wert data raw forward fwd backward bwd trace retrace filtered levelled leveled flattened "
     "corrected detrended measured sensor channel ch col column disk disc platter sample point mean average avg "
     "averaged smoothed relative rel actual the of in at direction dir side line unit above plane surface profile "
     "left right real true main primary processed unfiltered section step stage positive up upward upwards "
     "displacement total no nr number"},
};

std::optional<Meaning> meaningOf(std::string_view word)
{
    for (const Group& group : groups)
        for (std::size_t at = group.words.find(word); at != std::string_view::npos;
             at = group.words.find(word, at + 1)) {
            const std::size_t end = at + word.size();
            if ((at == 0 || group.words[at - 1] == ' ') && (end == group.words.size() || group.words[end] == ' '))
                return group.meaning;
        }
    const bool plural = word.size() > 3 && word.ends_with('s');
    return plural ? meaningOf(word.substr(0, word.size() - 1)) : std::nullopt;
}

bool isLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) > 127;
}
bool isCapital(char c) { return c >= 'A' && c <= 'Z'; }

/// "XPos", "heightSensor": where the next word begins.
std::size_t endOfHump(std::string_view word)
{
    for (std::size_t i = 1; i < word.size(); ++i) {
        const bool next = i + 1 < word.size() && isCapital(word[i - 1]) && !isCapital(word[i + 1]);
        if (isCapital(word[i]) && (!isCapital(word[i - 1]) || next)) return i;
    }
    return word.size();
}

/// The meanings of a run of letters: one word, several in camel case, or two that are written as one, "logz".
struct Run {
    std::vector<std::pair<std::string, std::optional<Meaning>>> words;

    void add(std::string_view letters)
    {
        std::string word = lowerCase(letters);
        std::optional<Meaning> meaning = meaningOf(word);
        if (meaning || letters.size() == 1) return words.emplace_back(std::move(word), meaning), void();
        if (const std::size_t hump = endOfHump(letters); hump < letters.size()) {
            add(letters.substr(0, hump));
            return add(letters.substr(hump));
        }
        for (std::size_t cut = 1; cut < word.size(); ++cut) {
            const std::string left = word.substr(0, cut), right = word.substr(cut);
            const bool letter = left.size() == 1 || right.size() == 1;
            const std::string& other = left.size() == 1 ? right : left;
            const bool axis = letter && std::string_view("xyzh").find(left.size() == 1 ? left : right) < 4;
            if ((letter && (!axis || other.size() < 3)) || !meaningOf(left) || !meaningOf(right)) continue;
            words.emplace_back(left, meaningOf(left));
            words.emplace_back(right, meaningOf(right));
            return;
        }
        words.emplace_back(std::move(word), std::nullopt);
    }
};

/// A number that may multiply: "10 z", "z x100", "z e-9"; not that of a channel, "height 2".
bool holdsFactor(std::string_view name)
{
    for (std::size_t at = name.find_first_of(decimalDigits); at != std::string_view::npos;
         at = name.find_first_of(decimalDigits, at)) {
        const std::size_t end = std::min(name.find_first_not_of(decimalDigits, at), name.size());
        const bool first = at == 0 && end < name.size();
        const bool joined = at > 0 && std::string_view("+-.").find(name[at - 1]) < 3;
        const bool power = end > at + 1 && name[at] == '1' && name.find_first_not_of('0', at + 1) >= end;
        if (first || joined || power || (end < name.size() && (isLetter(name[end]) || name[end] == '.'))) return true;
        at = end;
    }
    return false;
}

/// Signs of a formula, "z^2", "|z|", "dz/dx", the squares and roots of Unicode.
bool isFormula(std::string_view name)
{
    if (name.find_first_of("^*|/+=<>%~") != std::string_view::npos) return true;
    if (holdsFactor(name)) return true;
    for (const std::string_view sign : {"\xC2\xB2", "\xC2\xB3", "\xE2\x88\x9A", "\xCE\x94", "\xE2\x88\x82"})
        if (name.find(sign) != std::string_view::npos) return true;
    return false;
}

bool isAxisLetter(const std::string& word) { return word == "x" || word == "y" || word == "z" || word == "h"; }

ColumnRole roleOf(Meaning meaning)
{
    switch (meaning) {
    case Meaning::X: return ColumnRole::X;
    case Meaning::Y: return ColumnRole::Y;
    case Meaning::Height:
    case Meaning::Depth: return ColumnRole::Height;
    default: return ColumnRole::Any;
    }
}

} // namespace

ColumnName columnName(std::string_view name)
{
    ColumnName column;
    name = trimmed(name, " \t\"'.:");
    Run run;
    for (std::size_t at = 0; at < name.size(); ++at) {
        if (!isLetter(name[at])) continue;
        const std::size_t begin = at;
        while (at < name.size() && isLetter(name[at])) ++at;
        const bool minus = begin > 0 && name[begin - 1] == '-' && (begin == 1 || !isLetter(name[begin - 2]));
        if (minus) column.turned = !column.turned;
        run.add(name.substr(begin, at - begin));
    }
    // A letter of an axis tells most, then a height, then a place: "z position", "scan height".
    int sure = 0;
    bool below = false, anything = run.words.empty();
    for (const auto& [word, meaning] : run.words) {
        anything = anything || meaning || word.size() == 1;
        if (!meaning) {
            column.known = column.known && word.size() == 1 && run.words.size() == 1; // "u m"
            continue;
        }
        if (*meaning == Meaning::None && column.word.empty()) column.word = word;
        if (*meaning == Meaning::Turns) column.turned = !column.turned;
        below = below || *meaning == Meaning::Depth || *meaning == Meaning::Below;
        const ColumnRole role = roleOf(*meaning);
        const int weight = isAxisLetter(word) ? 4 : role == ColumnRole::Height ? 3 : role == ColumnRole::Y ? 2 : 1;
        if (role == ColumnRole::Any || weight <= sure) continue;
        sure = weight;
        column.role = role;
    }
    if (column.word.empty() && isFormula(name)) column.word = name;
    if (!column.word.empty()) return {ColumnRole::None, column.known, false, column.word};
    if (sure == 0) column.role = anything ? ColumnRole::Any : ColumnRole::Unknown;
    const bool place = column.role == ColumnRole::X || column.role == ColumnRole::Y;
    if (place && column.turned) return {ColumnRole::Unknown, column.known, false, {}};
    column.turned = column.turned != (below && !place); // "down the track"
    return column;
}

} // namespace touchdown
