// SPDX-License-Identifier: GPL-3.0-or-later
#include "viscousWaves.H"

#include "PstreamReduceOps.H"
#include "cyclicPolyPatch.H"
#include "messageStream.H"
#include "surfaceFields.H"

#include "liquid/liquid_exchange.h"

#include "rankOfLargest.H"

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace cohesion;

namespace
{

//- Whether the cell behind a patch's face is that before it: across a periodic direction of one cell
bool leadsBack(const Foam::polyPatch& patch, const Foam::label facei)
{
    return Foam::isA<Foam::cyclicPolyPatch>(patch)
     && Foam::refCast<const Foam::cyclicPolyPatch>(patch).neighbPatch().faceCells()[facei]
     == patch.faceCells()[facei];
}


//- Twice the diagonal of the Laplacian, without what walls and openings add
Foam::scalarField largestWaveNumbers(const Foam::fvMesh& mesh)
{
    Foam::scalarField sum(mesh.nCells(), Foam::Zero);
    const Foam::surfaceScalarField conductance(mesh.magSf()*mesh.nonOrthDeltaCoeffs());
    forAll(mesh.neighbour(), facei)
    {
        sum[mesh.owner()[facei]] += conductance[facei];
        sum[mesh.neighbour()[facei]] += conductance[facei];
    }
    for (const auto& patch : conductance.boundaryField())
    {
        if (patch.coupled())
        {
            forAll(patch, facei)
            {
                if (!leadsBack(patch.patch().patch(), facei))
                {
                    sum[patch.patch().faceCells()[facei]] += patch[facei];
                }
            }
        }
    }
    return Foam::scalarField(2*sum/mesh.V().field());
}


//- The largest number of three digits up to x, so that what is printed is a whole multiple of it
Foam::scalar threeDigitsUpTo(const Foam::scalar x)
{
    const Foam::scalar unit = std::pow(10.0, std::floor(std::log10(x)) - 2);
    return std::floor(x/unit*(1 + 1e-9))*unit;
}

} // End anonymous namespace


Foam::viscousWaves::viscousWaves
(
    const fvMesh& mesh,
    const gasDensity& density,
    const bool applies,
    const scalar addedMass
)
:
    stepCriterion(applies),
    mesh_(mesh),
    density_(density),
    addedMass_(addedMass),
    largest_(applies ? largestWaveNumbers(mesh) : scalarField())
{}


drag::ViscousStep Foam::viscousWaves::step
(
    const label celli,
    const scalar volumePerDensity,
    const volScalarField& voidFraction,
    const volScalarField& nu,
    const label engineSteps
) const
{
    const scalar rho = density_.reference().value()*density_.ratio(celli);
    const scalar viscous = nu[celli]*largest_[celli]*mesh_.time().deltaTValue();
    const scalar eps = voidFraction[celli];
    const scalar displaced = volumePerDensity*rho/eps;
    if (!(addedMass_ > 0) || !(displaced > 0))
    {
        return {displaced, viscous, scalar(engineSteps)};
    }
    const scalar densityRatio = (1 - eps)/(eps*displaced);
    return
    {
        liquid::displaced_with_added_mass(eps, densityRatio, addedMass_),
        viscous*liquid::viscous_share(eps, addedMass_),
        scalar(engineSteps)
    };
}


bool Foam::viscousWaves::mayGrow
(
    const scalar ofLightest,
    const volScalarField& voidFraction,
    const volScalarField& nu
) const
{
    const scalar perDensity = returnReduce(ofLightest, maxOp<scalar>());
    bool may = false;
    forAll(largest_, celli)
    {
        const scalar volumePerDensity = (1 - voidFraction[celli])*perDensity;
        may = may || !drag::surely_no_viscous_waves(step(celli, volumePerDensity, voidFraction, nu, 1));
    }
    return returnReduce(may, orOp<bool>());
}


void Foam::viscousWaves::requireFinite(const label celli, const drag::ViscousStep& step) const
{
    if (!drag::is_finite(step))
    {
        FatalErrorInFunction
            << "in the cell at " << mesh_.C()[celli] << " the mass of gas over that of particles is "
            << step.displaced << ", and nu deltaT k^2 of the gas " << step.viscous << ": both must be finite;"
            << " see the masses of the particles and the viscosity there" << exit(FatalError);
    }
}


