# SPDX-License-Identifier: BSD-3-Clause
"""The box of the column case, 60 mm x 60 mm x 200 mm, in cells of other shapes, by OpenFOAM's own tools.

    skewed       blockMesh: hexahedra whose faces lean by up to 27 degrees, their corners pulled up and down
    tetrahedra   gmshToFoam: five or six to where a cube was, corners moved at random
    polyhedra    polyDualMesh of those: around each of their corners a cell, with warped faces
    refined      refineMesh: cubes beside cubes of half the size, with hanging corners

and, for gas alone or fixed spheres:

    perturbed    blockMesh: hexahedra whose inner corners are moved at random by up to 30 % of an edge in each direction
    cone         snappyHexMesh: cubes around a cone that stands on the floor, their corners pulled onto it"""

import itertools
import re

import numpy as np

SIZE = np.array([0.06, 0.06, 0.2])


def plain(case):
    case.run("blockMesh")


def skewed(case):
    """In z all corners on the middle of the box's sides are pulled up, and those in its middle down."""
    levels = []
    for z, pull in ((0, 0), (100, 9), (200, 0)):
        for y, x in itertools.product((0, 30, 60), repeat=2):
            lifted = {0: 0, 1: 1, 2: -1}[(x == 30) + (y == 30)]
            levels.append((x, y, z + pull * lifted))
    blocks, bottom, top, sides = [], [], [], []
    for k, j, i in itertools.product(range(2), repeat=3):
        at = i + 3 * j + 9 * k
        low = [at, at + 1, at + 4, at + 3]
        high = [v + 9 for v in low]
        blocks.append(f"hex ({' '.join(map(str, low + high))}) (2 2 6) simpleGrading (1 1 1)")
        if k == 0:
            bottom.append(low[::-1])
        else:
            top.append(high)
        for a, b, outside in ((0, 1, j == 0), (1, 2, i == 1), (2, 3, j == 1), (3, 0, i == 0)):
            if outside:
                sides.append([low[a], low[b], high[b], high[a]])

    def faces(quads):
        return " ".join("(" + " ".join(map(str, quad)) + ")" for quad in quads)

    block = case.folder / "system/blockMeshDict"
    corners = " ".join(f"({x} {y} {z})" for x, y, z in levels)
    block.write_text(block.read_text().split("// A column")[0] + f"""
scale 0.001;
vertices ({corners});
blocks ({' '.join(blocks)});
boundary
(
    bottom {{ type patch; faces ({faces(bottom)}); }}
    top {{ type patch; faces ({faces(top)}); }}
    sides {{ type wall; faces ({faces(sides)}); }}
);
""")
    case.run("blockMesh")


def tetrahedra(case, cells=(3, 3, 8)):
    """Each cuboid in six around its diagonal (Kuhn), inner corners moved by up to 15 % of their distance."""
    number = np.array(cells) + 1
    index = np.arange(number.prod()).reshape(number)
    nodes = np.array(list(itertools.product(*map(range, number))), float)
    inner = np.all((nodes > 0) & (nodes < cells), axis=1)
    nodes[inner] += 0.15 * np.random.default_rng(1).uniform(-1, 1, (inner.sum(), 3))
    nodes *= SIZE / cells
    tets = []
    for corner in itertools.product(*map(range, cells)):
        for order in itertools.permutations(range(3)):
            at = np.array(corner)
            path = [index[tuple(at)]]
            for axis in order:
                at[axis] += 1
                path.append(index[tuple(at)])
            a, b, c, d = nodes[path]
            if np.dot(np.cross(b - a, c - a), d - a) < 0:
                path[1], path[2] = path[2], path[1]
            tets.append(path)
    outside = []
    for tet in tets:
        for face in itertools.combinations(tet, 3):
            at = nodes[list(face)]
            for axis, end in itertools.product(range(3), (0, 1)):
                if np.allclose(at[:, axis], end * SIZE[axis], atol=1e-9):
                    outside.append((1 + end if axis == 2 else 3, face))
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "4", '2 1 "bottom"', '2 2 "top"',
             '2 3 "sides"', '3 4 "inside"', "$EndPhysicalNames", "$Nodes", len(nodes)]
    lines += [f"{n + 1} {x!r} {y!r} {z!r}" for n, (x, y, z) in enumerate(nodes.tolist())]
    lines += ["$EndNodes", "$Elements", len(outside) + len(tets)]
    elements = [(2, patch, face) for patch, face in outside] + [(4, 4, tet) for tet in tets]
    lines += [f"{n + 1} {kind} 2 {tag} {tag} {' '.join(str(v + 1) for v in of)}"
              for n, (kind, tag, of) in enumerate(elements)]
    lines.append("$EndElements")
    (case.folder / "box.msh").write_text("\n".join(map(str, lines)) + "\n")
    case.run("gmshToFoam", "box.msh")


def polyhedra(case):
    tetrahedra(case, (5, 5, 14))
    case.run("polyDualMesh", "60", "-overwrite")


