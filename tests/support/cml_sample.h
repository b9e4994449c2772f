// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files of a slider that exists nowhere but here, as the established program writes its own: a step with walls at the
// leading edge, a ramp in the middle, a pad with walls at the trailing edge.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <QByteArrayList>

#include "core/case_files/case_file.h"
#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown::test {

inline std::string cmlRailText()
{
    return "CML Version 7.0  RAIL.DAT  4.26\n"
           "a slider made up for tests\n"
           "1.2500E-003      1.0000E-003      3.0000E-004     \n"
           " 3                2               \n"
           " 4                1               \n"
           "1.0000E-004      2.0000E-004      1             \n"
           "4.0000E-004      2.0000E-004      1             \n"
           "4.0000E-004      8.0000E-004      1             \n"
           "1.0000E-004      8.0000E-004      1             \n"
           "1.5000E-007\n"
           " 4                0               \n"
           "5.0000E-004      3.0000E-004      0             \n"
           "7.0000E-004      3.0000E-004      0             \n"
           "7.0000E-004      7.0000E-004      0             \n"
           "5.0000E-004      7.0000E-004      0             \n"
           "4.0000E-007      2.0000E-007      2.0000E-007\n"
           " 5                1               \n"
           "1.1000E-003      4.0000E-004      2             \n"
           "1.2400E-003      4.0000E-004      0             \n"
           "1.2400E-003      6.0000E-004      2             \n"
           "1.1000E-003      6.0000E-004      2             \n"
           "1.0500E-003      5.0000E-004      2             \n"
           "0.0000E+000\n"
           " 3 2\n"
           "-1.0000E-006  0.0000E+000  2.0000E-006 \n"
           " 1.5000E-007  4.0000E-007  1.2000E-006 \n"
           " 0.0000E+000  5.0000E-006 \n"
           " 0.0000E+000  2.0000E-006 \n"
           "5.0000E-005      1.0000E-002      2.0000E-006     \n"
           "1.2000E-008      -3.0000E-009     1.0000E-009     \n"
           " 1.2400E-003  1.2000E-003 \n"
           " 5.0000E-004  4.5000E-004 \n";
}

/// What it says.
inline AirBearingSurface cmlSurface()
{
    AirBearingSurface s;
    s.rails = {
        {RailKind::Step, {{1e-4, 2e-4, 1}, {4e-4, 2e-4, 1}, {4e-4, 8e-4, 1}, {1e-4, 8e-4, 1}}, {1.5e-7, 0.0, 0.0}},
        {RailKind::Ramp, {{5e-4, 3e-4, 0}, {7e-4, 3e-4, 0}, {7e-4, 7e-4, 0}, {5e-4, 7e-4, 0}}, {4e-7, 2e-7, 2e-7}},
        {RailKind::Step,
         {{1.1e-3, 4e-4, 2}, {1.24e-3, 4e-4, 0}, {1.24e-3, 6e-4, 2}, {1.1e-3, 6e-4, 2}, {1.05e-3, 5e-4, 2}},
         {0.0, 0.0, 0.0}},
    };
    s.walls = {{{-1e-6, 0.0, 2e-6}, {1.5e-7, 4e-7, 1.2e-6}}, {{0.0, 5e-6}, {0.0, 2e-6}}};
    s.baseRecess = 2e-6;
    s.crown = 1.2e-8;
    s.camber = -3e-9;
    s.twist = 1e-9;
    s.taperLength = 5e-5;
    s.taperAngle = 1e-2;
    s.pointsOfInterest = {{1.24e-3, 5e-4}, {1.2e-3, 4.5e-4}};
    return s;
}

