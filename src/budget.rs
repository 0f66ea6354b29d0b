//! Limits on time, steps, terms and digits, and cancellation.
//!
//! Long computations call [`step`] now and then, and ask [`charge_terms`] or
//! [`charge_bits`] *before* they build something large. When a limit is passed the
//! computation unwinds with a [`Stop`], and [`run`], the only place that catches
//! it, returns it as an error. Mathematical code therefore needs no error type for
//! "took too long", and code outside [`run`] (library users) has no limits at all.
//!
//! Unwinding does not print anything: it starts with `resume_unwind`, which skips
//! the panic hook. (salsa cancels queries in the same way.)
//!
//! Time is told by a [`Clock`] that the limits bring. Without one, as in WebAssembly or in a build without the feature
//! `clock`, limits on time never pass; those on steps are the same everywhere.

use std::cell::RefCell;
use std::fmt;
use std::panic::{AssertUnwindSafe, RefUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// Why a computation was stopped.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The time limit was reached.
    Time(Duration),
    /// The limit of steps was reached.
    Steps(u64),
    /// The result or an intermediate value needs more terms than allowed.
    Terms {
        /// Terms needed (a lower bound), saturating.
        needed: u64,
        /// Terms allowed.
        allowed: u64,
    },
    /// A number needs more bits than allowed.
    Bits {
        /// Bits needed (a lower bound), saturating.
        needed: u64,
        /// Bits allowed.
        allowed: u64,
    },
    /// Somebody asked for it to stop (Ctrl-C).
    Interrupted,
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Stop::Time(limit) => write!(f, "stopped after the time limit of {} s", limit.as_secs_f64()),
            Stop::Steps(limit) => write!(f, "stopped after the limit of {limit} steps"),
            Stop::Terms { needed, allowed } => {
                write!(f, "this needs at least {needed} terms, more than the limit of {allowed}")
            }
            Stop::Bits { needed, allowed } => {
                write!(f, "this needs a number of at least {needed} bits, more than the limit of {allowed}")
            }
            Stop::Interrupted => f.write_str("interrupted"),
        }
    }
}

impl std::error::Error for Stop {}

/// What tells the time to limits: a program may bring its own.
pub trait Clock: fmt::Debug + Sync + RefUnwindSafe {
    /// The time since some moment that stays the same; it never goes back.
    fn now(&self) -> Duration;
}

/// The clock of the system.
#[cfg(feature = "clock")]
#[derive(Debug)]
pub struct SystemClock;

#[cfg(feature = "clock")]
impl Clock for SystemClock {
    fn now(&self) -> Duration {
        static BEGAN: std::sync::LazyLock<std::time::Instant> =
            std::sync::LazyLock::new(std::time::Instant::now);
        BEGAN.elapsed()
    }
}

/// The clock of limits that say nothing else.
fn usual_clock() -> Option<&'static dyn Clock> {
    #[cfg(feature = "clock")]
    return Some(&SystemClock);
    #[cfg(not(feature = "clock"))]
    None
}

/// The limits of one computation.
#[derive(Clone, Debug)]
pub struct Limits {
    /// Time allowed; `None` for no limit. Without meaning where there is no clock.
    pub time: Option<Duration>,
    /// What tells the time: that of the system if the library has the feature `clock`, else none.
    pub clock: Option<&'static dyn Clock>,
    /// Steps allowed; `None` for no limit. Unlike time they are the same on every machine.
    pub steps: Option<u64>,
    /// Number of terms (monomials, matrix entries, list items) a value may have.
    pub terms: u64,
    /// Number of bits a single integer may have.
    pub bits: u64,
    /// How deeply functions may call each other, at most [`MOST_DEPTH`].
    pub depth: usize,
    /// Set by somebody else to stop the computation.
    pub interrupt: Arc<AtomicBool>,
    /// Asked now and then in the thread of the computation, for programs that can be told to stop only there; true
    /// sets `interrupt`. Inner runs ask it, too.
    pub watch: Option<fn() -> bool>,
}

impl Default for Limits {
    /// No time limit, 4 million terms, 262 144 bits (about 79 000 digits), 400 nested calls.
    fn default() -> Self {
        Limits {
            time: None,
            clock: usual_clock(),
            steps: None,
            terms: 4_000_000,
            bits: 1 << 18,
            depth: DEFAULT_DEPTH,
            interrupt: Arc::new(AtomicBool::new(false)),
            watch: None,
        }
    }
}

impl Limits {
    /// The time by the clock of these limits; zero if they have none.
    pub fn now(&self) -> Duration {
        self.clock.map_or(Duration::ZERO, Clock::now)
    }
}

/// Nested calls allowed where nothing else is said, also outside of [`run`].
const DEFAULT_DEPTH: usize = 400;

