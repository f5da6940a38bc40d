//! The order in which points and planes are placed, each by incidences with those before it.

use std::collections::VecDeque;

use super::{NoExactMesh, Obstacle};
use crate::mesh::{FaceId, Topology, VertexId};

/// Which vertex must lie in which face. Nodes are vertices, then faces; faces with three corners ask for
/// nothing and have no neighbours.
pub(super) struct Incidence {
    neighbours: Vec<Vec<usize>>,
    vertices: usize,
}

/// Points or planes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Lead {
    /// Planes follow: each is placed when three of its points are.
    Points,
    /// Points follow: each is placed when three of its planes are, or all.
    Planes,
}

/// A node with those before it that it must be incident with: at most three.
#[derive(Clone, Debug)]
pub(super) struct Placement {
    pub node: usize,
    pub on: Vec<usize>,
}

impl Incidence {
    pub fn new(topology: &Topology) -> Self {
        let vertices = topology.vertex_count();
        let mut neighbours = vec![Vec::new(); vertices + topology.face_count()];
        for f in topology.faces().filter(|&f| topology.face(f).len() > 3) {
            let node = vertices + f.index();
            for v in topology.face(f) {
                neighbours[v.index()].push(node);
                neighbours[node].push(v.index());
            }
        }
        Incidence { neighbours, vertices }
    }

    /// The faces with more than three corners at a vertex.
    pub fn faces_at(&self, v: VertexId) -> impl Iterator<Item = usize> + '_ {
        self.neighbours[v.index()].iter().map(|face| face - self.vertices)
    }

    /// The unknowns and the conditions of the linear system in which these lead: what is incident with
    /// n of them has n − 3 conditions.
    pub fn linear(&self, lead: Lead) -> (usize, usize) {
        let (points, planes) = self.neighbours.split_at(self.vertices);
        let conditions = |nodes: &[Vec<usize>]| -> usize {
            nodes.iter().map(|n| n.len().saturating_sub(3)).sum()
        };
        match lead {
            Lead::Points => (points.len(), conditions(planes)),
            Lead::Planes => (planes.iter().filter(|n| !n.is_empty()).count(), conditions(points)),
        }
    }

    /// The order that is the reverse of taking away nodes with at most three neighbours: those that
    /// follow at once, of the others those with fewest neighbours, from all sides at the same pace.
    ///
    /// The graph of a mesh of genus 0 is planar and bipartite, so that there always is one; in others it
    /// may fail.
    ///
    /// # Errors
    /// An element that is left.
    pub fn order(&self, lead: Lead) -> Result<Vec<Placement>, NoExactMesh> {
        let n = self.neighbours.len();
        let mut degrees: Vec<usize> = self.neighbours.iter().map(Vec::len).collect();
        let place = |node: usize, degree: usize| {
            let leads = (node < self.vertices) == (lead == Lead::Points);
            if leads { degree + 1 } else { 0 }
        };
        let mut queues: [VecDeque<usize>; 5] = Default::default();
        for (node, &degree) in degrees.iter().enumerate().filter(|(_, degree)| **degree <= 3) {
            queues[place(node, degree)].push_back(node);
        }
        let mut gone = vec![false; n];
        let mut order = Vec::with_capacity(n);
        let first =
            |queues: &mut [VecDeque<usize>; 5]| queues.iter_mut().find_map(VecDeque::pop_front);
        while let Some(node) = first(&mut queues) {
            if std::mem::replace(&mut gone[node], true) {
                continue;
            }
            let here = self.neighbours[node].iter().copied().filter(|&m| !gone[m]);
            let on: Vec<usize> = here.collect();
            for &m in &on {
                degrees[m] -= 1;
                if degrees[m] <= 3 {
                    queues[place(m, degrees[m])].push_back(m);
                }
            }
            order.push(Placement { node, on });
        }
        if let Some(node) = gone.iter().position(|gone| !gone) {
            return Err(self.at(node, Obstacle::Stuck));
        }
        order.reverse();
        Ok(order)
    }

    /// What is wrong at a node.
    pub fn at(&self, node: usize, obstacle: Obstacle) -> NoExactMesh {
        match node.checked_sub(self.vertices) {
            None => obstacle.at_vertex(VertexId(node as u32)),
            Some(face) => obstacle.at_face(FaceId(face as u32)),
        }
    }

    /// About how many bits the longest coordinate of a vertex will have, with parameters of `bits`.
    ///
    /// What is on one other node is a combination of the three that this one was placed by, or solves
    /// its equation; what is on two or three solves theirs, whose coefficients are products of three.
    pub fn bits(&self, order: &[Placement], bits: u64) -> u64 {
        let n = self.neighbours.len();
        let (mut own, mut of_three) = (vec![None; n], vec![None; n]);
        let mut longest = 0;
        for Placement { node, on } in order {
            let solved = |m: &usize| own[*m].or(of_three[*m].map(|b: u64| b.saturating_mul(3)));
            let most = on.iter().filter_map(solved).max().unwrap_or(0);
            let found = match on[..] {
                [] => bits,
                [m] => of_three[m].or(own[m]).unwrap_or(0).saturating_add(bits),
                [_, _] => most.saturating_mul(2).saturating_add(bits),
                _ => {
                    of_three[*node] = on.iter().filter_map(|&m| own[m]).max();
                    most.saturating_mul(3)
                }
            };
            // The equation of a plane on three points is found only where it is asked for.
            if *node < self.vertices {
                longest = longest.max(found);
                own[*node] = Some(found);
            } else if on.len() < 3 {
                own[*node] = Some(found);
            }
        }
        longest
    }
}
