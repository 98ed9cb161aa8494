// SPDX-License-Identifier: GPL-3.0-or-later
#include "diffusionSmoothing.H"

#include "fvm.H"
#include "gaussLaplacianScheme.H"
#include "zeroGradientFvPatchFields.H"

#include "readPositive.H"


Foam::diffusionSmoothing::diffusionSmoothing(const fvMesh& mesh, const dictionary& dict)
:
    mesh_(mesh),
    width_(dict.found("smoothingWidth") ? readPositive(dict, "smoothingWidth") : 0)
{
    if (!active())
    {
        return;
    }
    const dimensionedScalar diffusion("diffusion", dimArea, sqr(width_)/(2*steps));
    diffusivity_.reset(new surfaceScalarField("smoothingDiffusivity", diffusion*mesh.magSf()));
    smooth_.reset
    (
        new volScalarField
        (
            IOobject("smooth", mesh.time().timeName(), mesh),
            mesh,
            dimensionedScalar(dimless, Zero),
            zeroGradientFvPatchScalarField::typeName
        )
    );
}


void Foam::diffusionSmoothing::operator()(UList<scalar>& field)
{
    if (!active())
    {
        return;
    }
    dictionary controls;
    controls.add("solver", word("PCG"));
    controls.add("preconditioner", word("DIC"));
    controls.add("tolerance", 1e-15);
    controls.add("relTol", 0);

    // A line in the log for each of the dozens of solutions would bury the gas's own.
    const int lines = solverPerformance::debug;
    solverPerformance::debug = 0;
    volScalarField& smooth = smooth_();
    smooth.primitiveFieldRef() = field;
    for (label step = 0; step < steps; ++step)
    {
        fvScalarMatrix equation
        (
            fvm::Sp(dimensionedScalar("one", dimless, 1), smooth)
          - fv::gaussLaplacianScheme<scalar, scalar>::fvmLaplacianUncorrected
            (
                diffusivity_(),
                mesh_.nonOrthDeltaCoeffs(),
                smooth
            )
        );
        equation.source() += mesh_.V()*smooth.primitiveField();
        const solverPerformance solution(equation.solve(controls));
        if (!solution.converged())
        {
            solverPerformance::debug = lines;
            FatalErrorInFunction
                << "smoothing over smoothingWidth = " << width_ << " m has not converged: in "
                << solution.nIterations() << " iterations the residual fell from "
                << solution.initialResidual() << " to " << solution.finalResidual()
                << ", and solid volume and momentum would not be kept" << nl
                << "    In constant/couplingProperties take a smoothingWidth of a few cells or particle"
                << " diameters" << exit(FatalError);
        }
    }
    solverPerformance::debug = lines;
    field.deepCopy(smooth.primitiveField());
}


void Foam::diffusionSmoothing::operator()(UList<vector>& field)
{
    if (!active())
    {
        return;
    }
    scalarField component(field.size());
    for (direction d = 0; d < 3; ++d)
    {
        if (mesh_.geometricD()[d] < 0)
        {
            continue;
        }
        forAll(field, celli)
        {
            component[celli] = field[celli][d];
        }
        operator()(component);
        forAll(field, celli)
        {
            field[celli][d] = component[celli];
        }
    }
}
