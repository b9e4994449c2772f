// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/key_path.h"

namespace touchdown {

std::string settingKey(const std::string& key, const std::string& table)
{
    std::string name = key.substr(table.size() + 1);
    if (name.size() > 1 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
    return name;
}

std::string withoutNumbers(const std::string& key)
{
    std::string name;
    bool inside = false;
    for (const char c : key) {
        if (c == '[') inside = true;
        if (!inside) name += c;
        if (c == ']') inside = false;
    }
    return name;
}

std::string tableOf(const std::string& key)
{
    const auto mark = key.find('"'); // a part in quotation marks may hold dots
    const auto dot = mark == std::string::npos ? key.rfind('.') : mark == 0 ? mark : mark - 1;
    return dot == std::string::npos ? std::string() : key.substr(0, dot);
}

std::string leafOf(const std::string& key)
{
    const std::string table = tableOf(key);
    return table.empty() ? key : key.substr(table.size() + 1);
}

std::string ownerOf(const std::string& key)
{
    return key.ends_with(']') ? key.substr(0, key.rfind('[')) : tableOf(key);
}

} // namespace touchdown
