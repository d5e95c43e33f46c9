//! One mesh out of many blocks: nodes on shared sides become one point each, because the sides are connected and not because the nodes
//! are near each other.

use crate::blocks::{BlockSide, BlocksDefect, Connection, StructuredBlocks};
use crate::cell::{Cell, Cells};
use crate::mesh::Mesh;

impl StructuredBlocks {
    /// The blocks as a mesh of quads, block by block with `i` running fastest, and the block's position as cell marker.
    ///
    /// Nodes that meet through unshifted connections are one point; it stands where the first of them stands. Sides that meet
    /// through a shift stay apart. Points are numbered in the order in which they first appear. O(nodes α(nodes)).
    ///
    /// # Errors
    /// What [`StructuredBlocks::check`] answers.
    pub fn to_mesh(&self) -> Result<Mesh, BlocksDefect> {
        self.check()?;
        let first_node = self.first_nodes();
        let mut classes = self.node_classes(&first_node);
        let mut points = Vec::new();
        let mut point_of_node: Vec<u32> = Vec::with_capacity(classes.parent.len());
        for (node, &coordinates) in self
            .blocks
            .iter()
            .flat_map(|block| &block.points)
            .enumerate()
        {
            let root = classes.root(node);
            // The root is the smallest node of its class, so it has its number already.
            let point = if root == node {
                points.len() as u32
            } else {
                point_of_node[root]
            };
            if root == node {
                points.push(coordinates);
            }
            point_of_node.push(point);
        }
        let (cells, markers) = self.quads(&first_node, &point_of_node);
        Ok(Mesh {
            cell_markers: Some(markers),
            ..Mesh::new(points, cells)
        })
    }

    /// Position of every block's first node in the list of all nodes.
    fn first_nodes(&self) -> Vec<usize> {
        let counts = self.blocks.iter().map(|block| block.points.len());
        counts
            .scan(0, |next, count| {
                Some(std::mem::replace(next, *next + count))
            })
            .collect()
    }

    fn node_classes(&self, first_node: &[usize]) -> NodeClasses {
        let mut classes =
            NodeClasses::apart(self.blocks.iter().map(|block| block.points.len()).sum());
        for (block, &first) in self.blocks.iter().zip(first_node) {
            for here in BlockSide::ALL {
                let &Connection::Block {
                    block: other,
                    side,
                    reversed,
                    shift: [0.0, 0.0, 0.0],
                } = block.connection(here)
                else {
                    continue;
                };
                let (neighbour, there) = (&self.blocks[other], first_node[other]);
                let count = neighbour.node_count(side);
                let nodes: Vec<usize> = neighbour.nodes_along(side).collect();
                for (k, node) in block.nodes_along(here).enumerate() {
                    let met = if reversed { count - 1 - k } else { k };
                    classes.join(first + node, there + nodes[met]);
                }
            }
        }
        classes
    }

    fn quads(&self, first_node: &[usize], point_of_node: &[u32]) -> (Cells, Vec<i32>) {
        let (mut cells, mut markers) = (Cells::new(), Vec::new());
        for ((marker, block), &first) in (0..).zip(&self.blocks).zip(first_node) {
            for j in 1..block.nj {
                for i in 1..block.ni {
                    let corner = |i: usize, j: usize| point_of_node[first + j * block.ni + i];
                    cells.push(Cell::Quad([
                        corner(i - 1, j - 1),
                        corner(i, j - 1),
                        corner(i, j),
                        corner(i - 1, j),
                    ]));
                    markers.push(marker);
                }
            }
        }
        (cells, markers)
    }
}

/// Nodes in classes that only grow (union-find); the root of a class is its smallest node.
struct NodeClasses {
    parent: Vec<usize>,
}

impl NodeClasses {
    fn apart(count: usize) -> Self {
        Self {
            parent: (0..count).collect(),
        }
    }

