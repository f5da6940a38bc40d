//! Elimination of a sparse matrix modulo one prime: the search for pivots, and its replay.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::modular::Modulus;

/// A row of classes, sorted by columns, without zeros.
pub(super) type Row = Vec<(u32, u64)>;

/// Where an equation (row) determines an unknown (column).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pivot {
    pub row: u32,
    pub column: u32,
}

/// An equation after elimination: `x[column] = −Σ aⱼ xⱼ`, the `xⱼ` free or of later pivots.
#[derive(Clone, Debug)]
pub(super) struct Equation {
    pub column: u32,
    pub rest: Row,
}

/// The solution for one free column set to 1 and the others to 0: the classes of the pivot
/// columns, in the order of `equations`.
pub(super) fn substitute(
    modulus: &Modulus,
    equations: &[Equation],
    columns: usize,
    free: u32,
) -> Vec<u64> {
    let mut x = vec![0; columns];
    x[free as usize] = modulus.class(1);
    for Equation { column, rest } in equations.iter().rev() {
        let terms = rest.iter().filter(|(c, _)| x[*c as usize] != 0);
        let sum =
            terms.fold(0, |sum, (c, a)| modulus.add(sum, modulus.multiply(*a, x[*c as usize])));
        x[*column as usize] = modulus.negate(sum);
    }
    equations.iter().map(|e| x[e.column as usize]).collect()
}

/// A matrix under elimination.
pub(super) struct Matrix {
    modulus: Modulus,
    /// The rows that are not used yet; used ones are empty.
    rows: Vec<Row>,
    /// The rows that may contain a column: none is missing, some may have lost it.
    holders: Vec<Vec<u32>>,
    /// How many rows contain a column.
    counts: Vec<u32>,
    agenda: Option<Agenda>,
}

/// Rows by length and columns by count, the smallest first and the oldest among equals. Entries
/// are not removed when they change; those that no longer hold are skipped.
#[derive(Default)]
struct Agenda {
    rows: BinaryHeap<Reverse<(u32, u64, u32)>>,
    columns: BinaryHeap<Reverse<(u32, u64, u32)>>,
    age: u64,
}

impl Agenda {
    fn note_row(&mut self, length: usize, row: u32) {
        self.age += 1;
        self.rows.push(Reverse((length as u32, self.age, row)));
    }

    fn note_column(&mut self, count: u32, column: u32) {
        self.age += 1;
        self.columns.push(Reverse((count, self.age, column)));
    }
}

impl Matrix {
    pub fn new(modulus: Modulus, columns: usize, rows: Vec<Row>) -> Self {
        let mut holders = vec![Vec::new(); columns];
        for (r, row) in rows.iter().enumerate() {
            row.iter().for_each(|(c, _)| holders[*c as usize].push(r as u32));
        }
        let counts = holders.iter().map(|h: &Vec<u32>| h.len() as u32).collect();
        Matrix { modulus, rows, holders, counts, agenda: None }
    }

    /// The pivots of a complete elimination, which are as many as the rank modulo the prime.
    ///
    /// A column that only one equation contains costs nothing; it is taken first, the oldest such
    /// column before younger ones, so that a patch is peeled from all its corners inwards and
    /// chains of dependence stay short. Otherwise the cheaper of two candidates: in the shortest
    /// row its rarest column, or for the rarest column its shortest row, by Markowitz' count
    /// `(row length − 1)(column count − 1)`.
    pub fn pivots(mut self) -> Vec<Pivot> {
        let mut agenda = Agenda::default();
        for (r, row) in self.rows.iter().enumerate() {
            agenda.note_row(row.len(), r as u32);
        }
        for (c, count) in self.counts.iter().enumerate() {
            agenda.note_column(*count, c as u32);
        }
        self.agenda = Some(agenda);
        let mut pivots = Vec::new();
        while let Some(pivot) = self.next_pivot()
            && self.eliminate(pivot).is_some()
        {
            pivots.push(pivot);
        }
        pivots
    }

