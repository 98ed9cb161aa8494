// SPDX-License-Identifier: GPL-3.0-or-later
#include "caseChecks.H"

#include "fvMesh.H"

#include "coupling/checks/particleLayer.H"
#include "coupling/particles/coupledParticles.H"
#include "coupling/sixDigits.H"

namespace
{

//- Widths that a bed is high at least. It resists as if it were about a width lower.
constexpr Foam::scalar least = 10;

//- Share of solid in the height that makes particles a bed
constexpr Foam::scalar bedFrom = 0.2;

//- Share of the mesh's height from which on particles fill it: without a surface there is nothing to spread.
constexpr Foam::scalar full = 0.9;

} // End anonymous namespace


void Foam::warnOfWideSmoothing(const dictionary& dict, const fvMesh& mesh, const coupledParticles& particles)
{
    const scalar width = dict.getOrDefault<scalar>("smoothingWidth", 0);
    if (!(width > 0) || !(mag(particles.g()) > 0))
    {
        return;
    }
    const particleLayer layer(mesh, particles);
    const scalar bed = layer.height;
    if (!(bed > 0) || bed > full*layer.vessel || layer.share() < bedFrom || bed > least*width)
    {
        return;
    }
    IOWarningInFunction(dict)
        << "smoothingWidth = " << sixDigits(width).c_str() << " m, while the bed is about " << sixDigits(bed).c_str()
        << " m high, " << sixDigits(bed/width).c_str() << " widths: its surface is spread into the gas above, and"
        << (bed > 2*width ? " a share of " + sixDigits(width/bed) : std::string(" most")).c_str()
        << " of its resistance is lost" << nl
        << "    Smooth beds of twenty widths and more; in this one take a smoothingWidth of at most "
        << sixDigits(bed/20).c_str() << " m, or none, in cells of two particle diameters" << endl;
}
