"""Reads files with other people's readers and compares them with what was meant.

Usage: read_back.py FOLDER

FOLDER holds the files and expected.json, a list of {file, points, cells, markers, blocks}. Prints one line per file and reader,
beginning with "ok", "skipped" (the reader is not installed) or "FAILED"; the exit code is 1 after a failure.

meshio, vtk and gmsh come from the package index. Where they have no reader, a few lines of Python below read the file.
"""

import importlib
import json
import math
import pathlib
import re
import sys

KINDS = {"point": "vertex", "vertex": "vertex", "line": "segment", "triangle": "triangle", "quad": "quad",
         "tetra": "tetrahedron", "pyramid": "pyramid", "wedge": "wedge", "hexahedron": "hexahedron"}
VTK_KINDS = {1: "vertex", 3: "segment", 5: "triangle", 9: "quad", 10: "tetrahedron", 12: "hexahedron", 13: "wedge",
             14: "pyramid"}
GMSH_KINDS = {15: "vertex", 1: "segment", 2: "triangle", 3: "quad", 4: "tetrahedron", 5: "hexahedron", 6: "wedge",
              7: "pyramid"}


def with_meshio(path, expected):
    meshio = importlib.import_module("meshio")
    formats = {".node": "tetgen", ".ele": "tetgen"}
    mesh = meshio.read(path, file_format=formats.get(path.suffix))
    points = [[*map(float, p)] + [0.0] * (3 - len(p)) for p in mesh.points]
    cells = [[KINDS[b.type], [int(c) for c in cell]] for b in mesh.cells for cell in b.data]
    # meshio turns the wedges of VTK round, so they come out like those of Gmsh.
    names = [n for n in ("marker", "gmsh:physical", "medit:ref") if n in mesh.cell_data]
    markers = [int(m) for block in mesh.cell_data[names[0]] for m in block] if names else None
    return points, cells, markers


def with_vtk(path, expected):
    vtk = importlib.import_module("vtk")
    if path.suffix in (".vtu", ".vtk"):
        reader = vtk.vtkXMLUnstructuredGridReader() if path.suffix == ".vtu" else vtk.vtkUnstructuredGridReader()
        reader.SetFileName(str(path))
        reader.Update()
        grid = reader.GetOutput()
        points = [list(grid.GetPoint(i)) for i in range(grid.GetNumberOfPoints())]
        cells = []
        for i in range(grid.GetNumberOfCells()):
            cell = grid.GetCell(i)
            ids = [cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())]
            if VTK_KINDS[cell.GetCellType()] == "wedge":
                ids = [ids[k] for k in (0, 2, 1, 3, 5, 4)]
            cells.append([VTK_KINDS[cell.GetCellType()], ids])
        marker = grid.GetCellData().GetArray("marker")
        markers = None if marker is None else [int(marker.GetValue(i)) for i in range(len(cells))]
        return points, cells, markers
    reader = vtk.vtkMultiBlockPLOT3DReader()
    reader.SetXYZFileName(str(path))
    binary = path.suffix == ".p3b"
    reader.SetBinaryFile(binary)
    reader.MultiGridOn()
    reader.HasByteCountOff()
    reader.IBlankingOff()
    reader.SetTwoDimensionalGeometry(all(z == 0 for b in expected["blocks"] for _, _, z in b["points"]))
    if binary:
        reader.SetByteOrderToLittleEndian()
        reader.DoublePrecisionOn()
    reader.DoublePrecisionOn()
    reader.Update()
    output = reader.GetOutput()
    blocks = []
    for b in range(output.GetNumberOfBlocks()):
        grid = output.GetBlock(b)
        counts = [0, 0, 0]
        grid.GetDimensions(counts)
        ni, nj, _ = counts
        points = [list(grid.GetPoint(i)) for i in range(grid.GetNumberOfPoints())]
        blocks.append({"ni": ni, "nj": nj, "points": points})
    return blocks