    /// The equations that belong to given pivots; `None` where one of them is 0 modulo the prime.
    pub fn replay(mut self, pivots: &[Pivot]) -> Option<Vec<Equation>> {
        pivots.iter().map(|&pivot| self.eliminate(pivot)).collect()
    }

    fn next_pivot(&mut self) -> Option<Pivot> {
        let agenda = self.agenda.as_mut()?;
        let column = loop {
            let &Reverse((count, _, c)) = agenda.columns.peek()?;
            if count > 0 && self.counts[c as usize] == count {
                break c;
            }
            agenda.columns.pop();
        };
        let row = loop {
            let &Reverse((length, _, r)) = agenda.rows.peek()?;
            if length > 0 && self.rows[r as usize].len() == length as usize {
                break r;
            }
            agenda.rows.pop();
        };
        let holders = self.holders[column as usize].iter().copied();
        let by_column = holders
            .filter(|&r| position(&self.rows[r as usize], column).is_ok())
            .min_by_key(|&r| self.rows[r as usize].len())?;
        if self.counts[column as usize] == 1 {
            return Some(Pivot { row: by_column, column });
        }
        let entries = self.rows[row as usize].iter().map(|(c, _)| *c);
        let by_row = entries.min_by_key(|&c| self.counts[c as usize])?;
        let cost = |row: u32, column: u32| {
            let others = self.rows[row as usize].len() as u64 - 1;
            others * u64::from(self.counts[column as usize] - 1)
        };
        let (first, second) = ((by_column, column), (row, by_row));
        let (row, column) =
            if cost(first.0, first.1) <= cost(second.0, second.1) { first } else { second };
        Some(Pivot { row, column })
    }

    /// Takes the pivot row out, divides it by its pivot and clears the column in all other rows.
    fn eliminate(&mut self, Pivot { row, column }: Pivot) -> Option<Equation> {
        let m = self.modulus;
        let at = position(&self.rows[row as usize], column).ok()?;
        let mut rest = std::mem::take(&mut self.rows[row as usize]);
        for (c, _) in &rest {
            self.count(*c, false);
        }
        let inverse = m.inverse(rest.remove(at).1);
        for (_, a) in &mut rest {
            *a = m.multiply(*a, inverse);
        }
        for target in std::mem::take(&mut self.holders[column as usize]) {
            self.clear(target, column, &rest);
        }
        Some(Equation { column, rest })
    }

    /// Subtracts the multiple of `x[column] + rest` that clears `column` in a row.
    fn clear(&mut self, target: u32, column: u32, rest: &Row) {
        let m = self.modulus;
        let Ok(at) = position(&self.rows[target as usize], column) else { return };
        let mut old = std::mem::take(&mut self.rows[target as usize]);
        self.count(column, false);
        let factor = m.negate(old.remove(at).1);
        let mut new = Vec::with_capacity(old.len() + rest.len());
        let mut old = old.into_iter().peekable();
        for (c, a) in rest {
            while let Some(before) = old.next_if(|(o, _)| o < c) {
                new.push(before);
            }
            let product = m.multiply(factor, *a);
            match old.next_if(|(o, _)| o == c) {
                None => {
                    self.holders[*c as usize].push(target);
                    self.count(*c, true);
                    new.push((*c, product));
                }
                Some((_, b)) => match m.add(b, product) {
                    0 => self.count(*c, false),
                    sum => new.push((*c, sum)),
                },
            }
        }
        new.extend(old);
        if let Some(agenda) = &mut self.agenda {
            agenda.note_row(new.len(), target);
        }
        self.rows[target as usize] = new;
    }

    /// Notes that one row more, or one row fewer, contains the column.
    fn count(&mut self, column: u32, more: bool) {
        let count = &mut self.counts[column as usize];
        *count = if more { *count + 1 } else { *count - 1 };
        if let Some(agenda) = &mut self.agenda {
            agenda.note_column(*count, column);
        }
    }
}

fn position(row: &Row, column: u32) -> Result<usize, usize> {
    row.binary_search_by_key(&column, |(c, _)| *c)
}