/// Calls may not be nested deeper than this, whatever is asked for: each takes memory.
pub const MOST_DEPTH: usize = 20_000;

struct Active {
    limits: Limits,
    /// By the clock of the limits.
    deadline: Option<Duration>,
    countdown: u32,
    /// Steps taken, those of inner runs too.
    spent: u64,
}

thread_local! {
    static ACTIVE: RefCell<Option<Active>> = const { RefCell::new(None) };
}

/// How many [`step`]s pass between two looks at the clock.
const STEPS_PER_LOOK: u32 = 256;

/// Restores the outer limits even when the computation panics.
struct Restore(Option<Active>);

impl Drop for Restore {
    fn drop(&mut self) {
        let mut outer = self.0.take();
        ACTIVE.with(|active| {
            let inner = active.borrow().as_ref().map_or(0, |inner| inner.spent);
            if let Some(outer) = &mut outer {
                outer.spent += inner;
            }
            *active.borrow_mut() = outer;
        });
    }
}

/// Runs `work` under `limits`; other panics pass through. Nested calls use the inner limits.
///
/// ```
/// use polarform::budget::{self, Limits, Stop};
/// let limits = Limits { terms: 10, ..Limits::default() };
/// let result = budget::run(&limits, || budget::charge_terms(1000));
/// assert_eq!(result, Err(Stop::Terms { needed: 1000, allowed: 10 }));
/// ```
pub fn run<T>(limits: &Limits, work: impl FnOnce() -> T) -> Result<T, Stop> {
    run_since(limits.now(), limits, work)
}

/// The same with work that began earlier by the clock of the limits, some of which is done: the limit on time counts
/// from then on.
pub fn run_since<T>(began: Duration, limits: &Limits, work: impl FnOnce() -> T) -> Result<T, Stop> {
    let deadline = limits.time.filter(|_| limits.clock.is_some()).and_then(|time| began.checked_add(time));
    let mut active = Active { limits: limits.clone(), deadline, countdown: STEPS_PER_LOOK, spent: 0 };
    let outer = ACTIVE.with(|slot| {
        let mut slot = slot.borrow_mut();
        let watched = slot.as_ref().and_then(|outer| outer.limits.watch);
        active.limits.watch = active.limits.watch.or(watched);
        slot.replace(active)
    });
    let _restore = Restore(outer);
    match catch_unwind(AssertUnwindSafe(work)) {
        Ok(value) => Ok(value),
        Err(payload) => match payload.downcast::<Stop>() {
            Ok(stop) => Err(*stop),
            Err(other) => resume_unwind(other),
        },
    }
}

fn stop(reason: Stop) -> ! {
    resume_unwind(Box::new(reason))
}

/// One unit of work (about a microsecond); now and then looks at the clock and the interrupt flag.
#[inline]
pub fn step() {
    steps(1);
}

/// `count` units of work at once.
pub fn steps(count: u32) {
    let looks = ACTIVE.with(|slot| {
        let mut slot = slot.borrow_mut();
        let Some(active) = slot.as_mut() else { return Ok(false) };
        active.spent += u64::from(count);
        if let Some(limit) = active.limits.steps.filter(|limit| active.spent > *limit) {
            return Err(Stop::Steps(limit));
        }
        if let Some(left) = active.countdown.checked_sub(count) {
            active.countdown = left;
            return Ok(false);
        }
        active.countdown = STEPS_PER_LOOK;
        Ok(true)
    });
    match looks {
        Ok(false) => {}
        Ok(true) => look(),
        Err(reason) => stop(reason),
    }
}

/// Looks at the clock, at the flag, and asks whoever watches, who may begin a computation of its own meanwhile.
#[cold]
fn look() {
    let reason = |asked: bool| {
        ACTIVE.with(|slot| {
            let slot = slot.borrow();
            let active = slot.as_ref()?;
            if asked {
                active.limits.interrupt.store(true, Ordering::Relaxed);
            }
            if active.limits.interrupt.load(Ordering::Relaxed) {
                return Some(Stop::Interrupted);
            }
            let deadline = active.deadline?;
            (active.limits.now() >= deadline).then(|| Stop::Time(active.limits.time.unwrap_or_default()))
        })
    };
    let watch = ACTIVE.with(|slot| slot.borrow().as_ref().and_then(|active| active.limits.watch));
    if let Some(reason) = reason(watch.is_some_and(|watch| watch())) {
        stop(reason);
    }
}

/// The steps taken in the innermost [`run`] so far.
pub fn spent() -> u64 {
    ACTIVE.with(|slot| slot.borrow().as_ref().map_or(0, |active| active.spent))
}

/// How deeply functions may call each other here.
pub fn depth() -> usize {
    ACTIVE.with(|slot| {
        slot.borrow().as_ref().map_or(DEFAULT_DEPTH, |active| active.limits.depth.min(MOST_DEPTH))
    })
}

