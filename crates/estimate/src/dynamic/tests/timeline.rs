//! Readings of several sensors that come in any order.

use super::*;

/// A cart with an input: position and speed.
fn cart() -> Continuous {
    let (a, q) = (dmatrix![0.0, 1.0; 0.0, -0.1], dmatrix![0.01, 0.0; 0.0, 0.2]);
    Continuous::new(a, dmatrix![0.0; 1.0], q).expect("sound")
}

fn start() -> Belief {
    belief_from(dvector![0.0, 1.0], DMatrix::identity(2, 2)).expect("sound")
}

/// A late one, a fast one, and one of both states with a gate.
fn sensors() -> Vec<Sensor> {
    let one =
        |name: &str, h: DMatrix<f64>, w: DMatrix<f64>, delay, gate| Sensor { name: name.into(), h, w, delay, gate };
    vec![
        one("fix", dmatrix![1.0, 0.0], dmatrix![0.04], 0.5, None),
        one("wheel", dmatrix![0.0, 1.0], dmatrix![0.25], 0.0, Some(4.0)),
        one("both", DMatrix::identity(2, 2), dmatrix![1.0, 0.1; 0.1, 0.5], -0.25, Some(6.0)),
    ]
}

fn line(window: f64) -> Timeline {
    let memory = Memory { window, capacity: 1000 };
    Timeline::new(cart(), &start(), 10.0, memory, sensors()).expect("sound")
}

/// An input (rank 0), or a reading of the sensor before this rank: the time at which it was measured, the order among
/// those of one time, and what is in it.
type Arrival = (f64, usize, u64, Vec<Option<f64>>);

fn tell(line: &mut Timeline, (time, rank, id, given): &Arrival) -> Placed {
    match rank {
        0 => line.input(*time, &[given[0].expect("an input is whole")]),
        _ => line.reading(&sensors()[rank - 1].name, time + sensors()[rank - 1].delay, given, *id),
    }
    .expect("finite")
}

/// A small generator (Knuth's MMIX), so that every run draws the same.
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % n
    }

    fn number(&mut self) -> f64 {
        self.below(4001) as f64 / 1000.0 - 2.0
    }
}

