//! Campaigns: what a case is, shards and their files, merging, failures.

use std::fs;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

use isogeo::campaign::{
    Campaign, Case, Failure, Instance, Merging, Parts, Property, Shard, ShardFile, Source,
    UnfitFile, holds, merge, properties, property,
};
use isogeo::claim::Seed;
use isogeo::scalar::{Rational, Ring};
use isogeo::space::{MoebiusTransformation, Motion, Scaling};
use isogeo::strategy;
use proptest::prelude::*;

fn law(id: &str, cases: u64) -> Campaign {
    Campaign { property: property(id).expect(id), seed: Seed::of(3), cases }
}

/// An empty folder of its own.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("campaigns").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder for the test");
    folder
}

/// Runs a shard in blocks of so many cases.
fn run(campaign: &Campaign, shard: Shard, folder: &std::path::Path, block: u64) {
    let mut file = ShardFile::open(folder, campaign, shard).expect("a file");
    while !file.left().is_empty() {
        let left = file.left();
        let block = left.start..left.end.min(left.start + block);
        file.append(campaign.tally(block, &|| false).expect("a tally")).expect("a line");
    }
}

fn merged(folder: &std::path::Path) -> Merging {
    merge(folder).expect("files that fit")
}

#[test]
fn all_properties_hold_on_some_cases() {
    for property in properties() {
        let cases = if matches!(property, Property::Claim(_)) { 4 } else { 16 };
        let campaign = Campaign { property, seed: Seed::of(11), cases };
        let tally = campaign.tally(0..cases, &|| false).expect("nobody stops it");
        assert_eq!(tally.failures, [], "{}", property.id());
        assert!(tally.cases() == cases, "{}", property.id());
    }
    let mut ids: Vec<&str> = properties().map(Property::id).collect();
    let count = ids.len();
    assert!(ids.iter().all(|id| property(id).is_some_and(|p| p.id() == *id)));
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), count, "two properties of one name");
}

#[test]
fn the_digest_does_not_depend_on_shards_and_blocks() {
    let campaign = law("double-dual", 103);
    let (one, eight) = (folder("one"), folder("eight"));
    run(&campaign, Shard::WHOLE, &one, 200);
    for number in [3, 8, 1, 2, 7, 5, 6, 4] {
        run(&campaign, Shard::new(number, 8).expect("a shard"), &eight, 5);
    }
    let (one, eight) = (merged(&one), merged(&eight));
    assert!(one.properties[0].is_complete() && eight.properties[0].is_complete());
    assert_eq!(one.digest, eight.digest);
    assert_eq!(one.properties[0].tally, eight.properties[0].tally);
    // Another seed, and one case more, have other digests.
    let other = Campaign { seed: Seed::of(4), ..campaign };
    let longer = Campaign { cases: 104, ..campaign };
    let digest = |c: &Campaign| c.tally(0..c.cases, &|| false).map(|tally| tally.digest);
    assert!(digest(&campaign) != digest(&other) && digest(&campaign) != digest(&longer));
}

#[test]
fn shards_cover_all_cases_once() {
    for (cases, count) in [(0, 3), (1, 8), (103, 8), (u64::MAX, 7)] {
        let ranges =
            (1..=count).map(|number| Shard::new(number, count).expect("a shard").range(cases));
        let end = ranges.fold(0, |next, range| {
            assert_eq!(range.start, next);
            range.end
        });
        assert_eq!(end, cases);
    }
    for text in ["", "1", "0/1", "2/1", "1/0", "-1/2", "1/2/3", "a/b"] {
        assert!(text.parse::<Shard>().is_err(), "{text}");
    }
}

#[test]
fn a_torn_line_is_dropped_and_the_rest_is_done_again() {
    let campaign = law("file-obj", 60);
    let (whole, torn) = (folder("whole"), folder("torn"));
    run(&campaign, Shard::WHOLE, &whole, 7);
    run(&campaign, Shard::WHOLE, &torn, 7);
    let path = torn.join("file-obj.1-of-1.jsonl");
    let text = fs::read(&path).expect("the file");
    let expected = merged(&whole).digest;
    // Cut anywhere: in the first line, at the end of a line, in the middle of one.
    let line = text.iter().position(|b| *b == b'\n').expect("a line");
    for cut in [0, line / 2, line, line + 1, text.len() / 2, text.len() - 1] {
        fs::write(&path, &text[..cut]).expect("a file");
        let found = merged(&torn);
        assert!(found.properties.iter().all(|p| !p.gaps.is_empty()), "{cut}: a gap is seen");
        assert_eq!(found.torn.len(), usize::from(cut > 0 && text[cut - 1] != b'\n'));
        run(&campaign, Shard::WHOLE, &torn, 11);
        assert!(merged(&torn).properties[0].is_complete());
        assert_eq!(merged(&torn).digest, expected, "cut at {cut}");
    }
}

#[test]
fn gaps_and_duplicates_are_found() {
    let campaign = law("broken-faces", 100);
    let folder = folder("gaps");
    for number in [1, 2, 4] {
        run(&campaign, Shard::new(number, 4).expect("a shard"), &folder, 10);
    }
    let found = merged(&folder);
    let gap = |found: &Merging| found.properties[0].gaps.iter().map(|r| (r.start, r.end)).collect();
    assert_eq!(gap(&found), vec![(50, 75)]);
    assert_eq!(found.properties[0].duplicates, []);
    // Half of the cases again, cut otherwise.
    run(&campaign, Shard::new(1, 2).expect("a shard"), &folder, 10);
    let found = merged(&folder);
    let total = found.properties[0].duplicates.iter().map(|r| r.end - r.start).sum::<u64>();
    assert_eq!((gap(&found), total), (vec![(50, 75)], 50));
}