/// Asks for room for a value of `count` terms.
pub fn charge_terms(count: u64) {
    let allowed = ACTIVE.with(|slot| slot.borrow().as_ref().map(|active| active.limits.terms));
    if let Some(allowed) = allowed
        && count > allowed
    {
        stop(Stop::Terms { needed: count, allowed });
    }
}

/// Asks for room for an integer of `count` bits.
pub fn charge_bits(count: u64) {
    let allowed = ACTIVE.with(|slot| slot.borrow().as_ref().map(|active| active.limits.bits));
    if let Some(allowed) = allowed
        && count > allowed
    {
        stop(Stop::Bits { needed: count, allowed });
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicU64;

    use super::*;

    #[cfg(feature = "clock")]
    #[test]
    fn time_runs_out() {
        let limits = Limits { time: Some(Duration::from_millis(5)), ..Limits::default() };
        let stopped = run(&limits, || {
            loop {
                step();
            }
        });
        assert_eq!(stopped, Err::<(), _>(Stop::Time(Duration::from_millis(5))));
        steps(1_000_000); // no limits outside
    }

    /// A clock that is wound by hand.
    #[derive(Debug)]
    struct Hand(AtomicU64);

    impl Clock for Hand {
        fn now(&self) -> Duration {
            Duration::from_secs(self.0.load(Ordering::Relaxed))
        }
    }

    static HAND: Hand = Hand(AtomicU64::new(5000));

    #[test]
    fn time_is_told_by_the_clock_of_the_limits() {
        let hour = Some(Duration::from_secs(3600));
        let limits = Limits { time: hour, clock: Some(&HAND), ..Limits::default() };
        let passed = Err(Stop::Time(Duration::from_secs(3600)));
        // Work may have begun earlier.
        assert_eq!(run_since(Duration::from_secs(1000), &limits, || steps(1000)), passed);
        assert_eq!(run_since(limits.now(), &limits, || steps(1000)), Ok(()));
        let an_hour_later = || {
            steps(1000);
            HAND.0.fetch_add(3600, Ordering::Relaxed);
            steps(1000);
        };
        assert_eq!(run(&limits, an_hour_later), passed);
        // Without a clock only steps count.
        let without = Limits { clock: None, steps: Some(5000), ..limits };
        assert_eq!(run(&without, an_hour_later), Ok(()));
        assert_eq!(run(&without, || (0..9).for_each(|_| steps(1000))), Err(Stop::Steps(5000)));
    }

    #[test]
    fn steps_are_counted_also_in_inner_runs() {
        let limits = Limits { steps: Some(100), ..Limits::default() };
        let inner = Limits { steps: Some(30), ..Limits::default() };
        let stopped = run(&limits, || {
            assert_eq!(run(&inner, || steps(31)), Err(Stop::Steps(30)));
            assert_eq!(run(&inner, || steps(30)), Ok(()));
            assert_eq!(spent(), 61);
            steps(40);
        });
        assert_eq!(stopped, Err(Stop::Steps(100)));
    }

    #[test]
    fn interrupt_is_seen() {
        let limits = Limits::default();
        limits.interrupt.store(true, Ordering::Relaxed);
        let stopped = run(&limits, || {
            loop {
                step();
            }
        });
        assert_eq!(stopped, Err::<(), _>(Stop::Interrupted));
    }

    #[test]
    fn who_watches_may_calculate_and_stops_inner_runs() {
        thread_local!(static ASKED: std::cell::Cell<u32> = const { std::cell::Cell::new(0) });
        let watch: fn() -> bool = || {
            assert_eq!(run(&Limits::default(), || steps(10)), Ok(()));
            ASKED.set(ASKED.get() + 1);
            ASKED.get() > 3
        };
        let limits = Limits { watch: Some(watch), ..Limits::default() };
        let stopped = run(&limits, || {
            let inner = run(&Limits::default(), || {
                loop {
                    step();
                }
            });
            assert_eq!(inner, Err::<(), _>(Stop::Interrupted));
            assert_eq!(ASKED.get(), 4);
            loop {
                step();
            }
        });
        assert_eq!(stopped, Err::<(), _>(Stop::Interrupted));
        assert!(limits.interrupt.load(Ordering::Relaxed));
    }

    #[test]
    fn inner_limits_end_with_their_run() {
        let outer = Limits { bits: 100, ..Limits::default() };
        let inner = Limits { bits: 10, ..Limits::default() };
        let result = run(&outer, || {
            assert!(run(&inner, || charge_bits(50)).is_err());
            charge_bits(50);
            "done"
        });
        assert_eq!(result, Ok("done"));
    }

    #[test]
    #[should_panic(expected = "ordinary")]
    fn other_panics_pass() {
        let _ = run(&Limits::default(), || panic!("ordinary"));
    }
}
