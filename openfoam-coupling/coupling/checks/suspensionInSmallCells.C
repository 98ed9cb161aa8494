// SPDX-License-Identifier: GPL-3.0-or-later
#include "caseChecks.H"

#include "fvMesh.H"

#include "coupling/checks/particleLayer.H"
#include "coupling/particles/coupledParticles.H"
#include "coupling/sixDigits.H"

namespace
{

//- Shares of solid between which particles are a suspension: below it they hardly meet, above it they are a bed.
constexpr Foam::scalar from = 0.01, to = 0.2;

//- Cells and smoothing, in diameters, from which on a suspension settles as it should (void_fraction.md)
constexpr Foam::scalar cells = 6, smoothing = 3;

//- Single spheres and rows of them are no suspension.
constexpr Foam::label least = 30;

} // End anonymous namespace


void Foam::warnOfSuspensionInSmallCells
(
    const dictionary& dict,
    const fvMesh& mesh,
    const coupledParticles& particles
)
{
    if (!(mag(particles.g()) > 0))
    {
        return;
    }
    const particleLayer layer(mesh, particles);
    if (layer.count < least || !(layer.height > 0) || layer.share() < from || layer.share() >= to)
    {
        return;
    }
    const scalar d = layer.diameter;
    const scalar cell = Foam::cbrt(gSum(mesh.V())*particles.depthRatio()/mesh.globalData().nTotalCells());
    // Rounding of a mesh of six diameters is no smaller cell.
    if (cell > 0.99*cells*d || dict.getOrDefault<scalar>("smoothingWidth", 0) > 0.99*smoothing*d)
    {
        return;
    }
    IOWarningInFunction(dict)
        << "the particles begin as a suspension: " << sixDigits(layer.share()).c_str() << " of the layer of "
        << sixDigits(layer.height).c_str() << " m in which they are is solid, and the cells have "
        << sixDigits(cell/d).c_str() << " particle diameters. At random positions it settles up to a half too fast, as"
        << " cells with more particles than others sink as a whole" << nl
        << "    Use cells of six diameters, " << sixDigits(cells*d).c_str() << " m, and more, or 'voidFraction"
        << " sphereOverlap; smoothingWidth " << sixDigits(smoothing*d).c_str() << ";'. A bed that falls into place"
        << " needs neither" << endl;
}