def refined(case):
    case.run("blockMesh")
    heading = 'FoamFile {{ version 2.0; format ascii; class dictionary; object {0}; }}\n'
    (case.folder / "system/topoSetDict").write_text(heading.format("topoSetDict") + """
actions ( { name half; type cellSet; action new; source boxToCell; box (0 0 0.06) (0.04 0.04 0.14); } );
""")
    (case.folder / "system/refineMeshDict").write_text(heading.format("refineMeshDict") + """
set half;
coordinateSystem global;
globalCoeffs { tan1 (1 0 0); tan2 (0 1 0); }
directions (tan1 tan2 normal);
useHexTopology yes;
geometricCut no;
writeMesh no;
""")
    case.run("topoSet")
    case.run("refineMesh", "-overwrite", "-dict", "system/refineMeshDict")


MESHES = {"skewed": skewed, "tetrahedra": tetrahedra, "polyhedra": polyhedra, "refined": refined}


def set_cells(case, *cells):
    edit = case.folder / "system/blockMeshDict"
    edit.write_text(re.sub(r"\(\d+ \d+ \d+\)(\s+simpleGrading)", rf"({' '.join(map(str, cells))})\1", edit.read_text()))


def move_points(case, moved):
    """Replaces the corners of a mesh, an array [corner, axis], by those that moved() gives of it."""
    path = case.folder / "constant/polyMesh/points"
    head, rows, end = re.fullmatch(r"(.*?\n\d+\s*\n\(\n)(.*?)(\n\)\s.*)", path.read_text(), re.S).groups()
    points = moved(np.array(rows.replace("(", " ").replace(")", " ").split(), float).reshape(-1, 3))
    path.write_text(head + "\n".join(f"({x!r} {y!r} {z!r})" for x, y, z in points.tolist()) + end)


def perturbed(case, cells=(5, 5, 15), share=0.3):
    def moved(points):
        inner = np.all((points > 1e-9) & (points < SIZE - 1e-9), axis=1)
        points[inner] += share * SIZE / cells * np.random.default_rng(1).uniform(-1, 1, (inner.sum(), 3))
        return points

    set_cells(case, *cells)
    case.run("blockMesh")
    move_points(case, moved)


CONE = ((0.03, 0.03, 0), 0.022, 0.1)  # middle of its foot, radius there, height [m]


def cone(case):
    (x, y, z), radius, height = CONE
    set_cells(case, 6, 6, 20)
    (case.folder / "system/snappyHexMeshDict").write_text(f"""
FoamFile {{ version 2.0; format ascii; class dictionary; object snappyHexMeshDict; }}
castellatedMesh true;
snap true;
addLayers false;
geometry {{ cone {{ type searchableCone; point1 ({x} {y} {z - 0.02}); radius1 {radius * 1.2};
    innerRadius1 0; point2 ({x} {y} {z + height}); radius2 0; innerRadius2 0; }} }}
castellatedMeshControls
{{
    maxLocalCells 100000; maxGlobalCells 100000; minRefinementCells 0; maxLoadUnbalance 0.1; nCellsBetweenLevels 1;
    features (); refinementSurfaces {{ cone {{ level (0 0); patchInfo {{ type wall; }} }} }}
    resolveFeatureAngle 30; refinementRegions {{ }} locationInMesh (0.0021 0.0022 0.1512);
    allowFreeStandingZoneFaces true;
}}
snapControls
{{
    nSmoothPatch 3; tolerance 2; nSolveIter 30; nRelaxIter 5; nFeatureSnapIter 5;
    implicitFeatureSnap false; explicitFeatureSnap false; multiRegionFeatureSnap false;
}}
addLayersControls
{{
    relativeSizes true; layers {{ }} expansionRatio 1; finalLayerThickness 0.3; minThickness 0.1; nGrow 0;
    featureAngle 30; nRelaxIter 3; nSmoothSurfaceNormals 1; nSmoothNormals 3; nSmoothThickness 10;
    maxFaceThicknessRatio 0.5; maxThicknessToMedialRatio 0.3; minMedianAxisAngle 90; nBufferCellsNoExtrude 0;
    nLayerIter 50;
}}
meshQualityControls
{{
    maxNonOrtho 65; maxBoundarySkewness 20; maxInternalSkewness 4; maxConcave 80; minVol 1e-15; minTetQuality 1e-15;
    minArea -1; minTwist 0.02; minDeterminant 0.001; minFaceWeight 0.05; minVolRatio 0.01; minTriangleTwist -1;
    nSmoothScale 4; errorReduction 0.75;
}}
mergeTolerance 1e-6;
""")
    for name, row in (("U", "slip"), ("p", "fixedFluxPressure; value uniform 0"), ("voidFraction", "zeroGradient")):
        path = case.folder / "0.orig" / name
        path.write_text(path.read_text().replace("boundaryField\n{", f"boundaryField\n{{\n    cone {{ type {row}; }}"))
    case.run("blockMesh")
    case.run("snappyHexMesh", "-overwrite")
    # The snap moves corners on the box's sides by a hundredth of a cell.
    move_points(case, lambda points: np.where(points < 3e-4, 0, np.where(points > SIZE - 3e-4, SIZE, points)))


FIXED = {"perturbed": perturbed, "cone": cone}
# Of docs/verification/still_gas.csv
NAMES = {"skewed": "hexahedra that lean", "perturbed": "hexahedra with corners moved at random", "tetrahedra": "tetrahedra",
         "polyhedra": "polyhedra", "refined": "cubes with hanging corners", "cone": "snapped to a cone"}
