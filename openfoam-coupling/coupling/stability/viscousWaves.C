// SPDX-License-Identifier: GPL-3.0-or-later
#include "viscousWaves.H"

#include "PstreamReduceOps.H"
#include "cyclicPolyPatch.H"
#include "messageStream.H"
#include "surfaceFields.H"

#include "ofOneRank.H"

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace cohesion;

namespace
{

// 1 itself is that of a wave that stays as it is.
constexpr double grows = 1 + 1e-6;


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

} // End anonymous namespace


Foam::viscousWaves::viscousWaves(const fvMesh& mesh, const gasDensity& density)
:
    mesh_(mesh),
    density_(density),
    largest_(largestWaveNumbers(mesh))
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
    return {volumePerDensity*rho/voidFraction[celli], viscous, scalar(engineSteps)};
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


void Foam::viscousWaves::refuseNotFinite(const label celli, const drag::ViscousStep& step) const
{
    if (!drag::is_finite(step))
    {
        FatalErrorInFunction
            << "in the cell at " << mesh_.C()[celli] << " the mass of gas over that of particles is "
            << step.displaced << ", and nu deltaT k^2 of the gas " << step.viscous << ": both must be finite;"
            << " see the masses of the particles and the viscosity there" << exit(FatalError);
    }
}


void Foam::viscousWaves::look
(
    const scalarField& volumePerDensity,
    const volScalarField& voidFraction,
    const volScalarField& nu,
    const label engineSteps
)
{
    Worst worst{grows, vector::zero, 1, {0, 0, 1}};
    std::vector<drag::ViscousStep> cells;
    forAll(volumePerDensity, celli)
    {
        const drag::ViscousStep there =
            step(celli, volumePerDensity[celli], voidFraction, nu, engineSteps);
        refuseNotFinite(celli, there);
        if (drag::surely_no_viscous_waves(there))
        {
            continue;
        }
        cells.push_back(there);
        if (!drag::viscous_waves_below(there, worst.factor))
        {
            const scalar factor = drag::viscous_growth(there);
            if (factor > worst.factor)
            {
                worst = {factor, mesh_.C()[celli], voidFraction[celli], there};
            }
        }
    }
    shareWorst(worst);
    if (worst.factor > grows)
    {
        warn(worst, cells);
        warned_ = true;
    }
}


void Foam::viscousWaves::shareWorst(Worst& worst)
{
    const bool mine = hasLargest(worst.factor);
    ofOneRank(mine, worst.factor);
    ofOneRank(mine, worst.place);
    ofOneRank(mine, worst.voidFraction);
    ofOneRank(mine, worst.step.displaced);
    ofOneRank(mine, worst.step.viscous);
    ofOneRank(mine, worst.step.engine_steps);
}


Foam::label Foam::viscousWaves::fewerSteps
(
    const std::vector<drag::ViscousStep>& cells,
    const label engineSteps
)
{
    // Down to 1, by less than a tenth where they are many
    for (label steps = engineSteps - 1; steps > 0; steps = label(0.95*steps))
    {
        const scalar share = scalar(steps)/engineSteps;
        const bool grow = std::any_of(cells.begin(), cells.end(), [&](const drag::ViscousStep& there)
        {
            return !drag::viscous_waves_below(drag::shortened(there, share, steps), grows);
        });
        if (!returnReduce(grow, orOp<bool>()))
        {
            return steps;
        }
    }
    return 0;
}


std::string Foam::viscousWaves::cure
(
    const std::vector<drag::ViscousStep>& cells,
    const label engineSteps
) const
{
    const scalar deltaT = mesh_.time().deltaTValue();
    std::ostringstream words;
    words.precision(12);
    if (const label steps = fewerSteps(cells, engineSteps))
    {
        words<< "a deltaT of " << steps*deltaT/engineSteps << " s, " << steps
            << " steps of the particles as they are, or larger cells";
        return words.str();
    }

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
    // Three digits of it, so that what is printed is a whole multiple
    const scalar exactly = share*deltaT/needed;
    const scalar unit = std::pow(10.0, std::floor(std::log10(exactly)) - 2);
    const scalar particles = std::floor(exactly/unit*(1 + 1e-9))*unit;
    words<< "a deltaT of " << needed*particles << " s in " << needed << " steps of the particles, of "
        << particles << " s each, or larger cells";
    return words.str();
}


void Foam::viscousWaves::warn(const Worst& worst, const std::vector<drag::ViscousStep>& cells)
{
    const std::string other = cure(cells, label(worst.step.engine_steps));
    WarningInFunction
        << "in form A, where particles are so light beside the gas and its viscosity reaches over cells"
        << " within its step, waves of particles that are free to move would grow by a factor of "
        << worst.factor << " in a gas step, drag apart, which damps them; particles that touch others hold"
        << " them back. Fastest in the cell at " << worst.place << ": eps = " << worst.voidFraction
        << ", kappa = (1 - eps) rho_g/(eps rho_s) = " << worst.step.displaced
        << ", M = nu deltaT k^2 = " << worst.step.viscous << ", " << worst.step.engine_steps
        << " steps of the particles in a deltaT. 'form B;' in"
        << " constant/couplingProperties cures it, or, with void fractions and viscosity as they are now, "
        << other.c_str() << "; this is said once" << endl;
}