def with_gmsh(path, expected):
    gmsh = importlib.import_module("gmsh")
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 2)
    gmsh.open(str(path))
    tags, flat, _ = gmsh.model.mesh.getNodes()
    order = sorted(range(len(tags)), key=lambda k: tags[k])
    points = [[float(x) for x in flat[3 * k:3 * k + 3]] for k in order]
    index = {int(tags[k]): i for i, k in enumerate(order)}
    cells = []
    for dimension, entity in gmsh.model.getEntities():
        physical = list(gmsh.model.getPhysicalGroupsForEntity(dimension, entity))
        for kind, elements, nodes in zip(*gmsh.model.mesh.getElements(dimension, entity)):
            size = len(nodes) // len(elements)
            for e, element in enumerate(elements):
                corners = [index[int(n)] for n in nodes[size * e:size * e + size]]
                # What Medit calls references are entities in Gmsh.
                marker = entity if path.suffix == ".mesh" else int(physical[0]) if physical else 0
                cells.append((int(element), [GMSH_KINDS[kind], corners], marker))
    gmsh.finalize()
    cells.sort()
    return points, [cell for _, cell, _ in cells], [marker for _, _, marker in cells]


def words(path):
    lines = (line.split("#")[0].split() for line in path.read_text().splitlines())
    return [line for line in lines if line]


def by_hand_triangle(path, expected):
    """Triangle's three kinds of files, as its manual page describes them."""
    node = words(path if path.suffix == ".poly" else path.with_suffix(".node"))
    count, dimension, attributes, marked = map(int, node[0][:4])
    first = int(node[1][0])
    points = [[*map(float, line[1:1 + dimension])] + [0.0] * (3 - dimension) for line in node[1:1 + count]]
    if path.suffix == ".poly":
        head, *rest = node[1 + count:]
        kind, lines, width = "segment", rest[:int(head[0])], 2
        markers = [int(line[3]) for line in lines] if int(head[1]) else None
    else:
        head, *lines = words(path)
        width = int(head[1])
        kind = {3: "triangle", 4: "tetrahedron"}[width]
        markers = [int(float(line[1 + width])) for line in lines] if int(head[2]) else None
    return points, [[kind, [int(w) - first for w in line[1:1 + width]]] for line in lines], markers


def by_hand_text(path, expected):
    points = [[float(w) for w in re.split(r"[\s,]+", line.strip())] for line in path.read_text().splitlines() if line]
    return [p + [0.0] * (3 - len(p)) for p in points], [], None


def parsed_dictionary(text):
    """OpenFOAM's dictionary syntax as nested lists and dictionaries."""
    text = re.sub(r"/\*.*?\*/|//[^\n]*", " ", text, flags=re.S)
    tokens = re.findall(r"[(){};]|[^\s(){};]+", text)
    position = 0

    def group(end):
        nonlocal position
        items = []
        while position < len(tokens) and tokens[position] != end:
            token = tokens[position]
            position += 1
            if token == "(":
                items.append(group(")"))
            elif token == "{":
                items.append(entries(group("}")))
            else:
                items.append(token)
        position += 1
        return items

    def entries(items):
        found, entry = {}, []
        for item in items:
            if item == ";":
                found[entry[0]] = entry[1:]
                entry = []
            elif isinstance(item, dict):
                found[entry[-1]] = item
                entry = []
            else:
                entry.append(item)
        return found

    return entries(group(None))


def by_hand_block_mesh_dict(path, expected):
    """Corners, cell counts, curved edges and patches of every block; hexahedra must be right-handed."""
    parsed = parsed_dictionary(path.read_text())
    scale = float((parsed.get("convertToMeters") or parsed.get("scale") or ["1"])[0])
    vertices = [[scale * float(x) for x in v] for v in parsed["vertices"][0]]
    lines = {}
    edges = iter(parsed["edges"][0])
    for _ in edges:
        a, b, inner = int(next(edges)), int(next(edges)), next(edges)
        lines[a, b] = [tuple(scale * float(x) for x in p) for p in inner]
        lines[b, a] = lines[a, b][::-1]
    items, hexes = parsed["blocks"][0], []
    for i, item in enumerate(items):
        if item == "hex":
            counts = next(x for x in items[i + 2:] if isinstance(x, list))
            hexes.append(([int(v) for v in items[i + 1]], [int(c) for c in counts]))
    cells = sum(c[0] * c[1] for _, c in hexes)
    assert cells == sum((b["ni"] - 1) * (b["nj"] - 1) for b in expected["blocks"]), f"{cells} cells"
    check_ends(hexes, vertices, lines)
    front = {frozenset(h[:4]) for h, _ in hexes} | {frozenset(h[4:]) for h, _ in hexes}
    # Blocks whose curves have the same ends are cut in pieces.
    for corners, counts in hexes:
        check_block(corners, counts, piece_of(expected["blocks"], corners, vertices), vertices, lines)
    check_patches(parsed["boundary"][0], hexes, front)
    return None