inline std::string cmlRunText()
{
    return "CML Version 7.0  RUN.DAT  4.26\n"
           "a slider made up for tests\n"
           "***************Solution Control***************\n"
           "istiff isolv   ioldg   iadpt   isave\n"
           " 0      1       0       0       1\n"
           "***************Intial Attitude***************\n"
           "hm(m)          pitch(rad)     roll(rad)\n"
           "+8.0000E-009   1.2000E-004    -2.0000E-006  \n"
           "***************Runs***************\n"
           "irad           irpm           ialt         sort\n"
           " 1             1              1              0             \n"
           "radii(m)\n"
           "   2.3000E-002    \n"
           "skews(deg)\n"
           "   1.2500E+001    \n"
           "RPMs\n"
           "   7.2000E+003    \n"
           "altitudes(m)\n"
           "   0.0000E+000    \n"
           "***************Air Parameters***************\n"
           "p0(pa)         al(m)          vis(nsm^-2)\n"
           "9.9000E+004    6.5000E-008    1.8200E-005   \n"
           "***************Load Parameters***************\n"
           "f0(kg)         xf0(m)         yf0(m)         psa            rsa            usestiff\n"
           "1.5000E-003    1.0000E-005    -2.0000E-005   1.0000E-003    -5.0000E-004   1\n"
           "xfs(\xb5NM)       yfs(\xb5NM)       emax           skp            skr\n"
           "5.0000E-001    -1.0000E-001   1.0000E-005    1.2000E-004    1.1000E-004   \n"
           "***************Grid Control***************\n"
           "nx      ny\n"
           " 97      81\n"
           "nsx      nsy     isymm\n"
           " 1       1       0      \n"
           "xnt(i), i = 2, nsx\n"
           " \n"
           "nxt(i), i = 2, nsx\n"
           " \n"
           "dxr(i), i = 1, nsx\n"
           " 1 \n"
           "ynt(i), i = 2, nsy\n"
           "\n"
           "nyt(i), i = 2, nsy\n"
           " \n"
           "dyr(i), i = 1, nsy\n"
           " 1 \n"
           "**************Adaptive Grid****************\n"
           "difmax_x        decay_x        ipmax_x      iadaptmode_x\n"
           " 60             20             0            1           \n"
           "difmax_y        decay_y        ipmax_y\n"
           " 60             20             0           \n"
           "********Mesh Refinement in X Direction*******\n"
           "numXRegions\n"
           "0\n"
           "Lower         Upper          Amount\n"
           "*******Mesh Refinement in Y Direction********\n"
           "numYRegions\n"
           "0\n"
           "Lower         Upper          Amount\n"
           "***************Reynolds Equation***************\n"
           "ischeme        imodel         akmax         beta           gamma         accommodation   mgnest\n"
           " 1              1             1.0000E-008   6.0000E+000    6.0000E+000   8.0000E-001     4             \n"
           "***************Partial Contact***************\n"
           "icmodel        stdasp(m)      dnsasp(m^-2)   ConstantA      ConstantB\n"
           " 0             3.0000E-010    1.0000E+012    1.0000E-019    1.0000E-076   \n"
           "rdsasp(m)      eyoung(pa)     yldstr(pa)     elecpot(v)\n"
           "1.0000E-008    1.0000E+010    1.0000E+012    0.0000E+000   \n"
           "frcoe          pratio\n"
           " 0.3            0.3           \n"
           "***************Sensitivities***************\n"
           "crowninc(m)    camberinc(m)   twistinc(m)\n"
           "2.5000E-009    0.0000E+000    0.0000E+000   \n"
           "tlnginc(m)     tanginc(rad)   loadinc(kg)\n"
           "0.0000E+000    0.0000E+000    0.0000E+000   \n"
           "ptrqinc(\xb5NM)   rtrquinc(\xb5NM)  recessinc(m)\n"
           "0.0000E+000    0.0000E+000    0.0000E+000   \n"
           "iwscale\n"
           " 1\n"
           "***********************Additional Parameters*******************\n"
           "  output_shear   use_imf        use_standard_air\n"
           "  0              0              0\n"
           "  do_humidity    temperature    humidity\n"
           "  0              40.000000      50.000000\n"
           "***************Comments***************\n"
           "drawn for tests, pad of 5 \xb5m\n";
}