    fn root(&mut self, mut node: usize) -> usize {
        while self.parent[node] != node {
            self.parent[node] = self.parent[self.parent[node]];
            node = self.parent[node];
        }
        node
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[a.max(b)] = a.min(b);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::StructuredBlock;

    fn patch() -> Connection {
        Connection::Patch("wall".into())
    }

    fn to(block: usize, side: BlockSide, reversed: bool, shift: [f64; 3]) -> Connection {
        Connection::Block {
            block,
            side,
            reversed,
            shift,
        }
    }

    fn grid(ni: usize, nj: usize, sides: [Connection; 4]) -> StructuredBlock {
        let points = (0..nj)
            .flat_map(|j| (0..ni).map(move |i| [i as f64, j as f64, 0.0]))
            .collect();
        StructuredBlock {
            name: "grid".into(),
            ni,
            nj,
            points,
            sides,
        }
    }

    /// A block of 3 by 2 nodes and one of 2 by 4 that share a curve, in opposite directions.
    fn pair() -> StructuredBlocks {
        let left = grid(
            3,
            2,
            [
                patch(),
                to(1, BlockSide::JMin, true, [0.0; 3]),
                patch(),
                patch(),
            ],
        );
        let right = grid(
            2,
            4,
            [
                patch(),
                patch(),
                to(0, BlockSide::IMax, true, [0.0; 3]),
                patch(),
            ],
        );
        StructuredBlocks {
            blocks: vec![left, right],
        }
    }

    #[test]
    fn connected_sides_share_their_points() {
        let mesh = pair().to_mesh().unwrap();
        assert_eq!((mesh.points.len(), mesh.cells.len()), (6 + 8 - 2, 2 + 3));
        assert_eq!(mesh.cells.iter().nth(2), Some(Cell::Quad([5, 2, 7, 6])));
        assert_eq!(mesh.cell_markers, Some(vec![0, 0, 1, 1, 1]));
        assert_eq!(mesh.check(), Ok(()));
    }

    #[test]
    fn a_ring_closes_on_itself_but_a_period_does_not() {
        let ring = |shift: [f64; 3]| {
            let sides = [
                to(0, BlockSide::IMax, false, shift),
                to(0, BlockSide::IMin, false, shift.map(|period| -period)),
                patch(),
                patch(),
            ];
            StructuredBlocks {
                blocks: vec![grid(4, 3, sides)],
            }
            .to_mesh()
            .unwrap()
            .points
            .len()
        };
        assert_eq!(ring([0.0; 3]), 9);
        assert_eq!(ring([3.0, 0.0, 0.0]), 12);
    }

    #[test]
    fn each_contradiction_is_named() {
        let defect = |spoil: fn(&mut StructuredBlocks)| {
            let mut blocks = pair();
            spoil(&mut blocks);
            blocks.to_mesh().unwrap_err()
        };
        insta::assert_snapshot!(defect(|blocks| blocks.blocks[0].nj = 1), @"block 0: 3 by 1 nodes, but a block needs at least 2 each way");
        insta::assert_snapshot!(defect(|blocks| blocks.blocks[0].ni = usize::MAX), @"block 0: 6 points for 18446744073709551615 by 2 nodes");
        insta::assert_snapshot!(defect(|blocks| blocks.blocks[1].points[3][1] = f64::INFINITY), @"block 1, point 3: y is inf, which is not a finite number");
        insta::assert_snapshot!(
            defect(|blocks| blocks.blocks[0].sides[1] = to(7, BlockSide::JMin, true, [0.0; 3])),
            @"block 0, side i_max: leads to block 7, but there are 2 blocks"
        );
        insta::assert_snapshot!(
            defect(|blocks| blocks.blocks[0].sides[1] = to(1, BlockSide::IMin, true, [0.0; 3])),
            @"block 0, side i_max: 2 nodes meet 4 nodes of block 1, side i_min"
        );
        insta::assert_snapshot!(
            defect(|blocks| blocks.blocks[1].sides[2] = to(0, BlockSide::IMax, false, [0.0; 3])),
            @"block 0, side i_max: leads to block 1, side j_min, which does not lead back"
        );
        insta::assert_snapshot!(
            defect(|blocks| blocks.blocks[1].sides[2] = to(0, BlockSide::IMax, true, [f64::NAN, 0.0, 0.0])),
            @"block 0, side i_max: leads to block 1, side j_min, which does not lead back"
        );
    }
}
