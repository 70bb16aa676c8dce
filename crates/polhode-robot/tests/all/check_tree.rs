//! Cycles, roots, parents and names.

use crate::check_common::{findings, link, number, only, read, robot};
use polhode_robot::check::check;
use polhode_robot::finding::Severity;
use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::inspect;

const TENSOR: [&str; 6] = ["0.0123", "0.0171", "0.0219", "-0.0011", "0.0007", "0.0013"];

fn joint(name: &str, parent: &str, child: &str) -> String {
    format!(
        "<joint name=\"{name}\" type=\"revolute\"><parent link=\"{parent}\"/><child link=\"{child}\"/></joint>\n"
    )
}

/// Returns a model with links by name, and joints between them.
fn model(links: &[&str], joints: &[(&str, &str)]) -> String {
    let links: String = links.iter().map(|name| link(name, "1.5", TENSOR)).collect();
    let joints: String = joints.iter().enumerate().map(|(k, (p, c))| joint(&format!("j{k}"), p, c)).collect();
    robot(&(links + &joints))
}

#[test]
fn a_tree_is_no_finding() {
    assert_eq!(findings(&model(&["a", "b", "c", "d"], &[("a", "b"), ("b", "c"), ("a", "d")])), []);
}

#[test]
fn a_cycle_is_told_with_its_links() {
    // Neither the base nor the descendant of the cycle belongs to it.
    let document = model(
        &["base", "a", "b", "c", "tail"],
        &[("a", "b"), ("b", "c"), ("c", "a"), ("base", "a"), ("c", "tail")],
    );
    let all = findings(&document);
    let found = only(&all, "tree.cycle");
    assert_eq!(found.severity, Severity::Impossible);
    assert_eq!(number(found, "links"), 3.0);
    let chain = ["a → b → c → a", "b → c → a → b", "c → a → b → c"];
    assert!(chain.iter().any(|c| found.message.contains(c)), "{}", found.message);
    assert!(document[found.span.clone()].starts_with("<joint"));
    assert!(all.iter().any(|f| f.code == "tree.two_parents"));
    // Without other links, the cycle leaves no root.
    let all = findings(&model(&["a", "b"], &[("a", "b"), ("b", "a")]));
    only(&all, "tree.cycle");
    only(&all, "tree.no_root");
    // A link that is its own parent.
    let all = findings(&model(&["base", "a"], &[("a", "a")]));
    assert!(only(&all, "tree.cycle").message.contains("a → a"));
}

#[test]
fn two_cycles_are_two_findings() {
    let all = findings(&model(&["r", "a", "b", "c", "d"], &[("a", "b"), ("b", "a"), ("c", "d"), ("d", "c")]));
    assert_eq!(all.iter().filter(|f| f.code == "tree.cycle").count(), 2);
}

