//! One choice at every vertex such that the choices at both ends of every edge fit.
//!
//! What no neighbour fits is struck out until nothing changes. Where a vertex has several choices
//! left, one is tried, vertex by vertex in breadth-first order, and taken back if another vertex has
//! none left then. So what is found fits, and where nothing is found nothing does. No more than
//! [`DEAD_ENDS`] choices are taken back, so that the cost is linear in the number of edges.

use std::collections::VecDeque;

/// How often a search takes a choice back before it gives up.
const DEAD_ENDS: usize = 64;

/// Choices at a vertex, or some of them: bits 0 to 3, and 4 to 7 for the same turned over.
pub(super) type Choices = u8;

/// An edge: its ends, and for each choice at either end those at the other that fit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Link {
    ends: [usize; 2],
    fits: [[Choices; 8]; 2],
}

impl Link {
    /// An edge at which the choices c and d fit, or with one of them turned over, where `fits` says so.
    pub fn new(ends: [usize; 2], fits: impl Fn(usize, usize, bool) -> bool) -> Self {
        let mut table = [[0; 8]; 2];
        for (c, d) in (0..64).map(|pair| (pair / 8, pair % 8)) {
            if fits(c % 4, d % 4, c / 4 != d / 4) {
                table[0][c] |= 1 << d;
                table[1][d] |= 1 << c;
            }
        }
        Link { ends, fits: table }
    }
}

/// What became of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Found {
    /// Choices that fit.
    Fitting,
    /// There are none, as is seen at this vertex.
    Nothing(usize),
    /// The search, which started from this vertex, was given up.
    Lost(usize),
}

/// The vertices of every component, breadth first from one with the fewest choices.
pub(super) fn components(choices: &[Choices], links: &[[usize; 2]]) -> Vec<Vec<usize>> {
    let mut near = vec![Vec::new(); choices.len()];
    for &[a, b] in links {
        near[a].push(b);
        near[b].push(a);
    }
    let mut starts: Vec<usize> = (0..choices.len()).filter(|&v| choices[v] != 0).collect();
    starts.sort_by_key(|&v| choices[v].count_ones());
    let mut seen = vec![false; choices.len()];
    let mut components = Vec::new();
    for start in starts {
        let (mut order, mut queue) = (Vec::new(), VecDeque::from([start]));
        while let Some(v) = queue.pop_front() {
            if !std::mem::replace(&mut seen[v], true) {
                order.push(v);
                queue.extend(near[v].iter().filter(|&&w| !seen[w]));
            }
        }
        if !order.is_empty() {
            components.push(order);
        }
    }
    components
}

/// What is left of the choices at all vertices.
#[derive(Debug)]
pub(super) struct Search {
    links: Vec<Link>,
    /// The links at each vertex, and which of their ends it is.
    around: Vec<Vec<(usize, usize)>>,
    left: Vec<Choices>,
    /// What there was before something was struck out.
    struck: Vec<(usize, Choices)>,
}

impl Search {
    /// All choices, and which of them fit.
    ///
    /// A choice and the same turned over are alike: both are there, or none.
    pub fn new(choices: Vec<Choices>, links: Vec<Link>) -> Self {
        let mut around = vec![Vec::new(); choices.len()];
        for (i, link) in links.iter().enumerate() {
            around[link.ends[0]].push((i, 0));
            around[link.ends[1]].push((i, 1));
        }
        Search { links, around, left: choices, struck: Vec::new() }
    }

    /// Searches one of the [`components`].
    pub fn run(&mut self, component: &[usize]) -> Found {
        let Some(&start) = component.first() else {
            return Found::Fitting;
        };
        let consistent = self.spread(component.to_vec());
        // All turned over at once fit as well.
        if let Err(v) = consistent.and_then(|()| self.narrow(start, self.left[start] & 0x0F)) {
            return Found::Nothing(v);
        }
        let (mut tried, mut from, mut dead_ends) = (Vec::new(), 0, 0);
        loop {
            let open = |&i: &usize| self.left[component[i]].count_ones() > 1;
            let Some(place) = (from..component.len()).find(open) else {
                return Found::Fitting;
            };
            tried.push((place, self.struck.len(), self.left[component[place]]));
            from = loop {
                let Some((place, struck, untried)) = tried.last_mut() else {
                    return Found::Nothing(start);
                };
                let (place, choice) = (*place, *untried & untried.wrapping_neg());
                *untried ^= choice;
                self.restore(*struck);
                if choice == 0 {
                    tried.pop();
                } else if self.narrow(component[place], choice).is_ok() {
                    break place + 1;
                } else if dead_ends == DEAD_ENDS {
                    return Found::Lost(start);
                } else {
                    dead_ends += 1;
                }
            };
        }
    }

