// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleAveraging.H"

#include "coupling/input/selectRow.H"


Foam::particleAveraging::particleAveraging(const fvMesh& mesh, const dictionary& dict)
:
    mesh_(mesh),
    exchange_(mesh, selectRow(dict, "voidFraction", cohesion::void_fraction::kernels)),
    smoothing_(mesh, dict)
{}
