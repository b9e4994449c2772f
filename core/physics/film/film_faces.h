// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a film knows of its faces: linearised flows, derivatives, and work space.
#pragma once

#include <array>
#include <vector>

#include "core/numerics/dual.h"
#include "core/physics/film/cut_paths.h"
#include "core/physics/film/film_stencil.h"
#include "core/physics/film/path_flow.h"

namespace touchdown {

/// The flow through the faces across one axis, linearised. Padded arrays, by face.
struct FilmFaces {
    std::vector<double> flow;               // without the correction of the complete flux scheme [Pa m^3/s]
    std::vector<double> inflow;             // that the upstream cell alone would send [Pa m^3/s]
    std::vector<double> lower, upper;       // the flow's derivatives by the pressures below and above [m^3/s]
    std::vector<double> share, inflowShare; // derivatives of the limited correction by the full one, by the inflow [-]
    std::vector<double> below, above;       // moments, not limited; zero unless the scheme is complete flux [m]
    std::vector<double> ownLower, ownUpper; // added to `lower` and `upper` by the change of the correction [m^3/s]
    std::vector<double> diffusion;          // K, for multigrid [m^3/s]
    std::vector<double> effective;          // E >= |convection|/2 [m^3/s]
    std::vector<double> convection;         // lower + upper [m^3/s]
};

/// Derivatives, by the gap in the middle of the path and by its rise along the path, of the flows through smooth faces
/// across one axis, and of their corrections at constant slopes of the flow. Padded, by face.
struct GapSlopes {
    std::vector<double> flowByGap, flowByRise, ownByGap, ownByRise; // [Pa m^2/s]
};

/// Moments of the paths of a row of faces and their derivatives by the mean pressure [m], [m/Pa], and the derivatives
/// of the inflow by the pressures [m^3/s].
struct FaceMoments {
    std::vector<double> below, above, belowByMean, aboveByMean, inflowByLower, inflowByUpper;
};

/// Work space for the flows through a row of faces.
struct FaceWork {
    explicit FaceWork(const FilmGaps& gaps);

    std::vector<double> product;                     // of mean pressure and gap [Pa m]
    std::vector<double> mobility, mobilityByProduct; // [Pa m], [-]
    std::vector<double> mobilityByGap;               // [Pa]
    std::vector<double> width, length, share;        // of the paths of a row where all are alike [m], [m], [-]
    CutPaths::Work cut;
};

/// Work space for the derivatives by the attitude; the first call that needs the large arrays allocates them.
struct AttitudeWork {
    explicit AttitudeWork(const FilmGaps& gaps) : row(gaps) {}
    void resize(std::size_t size);

    FaceWork row;
    std::array<GapSlopes, 2> slopes;
    FaceFlows<double> flows;
    std::array<std::vector<PathFlow<Dual<3>>>, 2> cutFlows; // by height, pitch, roll
};

} // namespace touchdown
