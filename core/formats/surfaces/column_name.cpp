// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/column_name.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/formats/words.h"

namespace touchdown {

namespace {

struct Group {
    WordMeaning meaning;
    std::string_view words; // between blanks, in plain lower case; "log*": all words that begin so
};

constexpr Group groups[] = {
    {WordMeaning::X, "x distance distancia distanz dist position posicion pos lateral length track downtrack along "
                     "scan travel circumferential circumference tangential abscissa horizontal arc path location "
                     "coordinate coord koordinate place weg strecke laenge lange longitud abstand entfernung "
                     "\xE8\xB7\x9D\xE9\x9B\xA2 \xE4\xBD\x8D\xE7\xBD\xAE"},
    {WordMeaning::Y, "y across crosstrack transverse radial radius"},
    {WordMeaning::Height, "z h height hgt ht hoehe hohe topography topo topographie topografie elevation elev altitude "
                          "roughness rauheit waviness welligkeit relief vertical ordinate hauteur altezza altura zeta "
                          "\xE9\xAB\x98\xE3\x81\x95"},
    {WordMeaning::Depth, "depth* tiefe vertiefung* profond* profund* recess* pit groove* \xE6\xB7\xB1\xE3\x81\x95"},
    {WordMeaning::Below, "below down* beneath into toward towards upside unten unter unterhalb abwarts abajo debajo "
                         "bajo bas sous dessous"},
    {WordMeaning::Turns, "inv invert* revers* flip* negat* neg minus umgekehrt* umgedreht*"},
    {WordMeaning::Function, "squared quadr* deviation abweichung varian* logarit* logarith* deriv* ableitung* normali* "
                            "autoco* correlation korrel*"},
    {WordMeaning::Scaling,
     "mult multipl* divid* scaled skaliert* skalierung exaggerat* amplification* verstarkung* uberhoh* "
     "uncalibrated decimat*"},
    {WordMeaning::Factor, "factor faktor scale gain magnif* sensitiv* empfindlich* lsb digit*"},
    {WordMeaning::Quantity,
     "log ln lg exp sqrt std* sd sigma \xCF\x83 gap spacing clearance separation fly flying flug spalt root abs "
     "absolute absolut betrag inverse square sqr sq "
     "half halv* doubl* twice tripl* power standard* var rms rq ra rz rt sa pv err error* fehler* uncertain* unsicher* "
     "noise "
     "rauschen residu* slope* steigung neigung gradient* grad dz dh curvature krummung psd spectr* spektr* espectr* "
     "acf "
     "fft streu* scatter spread increment* inkrement* change* anderung* differen* diff delta sum summe integral* "
     "product ratio reciprocal norm cumulat* percent* probab* pdf histogra* "
     "amplitude amp phase deflection deflexion force current voltage volt potential count cts intensity reflectivity "
     "grey gray brightness time freq* wavelength period wavenumber thickness dicke wear stiffness modulus adhesion "
     "density quality min max minim* maxim* peak range temperature pressure velocity speed load indentation "
     "penetration eindring* rautiefe magnitude bearing flatness rate index kraft spannung zeit"},
    {WordMeaning::Data, "axis achse value wert valor data daten column spalte type content variable label sign "
                        "vorzeichen positiv* signal sensor surface oberflache profile profil image map bump*"},
    {WordMeaning::Neutral,
     "afm raw forward fwd backward bwd trace retrace filtered levelled leveled flattened corrected calibrat* detrended "
     "measured mess gemessen channel ch col disk disc platter sample point mean median mittlere gemittelt* gefiltert* "
     "average avg averaged "
     "smoothed relative rel actual the of in at der des den direction dir side line unit above over plane left right "
     "real true main primary processed unfiltered section step stage up upward upwards displacement total no nr number "
     "reference referenz"},
};

/// In lower case, without accents and dots: "H\xC3\xB6he" to "hohe".
std::string plainWord(std::string_view letters)
{
    constexpr std::string_view plain = "aaaaaaaceeeeiiiidnooooo_ouuuuyts"; // U+00C0 to U+00DF, and from U+00E0
    std::string word;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        const auto byte = static_cast<unsigned char>(letters[i]);
        const auto next = i + 1 < letters.size() ? static_cast<unsigned char>(letters[i + 1]) : 0;
        if (byte == 0xC3 && next >= 0x80) {
            word += plain[next & 0x1FU];
            ++i;
        } else if ((byte == 0xCC && next >= 0x80) || (byte == 0xCD && next < 0xB0)) { // beside its letter
            ++i;
        } else {
            word += letters[i];
        }
    }
    return lowerCase(word);
}

constexpr std::size_t longestWord = 40; // [byte]

std::optional<WordMeaning> listedMeaning(const std::string& word)
{
    static const auto listed = [] {
        std::unordered_map<std::string, WordMeaning> all;
        for (const Group& group : groups)
            for (std::size_t at = 0; at < group.words.size();) {
                const std::size_t end = std::min(group.words.find(' ', at), group.words.size());
                all.emplace(group.words.substr(at, end - at), group.meaning);
                at = end + 1;
            }
        return all;
    }();
    const auto found = listed.find(word);
    return found == listed.end() ? std::nullopt : std::optional(found->second);
}

/// Of a word, or of its singular.
std::optional<WordMeaning> exactMeaning(const std::string& word)
{
    if (const auto meaning = listedMeaning(word)) return meaning;
    for (const std::string_view plural : {"s", "n", "es", "en", "e"})
        if (word.size() > plural.size() + 2 && word.ends_with(plural))
            if (const auto meaning = listedMeaning(word.substr(0, word.size() - plural.size()))) return meaning;
    return std::nullopt;
}

std::optional<WordMeaning> meaningOf(const std::string& word)
{
    if (const auto meaning = exactMeaning(word)) return meaning;
    for (std::size_t length = std::min(word.size(), longestWord); length > 2; --length)
        if (const auto meaning = listedMeaning(word.substr(0, length) + '*')) return meaning;
    return std::nullopt;
}

bool isLetterByte(char c)
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

/// Adds a run of letters: one word, several in camel case, or two that are written as one, "logz".
void addWords(std::string_view letters, std::size_t at, std::vector<NameWord>& words)
{
    const auto add = [&](std::optional<WordMeaning> meaning) {
        words.push_back({std::string(letters), meaning.value_or(WordMeaning::Unknown), at});
    };
    const std::string word = plainWord(letters);
    if (const auto meaning = exactMeaning(word); meaning || word.size() == 1) return add(meaning);
    if (const std::size_t hump = endOfHump(letters); hump < letters.size()) {
        addWords(letters.substr(0, hump), at, words);
        return addWords(letters.substr(hump), at + hump, words);
    }
    for (std::size_t cut = 1; cut < std::min(word.size(), longestWord); ++cut) {
        const std::string left = word.substr(0, cut), right = word.substr(cut);
        const bool letter = left.size() == 1 || right.size() == 1;
        const std::string& other = left.size() == 1 ? right : left;
        const bool axis = letter && std::string_view("xyzh").find(left.size() == 1 ? left : right) < 4;
        if (letter ? !axis || other.size() < 3 : right.size() < 3) continue;
        const auto exact = exactMeaning(left), first = exact ? exact : listedMeaning(left + '*');
        const auto second = first ? meaningOf(right) : std::nullopt;
        if (!second) continue;
        add(first);
        return add(second);
    }
    add(meaningOf(word));
}

/// A number that may multiply: "10 z", "z x100", "z e-9"; not that of a channel, "height 2".
bool holdsFactor(std::string_view name)
{
    for (std::size_t at = name.find_first_of(decimalDigits); at != std::string_view::npos;
         at = name.find_first_of(decimalDigits, at)) {
        const std::size_t end = std::min(name.find_first_not_of(decimalDigits, at), name.size());
        const bool first = at == 0 && end < name.size();
        const bool joined = at > 0 && std::string_view("+-.").find(name[at - 1]) < 3;
        const bool power = end > at + 1 && name[at] == '1' && name.find_first_not_of('0', at + 1) >= end;
        if (first || joined || power || (end < name.size() && (isLetterByte(name[end]) || name[end] == '.')))
            return true;
        at = end;
    }
    return false;
}

/// Signs of a formula, "z^2", "|z|", "dz/dx", the signs of Unicode.
bool isFormula(std::string_view name)
{
    if (name.find_first_of("^*|/+=<>%~") != std::string_view::npos) return true;
    if (holdsFactor(name)) return true;
    for (const std::string_view sign :
         {"\xC2\xB1", "\xC2\xB2", "\xC2\xB3", "\xC3\x97", "\xE2\x88\x9A", "\xCE\x94", "\xE2\x88\x82", "\xE2\x88\x86"})
        if (name.find(sign) != std::string_view::npos) return true;
    return false;
}

bool isAxisLetter(const std::string& word)
{
    return word.size() == 1 && std::string_view("xyzhXYZH").find(word) != std::string_view::npos;
}

bool isNone(WordMeaning meaning) { return meaning >= WordMeaning::Function && meaning <= WordMeaning::Quantity; }

ColumnRole roleOf(WordMeaning meaning)
{
    switch (meaning) {
    case WordMeaning::X: return ColumnRole::X;
    case WordMeaning::Y: return ColumnRole::Y;
    case WordMeaning::Height:
    case WordMeaning::Depth: return ColumnRole::Height;
    default: return ColumnRole::Any;
    }
}

/// The name with the dashes of typography as minus signs.
std::string withMinus(std::string_view name)
{
    std::string text(trimmed(name, " \t\"'.:"));
    for (const std::string_view dash : {"\xE2\x80\x93", "\xE2\x88\x92"})
        for (auto at = text.find(dash); at != std::string::npos; at = text.find(dash))
            text.replace(at, dash.size(), "-");
    return text;
}

/// The signs that turn a name: "-z", "- z", "z-"; not the hyphens of "down-track" and dashes between words.
int countMinus(std::string_view name)
{
    int count = 0;
    for (std::size_t at = name.find('-'); at != std::string_view::npos; at = name.find('-', at + 1)) {
        const bool before = at > 0 && isLetterByte(name[at - 1]);
        const bool after = at + 1 < name.size() && isLetterByte(name[at + 1]);
        if (before ? at + 1 == name.size() : (after || at == 0)) ++count;
    }
    return count;
}

} // namespace