def check_ends(hexes, vertices, lines):
    """Edges are named by their ends, so two edges of blocks with the same ends must be shared, and none may be closed."""
    owners = {}
    for h, _ in hexes:
        for level in (0, 4):
            for a in range(4):
                ends = frozenset((h[level + a], h[level + (a + 1) % 4]))
                assert len(ends) == 2, "an edge that ends where it starts"
                owners[ends] = owners.get(ends, 0) + 1
    assert max(owners.values()) <= 2, "three blocks on one edge"
    assert all(frozenset(ends) in owners for ends in lines), "a polyLine that is no edge"
    for (a, b), inner in lines.items():
        level = {vertices[a][2], vertices[b][2]} | {x[2] for x in inner}
        assert len(level) == 1, "a polyLine that leaves its level"


def piece_of(blocks, corners, vertices):
    """The rectangle of nodes of a block between four corners."""
    wanted = {tuple(vertices[v][:2]) for v in corners[:4]}
    assert len(wanted) == 4, "corners in one place"
    for block in blocks:
        ni, at = block["ni"], {}
        for k, x in enumerate(block["points"]):
            if tuple(x[:2]) in wanted:
                at[tuple(x[:2])] = (k % ni, k // ni)
        if len(at) == 4:
            columns, rows = sorted({i for i, _ in at.values()}), sorted({j for _, j in at.values()})
            if len(columns) == 2 and len(rows) == 2:
                (i0, i1), (j0, j1) = columns, rows
                points = [block["points"][j * ni + i] for j in range(j0, j1 + 1) for i in range(i0, i1 + 1)]
                return {"ni": i1 - i0 + 1, "nj": j1 - j0 + 1, "points": points}
    raise AssertionError("a block whose corners are those of none")


def check_block(corners, counts, block, vertices, lines):
    p = [vertices[v] for v in corners]
    ni, nj, nodes = block["ni"], block["nj"], [tuple(x[:2]) for x in block["points"]]
    row = lambda j: nodes[j * ni:(j + 1) * ni]
    column = lambda i: nodes[i::ni]
    sides = [row(0), column(ni - 1), row(nj - 1), column(0)]
    assert counts[2] == 1 and sorted(counts[:2]) == sorted([ni - 1, nj - 1]), f"counts {counts}"
    for level in (p[:4], p[4:]):
        assert len({x[2] for x in level}) == 1, "a level that is not flat"
    assert {tuple(x[:2]) for x in p[:4]} == {nodes[0], nodes[ni - 1], nodes[-1], nodes[-ni]}, "other corners"
    u, v, w = ([b - a for a, b in zip(p[0], p[k])] for k in (1, 3, 4))
    # A concave corner may turn the other way, so the whole outline decides.
    outline = []
    for a in range(4):
        for level in (0, 4):
            v0, v1 = corners[level + a], corners[level + (a + 1) % 4]
            inner = [x[:2] for x in lines.get((v0, v1), [])]
            whole = [tuple(vertices[v0][:2])] + [tuple(x) for x in inner] + [tuple(vertices[v1][:2])]
            same = [s for s in sides if {s[0], s[-1]} == {whole[0], whole[-1]}]
            assert same, "an edge that is no side"
            straight = len(inner) == 0
            assert straight or whole in same or whole[::-1] in same, "an edge through other nodes"
            steps = counts[a % 2]
            assert straight or len(inner) == steps - 1, f"{len(inner)} nodes inside an edge of {steps} cells"
            if level == 0:
                outline += whole[:-1]
    area = sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(outline, outline[1:] + outline[:1]))
    assert area * w[2] > 0, "a left-handed block"


