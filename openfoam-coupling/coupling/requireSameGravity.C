// SPDX-License-Identifier: GPL-3.0-or-later
#include "requireSameGravity.H"

#include "selectRow.H"

#include <array>

namespace
{

struct ParticleGravity
{
    std::string_view name;
    bool any;
};

constexpr std::array particleGravities{ParticleGravity{"same", false}, ParticleGravity{"any", true}};

} // End anonymous namespace


bool Foam::asksForSameGravity(const dictionary& dict)
{
    return !selectRow(dict, "particleGravity", particleGravities, "same").any;
}


void Foam::requireSameGravity
(
    const dictionary& dict,
    const polyMesh& mesh,
    cohesion::coupling::DemEngine& engine,
    const vector& g
)
{
    const auto ofParticles = engine.gravity();
    vector lowest(ofParticles.lowest[0], ofParticles.lowest[1], ofParticles.lowest[2]);
    vector highest(ofParticles.highest[0], ofParticles.highest[1], ofParticles.highest[2]);
    reduce(lowest, minOp<vector>());
    reduce(highest, maxOp<vector>());
    if (lowest[0] > highest[0])
    {
        return;
    }

    // Three components that were each rounded to four digits
    const scalar tolerance = 1e-4*max(mag(g), max(mag(lowest), mag(highest)));
    for (direction d = 0; d < 3; ++d)
    {
        if (mesh.geometricD()[d] > 0 && max(g[d] - lowest[d], highest[d] - g[d]) > tolerance)
        {
            OStringStream found;
            found << lowest;
            if (mag(highest - lowest) > tolerance)
            {
                found << " to " << highest;
            }
            const vector down(mag(g) > 0 ? g/mag(g) : g);
            FatalIOErrorInFunction(dict)
                << "gravity is " << g << " m/s2 for the gas, in constant/g, and " << found.str().c_str()
                << " m/s2 for the particles that the script moves, by its fixes gravity" << nl
                << "    Make them the same, in the script by 'fix ID all gravity " << mag(g) << " vector "
                << down.x() << ' ' << down.y() << ' ' << down.z() << "' alone; where they are meant to"
                << " differ, say so by 'particleGravity any;'" << exit(FatalIOError);
        }
    }
}