#[test]
fn files_of_other_campaigns_are_not_touched() {
    let campaign = law("broken-faces", 20);
    let folder = folder("other");
    run(&campaign, Shard::WHOLE, &folder, 10);
    let path = folder.join("broken-faces.1-of-1.jsonl");
    let before = fs::read(&path).expect("the file");
    for other in [Campaign { seed: Seed::of(9), ..campaign }, Campaign { cases: 21, ..campaign }] {
        let refused = ShardFile::open(&folder, &other, Shard::WHOLE);
        assert!(matches!(refused, Err(UnfitFile::Other(..))), "{refused:?}");
    }
    let open = ShardFile::open(&folder, &campaign, Shard::WHOLE).expect("the file");
    let twice = ShardFile::open(&folder, &campaign, Shard::WHOLE);
    assert!(matches!(twice, Err(UnfitFile::Busy(_))), "{twice:?}");
    drop(open);
    assert_eq!(fs::read(&path).expect("the file"), before);
    // A line of something else, and a block twice.
    let lines: Vec<&[u8]> = before.split_inclusive(|b| *b == b'\n').collect();
    for wrong in [[lines[0], b"{}\n"].concat(), [lines[0], lines[1], lines[1]].concat()] {
        fs::write(&path, &wrong).expect("a file");
        let refused = ShardFile::open(&folder, &campaign, Shard::WHOLE);
        assert!(matches!(refused, Err(UnfitFile::Line(..))), "{refused:?}");
    }
    // Two campaigns in one folder do not add up.
    fs::write(&path, &before).expect("a file");
    let other = Campaign { seed: Seed::of(9), ..campaign };
    run(&other, Shard::new(1, 2).expect("a shard"), &folder, 10);
    assert!(matches!(merge(&folder), Err(UnfitFile::Other(_, "seed"))));
}

#[test]
fn a_stopped_block_leaves_nothing() {
    let asked = AtomicUsize::new(0);
    let stop = || asked.fetch_add(1, Ordering::Relaxed) > 2;
    assert_eq!(law("broken-faces", 1000).tally(0..1000, &stop), None);
}

#[test]
fn a_failing_control_is_made_small_and_plays_again() {
    for id in ["control-meshes-are-planar", "control-thm-1-v"] {
        let campaign = law(id, 40);
        let tally = campaign.tally(0..40, &|| false).expect("a tally");
        let (index, what) = tally.failures.first().expect("a counterexample");
        let case: Case = format!("{id}:3:{index}").parse().expect("a case");
        let drawn = case.failure(false).expect("it fails");
        assert_eq!(&drawn.what, what);
        let small = case.failure(true).expect("it fails");
        assert_eq!(small.parts.meshes[0].topology.face_count(), 1, "{id}");
        let back = Failure::from_json(&small.to_json().to_string()).expect("a case");
        assert_eq!(back.parts, small.parts);
        assert!(holds(&small.to_json().to_string()).is_err());
        let test = small.rust_test();
        assert!(
            test.starts_with("#[test]\nfn control_")
                && test.contains("isogeo::campaign::holds(case)")
        );
        // A mesh on which it holds makes the test pass.
        let mut flat = small.clone();
        for point in &mut flat.parts.meshes[0].points {
            *point = point.top_view().at_height(Rational::from_i64(0));
        }
        // The lift of a flat kite is as little planar as that of another one.
        let flat = holds(&flat.to_json().to_string());
        assert_eq!(flat.is_ok(), id == "control-meshes-are-planar", "{flat:?}");
    }
    for text in ["control-thm-1-v:3", "nothing:1:1", "boxes:x:1", "boxes:1:x", "boxes:1:1:1"] {
        assert!(text.parse::<Case>().is_err(), "{text}");
    }
    let sound: Case = "double-dual:3:0".parse().expect("a case");
    assert!(sound.failure(true).is_none());
}

/// What is put apart comes together again.
fn comes_back<T: Instance + PartialEq + std::fmt::Debug>(value: &T) -> Result<(), TestCaseError> {
    let mut parts = Parts::default();
    value.put(&mut parts);
    let back = T::take(&mut Source::from(parts));
    prop_assert_eq!(back.as_ref(), Some(value));
    prop_assert!(T::take(&mut Source::from(Parts::default())).is_none());
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn instances_are_made_again_from_their_parts(
        pair in strategy::f_parallel::<Rational>(), broken in strategy::broken(),
        maps in (strategy::motion(), strategy::scaling(), strategy::moebius()), laguerre in strategy::laguerre(),
        mesh in strategy::koebe::<Rational>(), words in (any::<u32>(), any::<u8>(), any::<bool>()),
    ) {
        let maps: (Motion<Rational>, Scaling<Rational>, MoebiusTransformation<Rational>) = maps;
        comes_back(&pair)?;
        comes_back(&broken)?;
        comes_back(&maps)?;
        comes_back(&laguerre)?;
        comes_back(&(mesh, words))?;
    }
}