std::vector<NameWord> wordsWithMeaning(std::string_view text)
{
    std::vector<NameWord> words;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (!isLetterByte(text[at])) continue;
        const std::size_t begin = at;
        std::string initials(1, text[at]); // "s.d."
        std::size_t end = at + 1;
        for (; end + 1 < text.size() && text[end] == '.' && isLetterByte(text[end + 1]); end += 2)
            initials += text[end + 1];
        const bool apart = end == text.size() || !isLetterByte(text[end]);
        if (initials.size() > 1 && apart && exactMeaning(lowerCase(initials))) {
            words.push_back({std::string(text.substr(begin, end - begin)), *exactMeaning(lowerCase(initials)), begin});
            at = end;
            continue;
        }
        while (at < text.size() && isLetterByte(text[at])) ++at;
        addWords(text.substr(begin, at - begin), begin, words);
    }
    return words;
}

ColumnName columnName(std::string_view written)
{
    const std::string name = withMinus(written);
    const std::vector<NameWord> words = wordsWithMeaning(name);
    ColumnName column;
    column.turned = countMinus(name) % 2 == 1;
    column.known = !name.ends_with(" -"); // a minus or a dash
    // A letter of an axis tells most, then a height, then a place: "z position", "scan height".
    int sure = 0;
    bool below = false, anything = words.empty();
    for (const NameWord& word : words) {
        const bool letter = word.text.size() == 1;
        anything = anything || word.meaning != WordMeaning::Unknown || letter;
        if (word.meaning == WordMeaning::Unknown) {
            column.known = column.known && letter && words.size() == 1; // "u m"
            continue;
        }
        if (isNone(word.meaning) && column.word.empty()) column.word = word.text;
        if (word.meaning == WordMeaning::Turns) column.turned = !column.turned;
        below = below || word.meaning == WordMeaning::Depth || word.meaning == WordMeaning::Below;
        const ColumnRole role = roleOf(word.meaning);
        const int weight = isAxisLetter(word.text) ? 4 : role == ColumnRole::Height ? 3 : role == ColumnRole::Y ? 2 : 1;
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