#[test]
fn a_long_cycle_ends() {
    let names: Vec<String> = (0..20_000).map(|k| format!("link{k}")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let joints: Vec<(&str, &str)> =
        (0..names.len()).map(|k| (names[k], names[(k + 1) % names.len()])).collect();
    let all = check(&read(&model(&names, &joints)), &[]);
    let found = only(&all, "tree.cycle");
    assert_eq!(number(found, "links"), 20_000.0);
    assert!(found.message.len() < 400, "{}", found.message);
    // Without the closing joint it is a chain, which has no finding.
    assert_eq!(check(&read(&model(&names, &joints[1..])), &[]), []);
}

#[test]
fn two_roots() {
    let document = model(&["a", "b", "c", "d"], &[("a", "b"), ("c", "d")]);
    let all = findings(&document);
    let found = only(&all, "tree.two_roots");
    assert_eq!((found.severity, all.len()), (Severity::Impossible, 1));
    assert!(found.message.contains("2 roots: a, c"), "{}", found.message);
    assert_eq!((found.subject.as_str(), &document[found.span.clone()]), ("c", "c"));
}

#[test]
fn a_child_with_two_parents() {
    let all = findings(&model(&["a", "b", "c"], &[("a", "b"), ("a", "c"), ("b", "c")]));
    let found = only(&all, "tree.two_parents");
    assert_eq!((found.severity, all.len()), (Severity::Impossible, 1));
    assert!(found.message.contains("\"c\" has two parents, \"a\" and \"b\""), "{}", found.message);
}

#[test]
fn an_axis_without_a_direction() {
    let axis = |kind: &str, xyz: &str| {
        let text = model(&["a", "b"], &[("a", "b")]).replace("revolute", kind);
        findings(&text.replace("</joint>", &format!("<axis xyz=\"{xyz}\"/></joint>")))
    };
    for kind in ["revolute", "continuous", "prismatic"] {
        assert_eq!(axis(kind, "0 -0.3 1e-9"), []);
        for (xyz, severity) in
            [("0 0 -0", Severity::Suspect), ("0 A 1", Severity::Impossible), ("1 0", Severity::Impossible)]
        {
            let all = axis(kind, xyz);
            let found = only(&all, "joint.axis");
            assert_eq!((found.severity, &*found.subject, all.len()), (severity, "j0", 1), "{kind} {xyz}");
        }
    }
    assert_eq!(axis("fixed", "0 0 0"), []);
}

#[test]
fn names_twice_and_names_of_nothing() {
    let document = model(&["a", "b", "b"], &[("a", "b")]);
    let all = findings(&document);
    let found = only(&all, "tree.duplicate_link");
    assert_eq!((found.severity, found.subject.as_str()), (Severity::Impossible, "b"));
    assert_eq!(document[..found.span.start].matches("<link").count(), 3);

    let twice = model(&["a", "b", "c"], &[("a", "b"), ("b", "c")]).replace("j1", "j0");
    let all = findings(&twice);
    assert_eq!(only(&all, "tree.duplicate_joint").subject, "j0");

    let all = findings(&model(&["a", "b"], &[("a", "b"), ("a", "ghost")]));
    let found = only(&all, "tree.unknown_link");
    assert_eq!((found.severity, all.len()), (Severity::Impossible, 1));
    assert!(found.message.contains("child \"ghost\""), "{}", found.message);
    let all = findings(&model(&["a", "b"], &[("a", "b"), ("ghost", "b")]));
    assert!(only(&all, "tree.unknown_link").message.contains("parent \"ghost\""));
}

#[test]
fn an_empty_robot() {
    only(&findings("<robot name=\"r\"/>"), "tree.empty");
}

#[test]
fn findings_are_in_the_order_of_the_file() {
    let document = model(&["a", "b", "b", "c"], &[("a", "ghost"), ("a", "b"), ("b", "c"), ("a", "c")])
        .replacen("\"1.5\"", "\"-1.5\"", 4);
    let all = findings(&document);
    assert!(all.len() > 4);
    assert!(all.windows(2).all(|w| w[0].span.start <= w[1].span.start), "{all:#?}");
}

#[test]
fn loops_of_sdf_joints_are_legal_whichever_way_they_go() {
    // A four-bar linkage, first with opposite and then with equal joint directions.
    for joints in
        [[("a", "b"), ("b", "c"), ("a", "d"), ("d", "c")], [("a", "b"), ("b", "c"), ("c", "d"), ("d", "a")]]
    {
        let mut text = String::from("<sdf version=\"1.9\"><model name=\"m\">");
        for link in ["a", "b", "c", "d"] {
            text += &format!(
                "<link name=\"{link}\"><inertial><mass>1.5</mass><inertia><ixx>0.0123</ixx><iyy>0.0171</iyy>\
                 <izz>0.0219</izz></inertia></inertial></link>"
            );
        }
        for (k, (parent, child)) in joints.iter().enumerate() {
            text += &format!(
                "<joint name=\"j{k}\" type=\"revolute\"><parent>{parent}</parent><child>{child}</child></joint>"
            );
        }
        let all = findings(&(text + "</model></sdf>"));
        assert_eq!((all.len(), all[0].severity), (1, Severity::Note), "{all:#?}");
    }
}

#[test]
fn a_parent_called_world_is_the_world() {
    let fixed = model(&["base", "arm"], &[("world", "base"), ("base", "arm")]);
    let read = read(&fixed);
    assert!(read.joints[0].parent.is_none() && read.joints[1].parent.is_some());
    let found = inspect(&read, &Shapes::default()).findings;
    assert_eq!(
        (found.len(), found[0].code, found[0].severity),
        (1, "read.world", Severity::Note),
        "{found:#?}"
    );
    assert_eq!(&fixed[found[0].span.clone()], "world");
    // With a link named `world`, that link is the parent. Another unknown name is an error.
    assert_eq!(findings(&model(&["world", "base"], &[("world", "base")])), []);
    only(&findings(&model(&["base"], &[("earth", "base")])), "tree.unknown_link");
}

#[test]
fn a_link_and_a_joint_of_one_name() {
    let text = model(&["a", "b"], &[("a", "b")]).replace("j0", "b");
    let all = findings(&text);
    let found = only(&all, "tree.shared_name");
    assert_eq!((found.severity, all.len()), (Severity::Note, 1));
    let sdf = "<sdf version=\"1.9\"><model name=\"m\"><link name=\"a\"/><link name=\"b\"/>\
               <joint name=\"b\" type=\"fixed\"><parent>a</parent><child>b</child></joint></model></sdf>";
    assert_eq!(only(&findings(sdf), "tree.shared_name").severity, Severity::Suspect);
}
