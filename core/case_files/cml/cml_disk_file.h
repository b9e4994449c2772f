// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a dynamics.def says of the disk's surface and of the forces other than the air's, as we read it:
//
//   track profile     its wave.def; the first point lies under the leading edge at the start
//   waves             sinusoidal, with one wavelength, a sin(2 pi (x cos b + y sin b)/l), where they cover the whole
//                     slider
//   asperities        sinusoidal and ellipsoidal; x from the leading edge at the start, y from the inner edge; sizes
//                     are the full extents at the base. All have the form of the first.
//   intermolecular    van der Waals forces over the parts of the slider close to the disk at the initial pitch
#pragma once

#include "core/case_files/cml/cml_parameters.h"

namespace touchdown {

void readCmlTrackProfile(CmlPart& part);
void readCmlDiskSurface(CmlPart& part);
void readCmlIntermolecular(CmlPart& part);
void readCmlAsperityContact(CmlPart& part);

/// After all sections: one kind for all that the disk has; no forces where they would take too many cells.
void settleCmlDisk(CmlParameters& parameters);

} // namespace touchdown
