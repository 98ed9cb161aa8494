// SPDX-License-Identifier: GPL-3.0-or-later
#include "caseChecks.H"

#include "coupling/input/selectRow.H"
#include "coupling/sixDigits.H"

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
    for (direction d = 0; d < 3; ++d)
    {
        // There is no particle.
        if (lowest[d] > highest[d])
        {
            lowest[d] = highest[d] = g[d];
        }
    }

    // Three components that were each rounded to four digits
    const scalar tolerance = 1e-4*max(mag(g), max(mag(lowest), mag(highest)));
    for (direction d = 0; d < 3; ++d)
    {
        if (mesh.geometricD()[d] > 0 && max(g[d] - lowest[d], highest[d] - g[d]) > tolerance)
        {
            std::string found(sixDigits(lowest));
            if (mag(highest - lowest) > tolerance)
            {
                found += " to " + sixDigits(highest);
            }
            const vector down(mag(g) > 0 ? g/mag(g) : g);
            FatalIOErrorInFunction(dict)
                << "gravity is " << sixDigits(g).c_str() << " m/s2 for the gas, in constant/g, and " << found.c_str()
                << " m/s2 for the particles that the script moves, by its fixes gravity" << nl
                << "    Make them the same, in the script by 'fix ID all gravity " << sixDigits(mag(g)).c_str()
                << " vector " << sixDigits(down.x()).c_str() << ' ' << sixDigits(down.y()).c_str() << ' '
                << sixDigits(down.z()).c_str() << "' alone; where they are meant to"
                << " differ, say so by 'particleGravity any;'" << exit(FatalIOError);
        }
    }
}