/// Events sorted by time, rank and id, on quarters of a second so that many have the same time.
fn events(dice: &mut Dice, count: usize) -> Vec<Arrival> {
    let mut all: Vec<Arrival> = Vec::new();
    while all.len() < count {
        let (time, rank) = (10.0 + 0.25 * dice.below(count) as f64, dice.below(4));
        let id = if rank == 0 { 0 } else { dice.below(3) as u64 };
        let mut given: Vec<_> = (0..if rank == 3 { 2 } else { 1 }).map(|_| Some(3.0 * dice.number())).collect();
        if rank == 3 && dice.below(3) == 0 {
            given[dice.below(2)] = None;
        }
        if all.iter().all(|(t, r, i, _)| (*t, *r, *i) != (time, rank, id)) {
            all.push((time, rank, id, given));
        }
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
    all
}

/// The sorted events by predictions and corrections alone.
fn filtered(sorted: &[Arrival]) -> (Belief, Vec<Outcome>) {
    let (system, mut belief, mut input, mut now) = (cart(), start(), dvector![0.0], 10.0);
    let mut outcomes = Vec::new();
    for (time, rank, _, given) in sorted {
        if *time > now {
            let Discrete { f, g, v } = system.discretize(time - now).expect("finite");
            belief.predict(&f, &v, Some((&g, &input))).expect("finite");
            now = *time;
        }
        outcomes.push(Outcome::Accepted);
        if *rank == 0 {
            input[0] = given[0].expect("whole");
            continue;
        }
        let Sensor { h, w, gate, .. } = &sensors()[rank - 1];
        let rows: Vec<usize> = (0..given.len()).filter(|i| given[*i].is_some()).collect();
        let y = DVector::from_vec(given.iter().flatten().copied().collect());
        let (h, w) = (h.select_rows(&rows), w.select_rows(&rows).select_columns(&rows));
        let (corrected, update) = belief.corrected(&y, &h, &w).expect("positive definite");
        if gate.is_none_or(|gate| update.d2.expect("regular") <= gate) {
            belief = corrected;
        } else {
            *outcomes.last_mut().expect("pushed") = Outcome::Rejected;
        }
    }
    (belief, outcomes)
}

#[test]
fn in_order_it_is_the_filter_to_the_last_bit() {
    let mut dice = Dice(3);
    let mut refused = 0;
    for _ in 0..30 {
        let sorted = events(&mut dice, 40);
        let mut line = line(1e3);
        let found: Vec<_> = sorted.iter().map(|event| tell(&mut line, event).outcome).collect();
        let (belief, outcomes) = filtered(&sorted);
        refused += outcomes.iter().filter(|outcome| **outcome == Outcome::Rejected).count();
        assert_eq!(found, outcomes);
        assert_eq!(line.at(line.newest()), Ok(belief));
    }
    assert!(refused > 50, "the gates are not tried: {refused}");
}

/// Everything that a time line holds is the same, and so is all it will ever answer.
#[test]
fn any_order_of_arrival_leaves_the_same_bits() {
    let mut dice = Dice(5);
    for _ in 0..100 {
        let sorted = events(&mut dice, 30);
        let mut in_order = line(1e3);
        sorted.iter().for_each(|event| drop(tell(&mut in_order, event)));
        let mut shuffled = sorted.clone();
        (1..shuffled.len()).for_each(|i| shuffled.swap(i, dice.below(i + 1)));
        let mut line = line(1e3);
        shuffled.iter().for_each(|event| drop(tell(&mut line, event)));
        assert_eq!(format!("{line:?}"), format!("{in_order:?}"));
        assert_eq!(line.at(line.newest()), Ok(filtered(&sorted).0));
    }
}

/// In a window of two seconds an event may come up to two seconds late; what is older is forgotten, to the same bits.
#[test]
fn a_window_forgets_nothing_that_counts() {
    let mut dice = Dice(7);
    for _ in 0..50 {
        let sorted = events(&mut dice, 60);
        let (mut in_order, mut late) = (line(2.0), line(2.0));
        sorted.iter().for_each(|event| drop(tell(&mut in_order, event)));
        let mut waiting = sorted.clone();
        while !waiting.is_empty() {
            let last = waiting.partition_point(|event| event.0 <= waiting[0].0 + 2.0);
            let event = waiting.remove(dice.below(last));
            assert!(matches!(tell(&mut late, &event).outcome, Outcome::Accepted | Outcome::Rejected), "{event:?}");
        }
        assert_eq!(format!("{late:?}"), format!("{in_order:?}"));
        assert_eq!(late.at(late.newest()), Ok(filtered(&sorted).0));
        assert!(late.len() < 60);
    }
}

#[test]
fn asking_changes_nothing_and_splits_no_step() {
    let mut dice = Dice(11);
    let sorted = events(&mut dice, 30);
    let (mut asked, mut left) = (line(3.0), line(3.0));
    for event in &sorted {
        for t in [event.0, event.0 - 0.1, event.0 + 7.7] {
            let before = format!("{asked:?}");
            let _ = asked.at(t);
            assert_eq!(format!("{asked:?}"), before);
        }
        assert_eq!(tell(&mut asked, event), tell(&mut left, event));
    }
    assert_eq!(format!("{asked:?}"), format!("{left:?}"));
    // Between two events, the belief of the first is predicted; after the last, that of the last.
    let (now, Discrete { f, g, v }) = (left.newest(), cart().discretize(0.125).expect("finite"));
    let input = sorted.iter().rev().find(|event| event.1 == 0).map_or(0.0, |event| event.3[0].expect("whole"));
    let known = left.at(now).expect("known");
    let predicted = known.predicted(&f, &v, Some((&g, &dvector![input]))).expect("finite");
    assert_eq!(left.at(now + 0.125), Ok(predicted));
}

#[test]
fn an_event_that_finds_no_place_says_why_and_changes_nothing() {
    let memory = Memory { window: 1.0, capacity: 3 };
    let mut line = Timeline::new(cart(), &start(), 0.0, memory, sensors()).expect("sound");
    let aside = |line: &mut Timeline, t: f64, id: u64, outcome: Outcome| {
        let before = format!("{line:?}");
        let placed = line.reading("wheel", t, &[Some(1.0)], id).expect("finite");
        assert_eq!(placed, Placed { outcome, judged: None });
        assert_eq!(format!("{line:?}"), before);
    };
    let placed = |line: &mut Timeline, t: f64, id: u64| {
        let answer = line.reading("wheel", t, &[Some(1.0)], id).expect("finite");
        assert_eq!((answer.outcome, answer.judged.is_some()), (Outcome::Accepted, true));
    };
    aside(&mut line, -1e-9, 0, Outcome::TooLate);
    aside(&mut line, 2e6, 0, Outcome::Ahead);
    placed(&mut line, 0.0, 0);
    aside(&mut line, 0.0, 0, Outcome::Duplicate);
    aside(&mut line, -0.0, 0, Outcome::Duplicate);
    placed(&mut line, 0.0, 1);
    placed(&mut line, 0.75, 0);
    aside(&mut line, 0.5, 0, Outcome::Full);
    (0..1000).for_each(|id| aside(&mut line, 1.0, id, Outcome::Full));
    // What is older than the window makes room.
    placed(&mut line, 1.5, 0);
    assert_eq!(line.len(), 2);
    aside(&mut line, 0.499, 0, Outcome::TooLate);
    placed(&mut line, 0.5, 0);
    assert_eq!(line.input(0.5, &[1.0]).map(|it| it.outcome), Ok(Outcome::Full));
    let before = line.at(-0.5).expect_err("before all");
    assert_eq!((before.code, before.argument.as_ref()), (Code::Limit, "t"));
    let mut free = self::line(1.0);
    assert_eq!(free.input(10.5, &[1.0]).map(|it| it.outcome), Ok(Outcome::Accepted));
    assert_eq!(free.input(10.5, &[2.0]).map(|it| it.outcome), Ok(Outcome::Duplicate));
}

#[test]
fn what_is_wrong_is_named_and_the_line_is_as_it_was() {
    let mut line = line(5.0);
    line.reading("fix", 14.5, &[Some(1.0)], 0).expect("finite");
    let before = format!("{line:?}");
    let mut refused = |call: &dyn Fn(&mut Timeline) -> Result<Placed, Error>, code: Code, argument: &str| {
        let error = call(&mut line).expect_err("refused");
        assert_eq!((error.code, error.argument.as_ref()), (code, argument));
        assert_eq!(format!("{line:?}"), before);
    };
    refused(&|line| line.input(f64::NAN, &[0.0]), Code::NotFinite, "t");
    refused(&|line| line.input(11.0, &[]), Code::Shape, "u");
    refused(&|line| line.input(11.0, &[f64::INFINITY]), Code::NotFinite, "u");
    // The input by itself has a place; over the four seconds to the reading it overflows.
    refused(&|line| line.input(10.0, &[1.7e308]), Code::NotFinite, "u");
    refused(&|line| line.reading("compass", 11.0, &[Some(0.0)], 0), Code::Index, "name");
    refused(&|line| line.reading("fix", f64::INFINITY, &[Some(0.0)], 0), Code::NotFinite, "t");
    refused(&|line| line.reading("fix", 11.0, &[], 0), Code::Shape, "y");
    refused(&|line| line.reading("fix", 11.0, &[None], 0), Code::Shape, "y");
    refused(&|line| line.reading("fix", 11.0, &[Some(f64::NAN)], 0), Code::NotFinite, "y");
    let made = |time: f64, memory: Memory, sensors: Vec<Sensor>| {
        let error = Timeline::new(cart(), &start(), time, memory, sensors).expect_err("refused");
        (error.code, error.argument.to_string())
    };
    let memory = |window: f64, capacity: usize| Memory { window, capacity };
    assert_eq!(made(f64::NAN, memory(1.0, 1), sensors()), (Code::NotFinite, "time".into()));
    assert_eq!(made(0.0, memory(0.0, 1), sensors()), (Code::Limit, "window".into()));
    assert_eq!(made(0.0, memory(1.0, 0), sensors()), (Code::Limit, "capacity".into()));
    assert_eq!(made(0.0, memory(1.0, 10_001), sensors()), (Code::Limit, "capacity".into()));
    assert_eq!(made(0.0, memory(1.0, 1), vec![]), (Code::Shape, "sensors".into()));
    let bent = |bend: &dyn Fn(&mut Sensor)| {
        let mut all = sensors();
        bend(&mut all[1]);
        made(0.0, memory(1.0, 1), all)
    };
    assert_eq!(bent(&|it| it.delay = 10.1), (Code::Limit, "sensors.wheel.delay".into()));
    assert_eq!(bent(&|it| it.gate = Some(0.0)), (Code::Limit, "sensors.wheel.gate".into()));
    assert_eq!(bent(&|it| it.w = dmatrix![-1.0]), (Code::NotPositiveSemidefinite, "sensors.wheel.W".into()));
    assert_eq!(bent(&|it| it.name = "fix".into()), (Code::Index, "sensors.fix".into()));
    assert_eq!(bent(&|it| it.h = dmatrix![1.0]), (Code::Shape, "sensors.wheel.H".into()));
}

#[test]
fn statistics_are_of_all_readings_also_of_those_before_the_window() {
    let mut dice = Dice(8);
    let sorted = events(&mut dice, 120);
    let (mut short, mut long) = (line(2.0), line(1e3));
    let mut by_hand = [(0, 0, 0.0, 0, 0.0); 3];
    for event in &sorted {
        tell(&mut short, event);
        let Placed { outcome, judged } = tell(&mut long, event);
        let Some(judged) = judged else { continue };
        let (used, refused, chi2, parts, first) = &mut by_hand[event.1 - 1];
        match outcome {
            Outcome::Accepted => {
                *used += 1;
                *chi2 += judged.chi2.expect("regular");
                *parts += judged.innovation.len();
                *first += if event.3[0].is_some() { judged.innovation[0] } else { 0.0 };
            }
            _ => *refused += 1,
        }
    }
    assert!(short.len() < 30 && long.len() == 120);
    assert_eq!(short.statistics(), long.statistics());
    for (found, (used, refused, chi2, parts, first)) in long.statistics().iter().zip(by_hand) {
        assert_eq!((found.used, found.refused), (used, refused));
        assert!(used > 3 && used + refused > 10, "{used} of {refused} more");
        assert!((found.nis.expect("used") - chi2 / parts as f64).abs() < 1e-12);
        if found.mean_innovation.len() == 1 {
            assert!((found.mean_innovation[0].expect("read") - first / used as f64).abs() < 1e-12);
        }
    }
    let nothing = &line(1.0).statistics()[2];
    assert_eq!((nothing.name.as_str(), nothing.used, nothing.nis), ("both", 0, None));
    assert_eq!(nothing.mean_innovation, [None, None]);
}
