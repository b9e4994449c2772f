// SPDX-License-Identifier: GPL-3.0-or-later
//
// A DXF drawing as another program (ezdxf, its writer of AutoCAD R12) wrote it: no header, so no unit. In mm it has
// 0.1 ... 0.3 by 0.1 ... 0.2 on layer PAD; 0.5 ... 0.7 by 0.1 ... 0.2 with half a circle at its right end on ROUND;
// three lines, in any direction, and an arc that close an outline on LINES; a circle of radius 0.05 about (0.6, 0.6) on
// HOLE; and a text.
#pragma once

#include <string>
#include <string_view>

namespace touchdown::test {

inline std::string dxfSample()
{
    // "code value;": two lines of the file.
    constexpr std::string_view pairs = "0 SECTION;2 ENTITIES;"
                                       "0 POLYLINE;8 PAD;66 1;70 9;"
                                       "0 VERTEX;8 PAD;70 32;10 0.1;20 0.1;30 0;"
                                       "0 VERTEX;8 PAD;70 32;10 0.3;20 0.1;30 0;"
                                       "0 VERTEX;8 PAD;70 32;10 0.3;20 0.2;30 0;"
                                       "0 VERTEX;8 PAD;70 32;10 0.1;20 0.2;30 0;"
                                       "0 SEQEND;"
                                       "0 POLYLINE;8 ROUND;66 1;70 1;"
                                       "0 VERTEX;8 ROUND;70 0;10 0.5;20 0.1;"
                                       "0 VERTEX;8 ROUND;70 0;10 0.7;20 0.1;42 1.0;"
                                       "0 VERTEX;8 ROUND;70 0;10 0.7;20 0.2;"
                                       "0 VERTEX;8 ROUND;70 0;10 0.5;20 0.2;"
                                       "0 SEQEND;"
                                       "0 LINE;8 LINES;10 0.1;20 0.5;11 0.2;21 0.5;"
                                       "0 LINE;8 LINES;10 0.2;20 0.6;11 0.2;21 0.5;"
                                       "0 LINE;8 LINES;10 0.2;20 0.6;11 0.1;21 0.6;"
                                       "0 ARC;8 LINES;10 0.1;20 0.55;40 0.05;50 90;51 270;"
                                       "0 CIRCLE;8 HOLE;10 0.6;20 0.6;40 0.05;"
                                       "0 TEXT;8 0;10 0;20 0;1 drawn by hand;40 1.0;72 0;73 0;11 0;21 0;"
                                       "0 ENDSEC;"
                                       "0 EOF;";
    std::string text;
    for (std::size_t begin = 0; begin < pairs.size();) {
        const std::size_t space = pairs.find(' ', begin), end = pairs.find(';', begin);
        text += std::string(pairs.substr(begin, space - begin)) + '\n';
        text += std::string(pairs.substr(space + 1, end - space - 1)) + '\n';
        begin = end + 1;
    }
    return text;
}

} // namespace touchdown::test