    /// Leaves only these choices at a vertex, and elsewhere what fits them; or says where nothing does.
    fn narrow(&mut self, v: usize, choices: Choices) -> Result<(), usize> {
        self.struck.push((v, self.left[v]));
        self.left[v] = choices;
        self.spread(vec![v])
    }

    /// Strikes out what does not fit, from vertices whose choices have changed.
    fn spread(&mut self, mut changed: Vec<usize>) -> Result<(), usize> {
        while let Some(v) = changed.pop() {
            for &(link, end) in &self.around[v] {
                let Link { ends, fits } = &self.links[link];
                let own = fits[end].iter().enumerate().filter(|(c, _)| self.left[v] >> c & 1 == 1);
                let fitting = own.fold(0, |all, (_, fits)| all | fits);
                let w = ends[1 - end];
                let before = self.left[w];
                self.left[w] &= fitting;
                if self.left[w] != before {
                    self.struck.push((w, before));
                    changed.push(w);
                }
                if self.left[w] == 0 {
                    return Err(w);
                }
            }
        }
        Ok(())
    }

    fn restore(&mut self, struck: usize) {
        for (v, choices) in self.struck.drain(struck..).rev() {
            self.left[v] = choices;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(choices: &[Choices], links: &[Link]) -> Vec<Found> {
        let ends: Vec<_> = links.iter().map(|link| link.ends).collect();
        let mut search = Search::new(choices.to_vec(), links.to_vec());
        components(choices, &ends).iter().map(|c| search.run(c)).collect()
    }

    /// A cycle of edges that ask for the same choice, or one other; some also for a turn.
    fn cycle(n: usize, other: &[usize], turned: &[usize]) -> Vec<Link> {
        let link = |i: usize| {
            let (shift, turn) = (usize::from(other.contains(&i)), turned.contains(&i));
            Link::new([i, (i + 1) % n], move |c, d, t| (c + shift) % 2 == d && t == turn)
        };
        (0..n).map(link).collect()
    }

    #[test]
    fn signs_must_agree_around_a_cycle() {
        assert_eq!(found(&[0x11; 6], &cycle(6, &[], &[])), [Found::Fitting]);
        assert_eq!(found(&[0x11; 6], &cycle(6, &[], &[1, 4])), [Found::Fitting]);
        assert!(matches!(found(&[0x11; 6], &cycle(6, &[], &[1]))[..], [Found::Nothing(_)]));
    }

    /// Every edge is content by itself, and no choice is struck out, but there is none in common.
    #[test]
    fn edges_may_be_content_one_by_one() {
        assert_eq!(found(&[0x33; 5], &cycle(5, &[0, 3], &[])), [Found::Fitting]);
        assert_eq!(found(&[0x33; 5], &cycle(5, &[0], &[])), [Found::Nothing(0)]);
    }

    /// Vertices that must all differ.
    fn clique(vertices: [usize; 4]) -> impl Iterator<Item = Link> {
        let pairs = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
        let differ = |c: usize, d: usize, turned: bool| !turned && c != d;
        pairs.into_iter().map(move |(i, j)| Link::new([vertices[i], vertices[j]], differ))
    }

    /// With the first choice at 0 there are three for four vertices that differ.
    #[test]
    fn choices_are_taken_back() {
        let few = |c: usize, d: usize, turned: bool| !turned && (c == 1 || d < 3);
        let mut links: Vec<_> = (1..5).map(|v| Link::new([0, v], few)).collect();
        links.extend(clique([1, 2, 3, 4]));
        assert_eq!(found(&[0x33, 0xFF, 0xFF, 0xFF, 0xFF], &links), [Found::Fitting]);
        assert_eq!(found(&[0x11, 0xFF, 0xFF, 0xFF, 0xFF], &links), [Found::Nothing(0)]);
    }

    #[test]
    fn components_are_searched_by_themselves() {
        let links = [Link::new([0, 2], |_, _, _| true), Link::new([1, 3], |_, _, t| !t)];
        let choices = [0xFF, 0x33, 0x11, 0x33, 0];
        let ends: Vec<_> = links.iter().map(|link| link.ends).collect();
        assert_eq!(components(&choices, &ends), [vec![2, 0], vec![1, 3]]);
        assert_eq!(found(&choices, &links), [Found::Fitting; 2]);
    }

    /// What is wrong lies behind many choices that are not to blame.
    #[test]
    fn a_long_search_is_given_up() {
        let block = |i: usize| [1, 2, 3, 4].map(|j| 4 * i + j);
        let joined = (0..8).map(|i| Link::new([0, block(i)[0]], |_, _, turned| !turned));
        let links: Vec<_> = joined.chain((0..8).flat_map(|i| clique(block(i)))).collect();
        let mut choices = [0xFF; 33];
        choices[0] = 0x11;
        assert_eq!(found(&choices, &links), [Found::Fitting]);
        choices[29..].fill(0x77);
        assert_eq!(found(&choices, &links), [Found::Lost(0)]);
    }
}
