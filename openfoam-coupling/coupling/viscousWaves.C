// SPDX-License-Identifier: GPL-3.0-or-later
#include "viscousWaves.H"

#include "PstreamReduceOps.H"
#include "messageStream.H"
#include "surfaceFields.H"

#include <sstream>

using namespace cohesion;

namespace
{

// 1 itself is that of a wave that stays as it is.
constexpr double grows = 1 + 1e-6;


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
                sum[patch.patch().faceCells()[facei]] += patch[facei];
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
    const scalar solidVolume,
    const volScalarField& voidFraction,
    const volScalarField& nu,
    const label engineSteps
) const
{
    const scalar rho = density_.reference().value()*density_.ratio(celli);
    const scalar viscous = nu[celli]*largest_[celli]*mesh_.time().deltaTValue();
    return {solidVolume*rho/voidFraction[celli], viscous, scalar(engineSteps)};
}


bool Foam::viscousWaves::mayGrow
(
    const scalar lightest,
    const volScalarField& voidFraction,
    const volScalarField& nu
) const
{
    const scalar volumePerMass = returnReduce(lightest, maxOp<scalar>());
    bool may = false;
    forAll(largest_, celli)
    {
        const scalar solidVolume = (1 - voidFraction[celli])*volumePerMass;
        may = may || !drag::surely_no_viscous_waves(step(celli, solidVolume, voidFraction, nu, 1));
    }
    return returnReduce(may, orOp<bool>());
}


void Foam::viscousWaves::look
(
    const scalarField& solidVolume,
    const volScalarField& voidFraction,
    const volScalarField& nu,
    const label engineSteps
)
{
    Growth growth{grows, 1};
    forAll(solidVolume, celli)
    {
        const drag::ViscousStep there =
            step(celli, solidVolume[celli], voidFraction, nu, engineSteps);
        if (drag::surely_no_viscous_waves(there))
        {
            continue;
        }
        if (!drag::viscous_waves_below(there, growth.factor))
        {
            growth.factor = max(growth.factor, drag::viscous_growth(there));
        }
        if (!drag::viscous_waves_below(drag::shortened(there, growth.share), grows))
        {
            growth.share = min(growth.share, drag::longest_viscous_step(there));
        }
    }
    reduce(growth.factor, maxOp<scalar>());
    reduce(growth.share, minOp<scalar>());
    if (growth.factor > grows)
    {
        warn(growth);
        warned_ = true;
    }
}


void Foam::viscousWaves::warn(const Growth& growth)
{
    const scalar longest = growth.share*mesh_.time().deltaTValue();
    std::ostringstream cure;
    if (longest > 0)
    {
        cure<< "or larger cells, or a deltaT below " << longest << " s and as long steps of the particles, as"
            << " void fractions and viscosity are now";
    }
    else
    {
        cure<< "and no deltaT does: the particles displace too much mass of gas";
    }
    WarningInFunction
        << "in form A, where particles are so light beside the gas and its viscosity reaches over cells"
        << " within its step, waves of particles that are free to move would grow by a factor of "
        << growth.factor << " in a gas step, drag apart, which damps them; particles that touch others hold"
        << " them back. 'form B;' in constant/couplingProperties cures it, " << cure.str().c_str()
        << "; this is said once" << endl;
}
