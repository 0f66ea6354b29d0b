use super::*;

fn said(left: &str, right: &str) -> Option<Role> {
    let (left, right) = (left.to_owned(), right.to_owned());
    role(&Around { left, right, first: true, ..Around::default() }, true)
}

#[test]
fn cues_in_four_languages() {
    for (left, right, wanted) in [
        ("If", "then", Some(Role::Case)),
        ("For all", "", Some(Role::All)),
        ("Always", "", Some(Role::Always)),
        ("For all integers", "", Some(Role::All)),
        ("It follows that", "", Some(Role::Claimed)),
        ("We find", "", Some(Role::Claimed)),
        ("Find", "", Some(Role::Asked)),
        ("Solving", "", Some(Role::Sought)),
        ("Solving,", "", None),
        ("It is wrong that", "", Some(Role::Asked)),
        ("Suppose that", "", Some(Role::Assumed)),
        ("", ", otherwise", Some(Role::Elsewhere)),
        ("unless", "", Some(Role::Except)),
        ("", "is odd", Some(Role::Odd)),
        ("Ist", ", so gilt", Some(Role::Case)),
        ("Dann gilt für", "", Some(Role::Case)),
        ("Supposons que", "", Some(Role::Assumed)),
        ("Si", ", alors", Some(Role::Case)),
        ("当", "时，", Some(Role::Case)),
        ("所以", "", Some(Role::Claimed)),
        ("The curve", "passes through", None),
        ("waterproof", "", None),
    ] {
        assert_eq!(said(left, right), wanted, "{left} … {right}");
    }
}