void Foam::viscousWaves::check
(
    const scalarField& volumePerDensity,
    const volScalarField& voidFraction,
    const volScalarField& nu,
    const label engineSteps
)
{
    Worst worst{drag::viscous_grows, vector::zero, 1, {0, 0, 1}};
    Steps cells;
    forAll(volumePerDensity, celli)
    {
        const drag::ViscousStep there =
            step(celli, volumePerDensity[celli], voidFraction, nu, engineSteps);
        requireFinite(celli, there);
        if (drag::surely_no_viscous_waves(there))
        {
            continue;
        }
        cells.push_back(there);
        if (!drag::viscous_waves_below(there, worst.growth))
        {
            const scalar growth = drag::viscous_growth(there);
            if (growth > worst.growth)
            {
                worst = {growth, mesh_.C()[celli], voidFraction[celli], there};
            }
        }
    }
    worst = worstOfRanks(worst);
    if (worst.growth > drag::viscous_grows)
    {
        warn(worst, cells);
    }
}


Foam::viscousWaves::Worst Foam::viscousWaves::worstOfRanks(const Worst& worst)
{
    const scalar growth = returnReduce(worst.growth, maxOp<scalar>());
    const bool mine = isRankOfLargest(worst.growth, growth);
    return
    {
        growth,
        valueOfRank(mine, worst.position),
        valueOfRank(mine, worst.voidFraction),
        {
            valueOfRank(mine, worst.step.displaced),
            valueOfRank(mine, worst.step.viscous),
            valueOfRank(mine, worst.step.engine_steps)
        }
    };
}


Foam::label Foam::viscousWaves::stableEngineSteps(const Steps& cells, const label engineSteps)
{
    // Down to 1, by less than a tenth where they are many
    for (label steps = engineSteps - 1; steps > 0; steps = label(0.95*steps))
    {
        const scalar share = scalar(steps)/engineSteps;
        const bool grow = std::any_of(cells.begin(), cells.end(), [&](const drag::ViscousStep& there)
        {
            return drag::viscous_waves_grow(drag::shortened(there, share, steps));
        });
        if (!returnReduce(grow, orOp<bool>()))
        {
            return steps;
        }
    }
    return 0;
}


std::string Foam::viscousWaves::cure(const Steps& cells, const label engineSteps) const
{
    const scalar deltaT = mesh_.time().deltaTValue();
    const label steps = stableEngineSteps(cells, engineSteps);
    if (!steps)
    {
        return cureByShorterSteps(cells, engineSteps, deltaT);
    }
    std::ostringstream words;
    words.precision(12);
    words<< "a deltaT of " << steps*deltaT/engineSteps << " s, " << steps
        << " steps of the particles as they are, or larger cells";
    return words.str();
}


std::string Foam::viscousWaves::cureByShorterSteps
(
    const Steps& cells,
    const label engineSteps,
    const scalar deltaT
)
{
    scalar needed = engineSteps;
    for (const drag::ViscousStep& there : cells)
    {
        needed = max(needed, drag::engine_steps_needed(there.displaced));
    }
    reduce(needed, maxOp<scalar>());
    if (!std::isfinite(needed))
    {
        return "no deltaT does: somewhere kappa is 2 or more";
    }
    scalar share = 1;
    for (drag::ViscousStep there : cells)
    {
        there.engine_steps = needed;
        share = min(share, drag::longest_viscous_step(there));
    }
    reduce(share, minOp<scalar>());
    const scalar particleStep = threeDigitsUpTo(share*deltaT/needed);
    std::ostringstream words;
    words.precision(12);
    words<< "a deltaT of " << needed*particleStep << " s in " << needed << " steps of the particles, of "
        << particleStep << " s each, or larger cells";
    return words.str();
}


void Foam::viscousWaves::warn(const Worst& worst, const Steps& cells)
{
    const std::string other = cure(cells, label(worst.step.engine_steps));
    WarningOnceInFunction(warning_)
        << "in form A, where particles are so light beside the gas and its viscosity reaches over cells"
        << " within its step, waves of particles that are free to move would grow by a factor of "
        << worst.growth << " in a gas step, drag apart, which damps them; particles that touch others hold"
        << " them back. Fastest in the cell at " << worst.position << ": eps = " << worst.voidFraction
        << ", kappa = (1 - eps) rho_g/(eps rho_s) = " << worst.step.displaced
        << ", M = nu deltaT k^2 = " << worst.step.viscous << ", " << worst.step.engine_steps
        << " steps of the particles in a deltaT. 'form B;' in"
        << " constant/couplingProperties cures it, or, with void fractions and viscosity as they are now, "
        << other.c_str() << "; printed once" << endl;
}
