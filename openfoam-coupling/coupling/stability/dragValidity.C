// SPDX-License-Identifier: GPL-3.0-or-later
#include "dragValidity.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"

#include <sstream>


Foam::dragValidity::dragValidity(const exchangeModel& model)
:
    particleCriterion(true, 0),
    closure_(model.closure)
{}


void Foam::dragValidity::add(const particleInGas& particle)
{
    ++evaluations_;
    ++evaluationsOfStep_;
    if (!closure_.validity.contains(particle.voidFraction, particle.reynolds))
    {
        countOutside(particle.voidFraction, particle.reynolds);
    }
}


void Foam::dragValidity::countOutside(const scalar voidFraction, const scalar reynolds)
{
    ++outside_;
    ++worst_;
    lowestVoidFraction_ = min(lowestVoidFraction_, voidFraction);
    highestVoidFraction_ = max(highestVoidFraction_, voidFraction);
    highestReynolds_ = max(highestReynolds_, reynolds);
}


std::string Foam::dragValidity::range() const
{
    const cohesion::drag::Validity& validity = closure_.validity;
    std::ostringstream text;
    text<< "void fraction " << validity.lowest_void_fraction << " to "
        << validity.highest_void_fraction << " and Reynolds number up to "
        << validity.highest_reynolds;
    return text.str();
}


void Foam::dragValidity::warn(const scalar, const scalar)
{
    const label count = returnReduce(label(worst_), sumOp<label>());
    const label all = returnReduce(evaluationsOfStep_, sumOp<label>());
    const scalar lowest = returnReduce(lowestVoidFraction_, minOp<scalar>());
    const scalar highest = returnReduce(highestVoidFraction_, maxOp<scalar>());
    const scalar reynolds = returnReduce(highestReynolds_, maxOp<scalar>());
    WarningOnceInFunction(warning_)
        << "drag " << closure_.name.data() << " was fitted for " << range().c_str()
        << "; " << count << " of " << all << " particles are outside, at void fractions from "
        << lowest << " to " << highest << " and Reynolds numbers up to " << reynolds
        << ". The formula is used as it is. This warning is printed once; the end of the log has the count"
        << endl;
}


void Foam::dragValidity::clear()
{
    particleCriterion::clear();
    evaluationsOfStep_ = 0;
    lowestVoidFraction_ = GREAT;
    highestVoidFraction_ = -GREAT;
    highestReynolds_ = 0;
}


void Foam::dragValidity::report() const
{
    const scalar evaluations = returnReduce(evaluations_, sumOp<scalar>());
    const scalar outside = returnReduce(outside_, sumOp<scalar>());
    Info<< "Drag " << closure_.name.data() << ", fitted for " << range().c_str()
        << nl << "    evaluations  " << evaluations << nl
        << "    outside      " << outside << ", " << 100*outside/max(evaluations, scalar(1))
        << " %" << endl;
}
