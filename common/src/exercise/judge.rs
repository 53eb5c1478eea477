//! The verdict of a check, also when the answer panics or never ends.

use std::{
    panic::{self, PanicHookInfo},
    sync::{
        Arc,
        mpsc::{self, Receiver, RecvTimeoutError},
    },
    thread,
    time::Duration,
};

use super::{
    Diagnosis, Finding, Verdict,
    panic::diagnosis,
    paragraph,
    trial::{self, Follower, Place, Telling},
};

/// How long an answer may take before it counts as an endless loop. Every check takes less than a second.
const PATIENCE: Duration = Duration::from_secs(20);

/// The verdict of a check; a panic in the answer or an endless loop is a diagnosis too.
pub(super) fn judge(check: fn() -> Verdict, telling: Telling) -> Verdict {
    let (panicked, panics) = mpsc::channel();
    panic::set_hook(Box::new(move |panic| {
        // Nobody listens any more only after the verdict is known.
        let _ = panicked.send(place_and_words(panic));
    }));
    let verdict = verdict_within(PATIENCE, check, panics, telling);
    drop(panic::take_hook());
    verdict
}

/// Where there was a panic, and what it said.
type Panic = (String, String);

fn place_and_words(panic: &PanicHookInfo<'_>) -> Panic {
    let place = panic.location().map_or_else(|| "an unknown place".into(), ToString::to_string);
    let payload = panic.payload();
    let words =
        payload.downcast_ref::<&str>().copied().or_else(|| payload.downcast_ref::<String>().map(String::as_str));
    (place, words.unwrap_or("no words").into())
}

/// The verdict of a check that may take so long.
fn verdict_within(patience: Duration, check: fn() -> Verdict, panics: Receiver<Panic>, telling: Telling) -> Verdict {
    let place = Arc::<Place>::default();
    let follower = Follower { place: place.clone(), telling };
    let (teller, verdicts) = mpsc::channel();
    thread::spawn(move || {
        follower.follow();
        let judged = panic::catch_unwind(check).unwrap_or_else(|_| {
            let (place, words) = panics.try_iter().last().unwrap_or_default();
            Err(diagnosis(trial::tried(), &place, &words))
        });
        teller.send(judged)
    });
    let half = patience / 2;
    let early = verdicts.recv_timeout(half);
    let begun = place.begun();
    let verdict = early.or_else(|_| verdicts.recv_timeout(half));
    verdict.unwrap_or_else(|error| {
        Err(match error {
            RecvTimeoutError::Timeout if place.begun() > begun => too_slow(patience, place.begun()),
            RecvTimeoutError::Timeout => endless(patience, tried_in(check, place.now(), patience)),
            RecvTimeoutError::Disconnected => Diagnosis::new("endless", "The check ended without a verdict."),
        })
    })
}

/// What a check tries in the trial of that number, if it comes there in time.
///
/// A check asks the same in every run. So it runs once more, and this time the trial is put into words: to do that for
/// every trial of every check would take longer than the checks.
fn tried_in(check: fn() -> Verdict, number: u64, patience: Duration) -> Option<String> {
    if number == Place::NOWHERE {
        return None;
    }
    let (teller, told) = mpsc::channel();
    thread::spawn(move || {
        Follower { place: Arc::default(), telling: Telling::One(number, teller) }.follow();
        check()
    });
    told.recv_timeout(patience).ok()
}

/// The diagnosis for an answer that does not come from one trial.
fn endless(patience: Duration, tried: Option<String>) -> Diagnosis {
    const NAME: &str = "endless";
    let got = format!("no answer after {} seconds", patience.as_secs());
    let advice = "Is there a loop that never ends? It may end for ordinary input and not for this one, for instance when the \
                  input is very great, zero or negative. Or is it only slow, with many more steps than it must take? To find \
                  out, print with `eprintln!` in the loop what should come to an end: the last lines that were printed are \
                  shown.";
    match tried {
        Some(tried) => {
            let expected = "an answer at once".into();
            Finding { tried, got, expected, advice: advice.into() }.named(NAME)
        }
        None => Diagnosis::new(NAME, format!("There was {got}.\n\n{}", paragraph("", advice))),
    }
}

/// The diagnosis for an answer that comes from each trial so far, but too late.
fn too_slow(patience: Duration, trials: u64) -> Diagnosis {
    let what = format!(
        "The check was still at work after {} seconds, at its question number {trials}. It takes less than a second when \
         each answer comes at once.",
        patience.as_secs()
    );
    let advice = "Your code does answer, but slowly. Is there a print left over? Thousands of lines take long. Or a loop that \
                  takes many more steps than it must?";
    let message = format!("{}\n\n{}", paragraph("", &what), paragraph("", advice));
    Diagnosis::new("too-slow", message)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exercise::trying;

    /// The diagnosis of a check that gets less patience than usual.
    fn diagnosed(check: fn() -> Verdict) -> Diagnosis {
        verdict_within(Duration::from_millis(400), check, mpsc::channel().1, Telling::Nothing).unwrap_err()
    }

    fn sleep() {
        thread::sleep(Duration::from_millis(20));
    }

    #[test]
    fn an_endless_loop_is_told_with_what_was_tried() {
        let told = diagnosed(|| {
            trying(|| "a near point".into(), || ());
            trying(
                || "a far point".into(),
                || {
                    loop {
                        sleep();
                    }
                },
            )
        });
        assert_eq!(told.name, "endless");
        assert!(told.message.starts_with("Tried:    a far point\nGot:      no answer after "), "{told}");
    }

    #[test]
    fn an_endless_loop_between_two_trials_is_told_without() {
        let told = diagnosed(|| {
            trying(|| "a point".into(), || ());
            loop {
                sleep();
            }
        });
        assert_eq!(told.name, "endless");
        assert!(told.message.starts_with("There was no answer after "), "{told}");
    }

    #[test]
    fn an_answer_that_is_slow_is_not_endless() {
        let told = diagnosed(|| {
            loop {
                trying(|| unreachable!(), sleep);
            }
        });
        assert_eq!(told.name, "too-slow");
        assert!(told.message.contains("still at work"), "{told}");
    }
}