def check_patches(boundary, hexes, front):
    quads = {}
    for h, _ in hexes:
        for a in range(4):
            b = (a + 1) % 4
            quads.setdefault(frozenset((h[a], h[b], h[4 + a], h[4 + b])), []).append(h)
    outer = {q for q, owners in quads.items() if len(owners) == 1}
    named, patch_of = set(), {}
    for name, patch in zip(boundary[::2], boundary[1::2]):
        for face in patch["faces"][0]:
            face = frozenset(int(v) for v in face)
            assert face in outer or face in front, f"patch {name} has a face of no block"
            assert face not in named, f"patch {name} has a face twice"
            named.add(face)
        patch_of[name] = patch
        if patch["type"] == ["cyclic"]:
            assert patch["neighbourPatch"][0] in boundary[::2], f"{name} has no neighbour"
            other = next(p for n, p in zip(boundary[::2], boundary[1::2]) if n == patch["neighbourPatch"][0])
            assert other["neighbourPatch"] == [name], f"{name} and its neighbour do not agree"
            assert len(other["faces"][0]) == len(patch["faces"][0]), f"{name} and its neighbour differ in size"
    assert patch_of["frontAndBack"]["type"] == ["empty"]
    assert front <= named, "a front or back face without a patch"
    assert outer <= named, f"{len(outer - named)} outer faces without a patch"


READERS = {
    ".vtu": [with_meshio, with_vtk],
    ".vtk": [with_meshio, with_vtk],
    ".msh": [with_meshio, with_gmsh],
    ".mesh": [with_meshio, with_gmsh],
    ".ply": [with_meshio],
    ".obj": [with_meshio],
    ".stl": [with_meshio],
    ".off": [with_meshio],
    ".ele": [with_meshio, by_hand_triangle],
    ".poly": [by_hand_triangle],
    ".xy": [by_hand_text],
    ".xyz": [by_hand_text],
    ".p3d": [with_vtk],
    ".p3b": [with_vtk],
    "blockMeshDict": [by_hand_block_mesh_dict],
}


def compare(reader, read, expected):
    """What differs, or None."""
    if isinstance(read, list):
        for found, meant in zip(read, expected["blocks"]):
            if (found["ni"], found["nj"]) != (meant["ni"], meant["nj"]) or not equal(found["points"], meant["points"]):
                return "a block differs"
        return None if len(read) == len(expected["blocks"]) else f"{len(read)} blocks"
    if read is None:
        return None
    points, cells, markers = read
    if not equal(points, expected["points"]):
        return f"points differ ({len(points)} read)"
    if reader is with_meshio and expected["file"].endswith(".msh"):
        # In an MSH cells are grouped by dimension, and meshio forgets the numbers that tell their order.
        expected = sorted_cells(expected["cells"], expected["markers"])
        cells, markers = sorted_cells(cells, markers).values()
    if cells != expected["cells"]:
        return f"cells differ: read {[c for c in cells if c not in expected['cells']] or cells}"
    if markers is not None and expected.get("markers") is not None and markers != expected["markers"]:
        return "markers differ"
    return None


def sorted_cells(cells, markers):
    pairs = sorted(zip(cells, markers))
    return {"cells": [cell for cell, _ in pairs], "markers": [marker for _, marker in pairs]}


def equal(found, meant):
    return len(found) == len(meant) and all(a == b and math.copysign(1, a + 0.0) == math.copysign(1, b + 0.0)
                                            for p, q in zip(found, meant) for a, b in zip(p, q))


def main(folder):
    failed = False
    for expected in json.loads((folder / "expected.json").read_text()):
        path = folder / expected["file"]
        for reader in READERS[path.suffix or path.name]:
            if reader.__name__ in expected.get("not", []):
                continue
            name = f"{expected['file']} {reader.__name__.replace('_', ' ')}"
            try:
                difference = compare(reader, reader(path, expected), expected)
            except ModuleNotFoundError as missing:
                print(f"skipped {name}: {missing}")
                continue
            except BaseException as error:
                difference = f"{type(error).__name__}: {error}"
            failed |= difference is not None
            print(f"ok {name}" if difference is None else f"FAILED {name}: {difference}")
    sys.exit(failed)


main(pathlib.Path(sys.argv[1]))