inline std::string cmlDynamicsText()
{
    return "CML Version 7.0  DYNAMICS.DEF\n"
           "*****************Problem Definition Menu*****************\n"
           "xl(m)          yl/xl          xg/xl          yg/xl          zg/xl          altitude(m)\n"
           "1.2500E-003    8.0000E-001    0.0000E+000    0.0000E+000    0.0000E+000    0.0000E+000\n"
           "f0(kg)         xf0/xl         yf0/yl         amz(kg)        aip(kgm^2)     air(kgm^2)\n"
           "1.5000E-003    1.0000E-002    -2.0000E-002   1.6000E-006    2.2000E-013    1.4500E-013\n"
           "rpm            dt(s)          tf(s)          ra(m)          rif(m)         rof(m)\n"
           "5.4000E+003    1.0000E-007    2.0000E-003    2.3000E-002    1.5000E-002    3.1000E-002\n"
           "*****************Suspension Menu*****************\n"
           "iact           xact(m)        dact(rad)      vact(rad/s)    ske(deg)\n"
           "0              5.0000E-002    0.0000E+000    0.0000E+000    -7.5000E+000\n"
           "isusp          nmodes         node           alpha(1/s)     beta(s)\n"
           "0              0              0              0.0000E+000    0.0000E+000\n"
           "skz(N/m)       skp(Nm/rad)    skr(Nm/rad)    scz(Ns/m)      scp(Nms/rad)   scr(Nms/rad)\n"
           "1.8000E+001    1.7450E-005    1.8450E-005    1.0000E-010    1.0000E-017    2.0000E-017\n"
           "psa(rad)       rsa(rad)\n"
           "1.0000E-003    2.0000E-003\n"
           "*****************Initial Condition Menu*****************\n"
           "hm(m)          hp(rad)        hr(rad)        vz(m/s)        vp(rad/s)      vr(rad/s)\n"
           "1.0000E-008    1.6000E-004    2.0000E-006    1.0000E-003    2.0000E+000    0.0000E+000\n"
           "*****************Solution Control Menu*****************\n"
           "iqpo           akmax          emax           idisc\n"
           "5              1.0000E-007    1.0000E-004    4\n"
           "*****************Grid Control Menu*****************\n"
           "iadapt         isymmetry      ioldgrid       nx             ny             nsx            nsy\n"
           "1              0              0              98             194            1              1\n"
           "xnt(i), i = 2, nsx\n"
           "\n"
           "nxt(i), i = 2, nsx\n"
           "\n"
           "dxr(i), i = 1, nsx\n"
           "1\n"
           "ynt(i), i = 2, nsy\n"
           "\n"
           "nyt(i), i = 2, nsy\n"
           "\n"
           "dyr(i), i = 1, nsy\n"
           "1\n"
           "difmax         decay          ipmax\n"
           "40             50             0\n"
           "*****************Disk Track Profile Menu*****************\n"
           "inwave         nfx            dinit          nfy\n"
           "0              0              0.0            0\n"
           "*****************Disk Surface Menu*****************\n"
           "nwave          nzone          nasper\n"
           "0              0              0\n"
           "*****************Asperity Contact Menu*****************\n"
           "icmod          eyoung(pa)     ydst(pa)       pratio         frcoe\n"
           "0              1.0000E+011    1.0000E+009    0.3            0.3\n"
           "*****************Additional Parameters*****************\n"
           "p0(pa)         al(m)          vis(nsm^-2)\n"
           "9.9000E+004    6.5000E-008    1.8200E-005\n"
           "*****************End*****************\n";
}

/// The number of the first line that begins with this, blanks aside; 0 if there is none.
inline int lineOf(const std::string& text, std::string_view begin)
{
    int line = 1;
    for (std::size_t at = 0; at < text.size(); ++line) {
        const std::size_t first = text.find_first_not_of(" +", at);
        if (first != std::string::npos && std::string_view(text).substr(first).starts_with(begin)) return line;
        const std::size_t end = text.find('\n', at);
        at = end == std::string::npos ? text.size() : end + 1;
    }
    return 0;
}

/// The text with a line, counted from 1, put in place of another.
inline std::string withLine(const std::string& text, int line, std::string_view replacement)
{
    std::size_t begin = 0;
    for (int i = 1; i < line; ++i) begin = text.find('\n', begin) + 1;
    return text.substr(0, begin) + std::string(replacement) + text.substr(text.find('\n', begin));
}

inline std::string firstLines(const std::string& text, int count)
{
    std::size_t end = 0;
    for (int i = 0; i < count; ++i) end = text.find('\n', end) + 1;
    return text.substr(0, end);
}

/// With another end of each line.
inline std::string withLineEnds(const std::string& text, std::string_view end)
{
    std::string result;
    for (const char c : text) {
        if (c == '\n')
            result += end;
        else
            result += c;
    }
    return result;
}

inline std::string replaced(std::string text, std::string_view what, std::string_view by)
{
    text.replace(text.find(what), what.size(), by);
    return text;
}

/// Problems or warnings, one a line.
inline QByteArray joined(const std::vector<InputProblem>& list)
{
    QByteArrayList lines;
    for (const InputProblem& each : list) lines << QByteArray::fromStdString(each.text());
    return lines.join('\n');
}

} // namespace touchdown::test
