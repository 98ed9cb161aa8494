// SPDX-License-Identifier: GPL-3.0-or-later
#include "diffusionSmoothing.H"

#include "fvm.H"
#include "gaussLaplacianScheme.H"
#include "zeroGradientFvPatchFields.H"

#include "coupling/input/readPositive.H"


Foam::diffusionSmoothing::diffusionSmoothing(const fvMesh& mesh, const dictionary& dict)
:
    mesh_(mesh),
    width_(dict.found("smoothingWidth") ? readPositive(dict, "smoothingWidth") : 0)
{
    if (!active())
    {
        return;
    }
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
    const dimensionedScalar diffusion("diffusion", dimArea, sqr(width_)/(2*steps));
    step_.reset
    (
        new fvScalarMatrix
        (
            fvm::Sp(dimensionedScalar("one", dimless, 1), smooth_())
          - fv::gaussLaplacianScheme<scalar, scalar>::fvmLaplacianUncorrected
            (
                surfaceScalarField("smoothingDiffusivity", diffusion*mesh.magSf()),
                mesh.nonOrthDeltaCoeffs(),
                smooth_()
            )
        )
    );
    // The diagonal includes what the faces of the boundary add; to the source they add nothing, as there is no flux.
    step_->diag() = step_->D();
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

    // fvMatrix::solve is not used: the mesh keeps a list of all solutions of a time step, writes it anew with
    // each, and for the dozens here that costs more than to solve them.
    const lduInterfaceFieldPtrsList interfaces(smooth_->boundaryField().scalarInterfaces());
    const autoPtr<lduMatrix::solver> solver
    (
        lduMatrix::solver::New
        (
            smooth_->name(),
            step_(),
            step_->boundaryCoeffs(),
            step_->internalCoeffs(),
            interfaces,
            controls
        )
    );
    scalarField& smooth = smooth_->primitiveFieldRef();
    smooth = field;
    for (label step = 0; step < steps; ++step)
    {
        const scalarField source(mesh_.V()*smooth);
        const solverPerformance solution(solver->solve(smooth, source));
        if (!solution.converged())
        {
            FatalErrorInFunction
                << "smoothing over smoothingWidth = " << width_ << " m has not converged: in "
                << solution.nIterations() << " iterations the residual fell from "
                << solution.initialResidual() << " to " << solution.finalResidual()
                << ", and solid volume and momentum would not be kept" << nl
                << "    In constant/couplingProperties take a smoothingWidth of a few cells or particle"
                << " diameters" << exit(FatalError);
        }
    }
    field.deepCopy(smooth);
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
