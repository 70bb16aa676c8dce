//! Every refusal, with its place and what it says.

use polhode_budget::Basis;

use super::Folder;

/// A list, and how the message begins; after the bar, how its hint does.
const LISTS: &[(&str, &str)] = &[
    // Headings
    ("", "list.csv: the file has no column with the heading \"name\", or \"path\""),
    ("mass\n1\n", "list.csv:1:1: the file has no column with the heading \"name\""),
    ("nmae,mass\na,1\n", "list.csv:1:1: unknown key \"nmae\" in the headings | did you mean name?"),
    (
        "name,maas [g]\na,1\n",
        "list.csv:1:6: unknown key \"maas [g]\" in the headings | did you mean mass? or write ignore = [\"maas [g]\"]",
    ),
    (
        "name,mass,colour\na,1,red\n",
        "list.csv:1:11: unknown key \"colour\" in the headings | the keys here are name, path",
    ),
    (
        "name,mass [mm]\na,1\n",
        "list.csv:1:6: \"mm\" is a length where a mass belongs | name a unit of a mass",
    ),
    ("name,mass [gg]\na,1\n", "list.csv:1:6: there is no unit \"gg\""),
    (
        "name,mass,Mass [g]\na,1,1\n",
        "list.csv:1:11: the heading = Mass [g] must be another column than that with the heading \"mass\"",
    ),
    ("name,path,mass\na,a,1\n", "list.csv:1:6: the heading = path must be another column"),
    ("name,mass,parent [kg]\na,1,\n", "list.csv:1:11: the heading = parent [kg] must be without a unit"),
    ("name,mass,quantity sd\na,1,1\n", "list.csv:1:11: unknown key \"quantity sd\""),
    ("name,mass,rotate x\na,1,1\n", "list.csv:1:11: unknown key \"rotate x\""),
    // Cells
    ("name,mass\na,1,2\n", "list.csv:2:5: a cell beside the columns = 2 must be under a heading"),
    ("name,mass\n\"a,1\n", "list.csv:2:1: expected a quote that ends the cell, found the end of the file"),
    (
        "name,mass\n\"a\"b,1\n",
        "list.csv:2:4: expected a comma or the end of the line after the quote, found \"b\"",
    ),
    ("name,mass\na,heavy\n", "list.csv:2:3: \"heavy\" is not a number"),
    ("name,mass\na,12 mm\n", "list.csv:2:3: \"mm\" is a length where a mass belongs"),
    ("name,mass\na,\"1,234\"\n", "list.csv:2:3: \"1,234\" is not a number | write 1.234 or 1234"),
    ("name,mass\na,1e999\n", "list.csv:2:3: \"1e999\" is larger than any double"),
    ("name,mass\na,nan\n", "list.csv:2:3: \"nan\" is not a number"),
    (
        "name,mass\na,12 g\nb,1\n",
        "list.csv:3:3: mass = 1 must be given with its unit, as \"12 g\" in row 2 is",
    ),
    (
        "name,mass\na,1\nb,12 g\n",
        "list.csv:2:3: mass = 1 must be given with its unit, as \"12 g\" in row 3 is",
    ),
    (
        "name;mass\na;1,5\nb;2.5\n",
        "list.csv:3:3: is a comma or a point the decimal mark? Row 2 has 1,5. The file has only 2.5",
    ),
    (
        "name;mass\na;1,250\n",
        "list.csv:2:3: is this a decimal mark, or does it part thousands? The file has only 1,250 | write decimal",
    ),
    (
        "# decimal = \"comma\"\nname;mass\na;1.250,5\n",
        "list.csv:3:3: mass = 1.250,5 must be a number with a decimal comma",
    ),
    // Names and trees
    ("name,mass\n,1\n", "list.csv:2:2: the file has no name in row 2 | write a sum into the column subtotal"),
    (
        "name,mass\na,1\nb,2\nTotal:,3\n",
        "list.csv:4:1: name = Total: must be the name of a part, and no sum of others | write a sum",
    ),
    ("name,mass\na,1\na,2\n", "list.csv:3:1: rows 1 and 2 have the same name, \"a\""),
    (
        "name,parent,mass\na,,1\nb,,2\nc,b,3\n",
        "list.csv:3:1: \"a\" and \"b\" both stand in no other row: there can be one such row | put one into the other",
    ),
    (
        "name,parent,mass\na,,1\nb,c,2\nc,d,2\nd,b,2\n",
        "list.csv:5:3: rows stand in each other: \"b\" in \"c\" in \"d\" in \"b\"",
    ),
    (
        "name,parent,mass\nbus,,1\nb,buss,2\n",
        "list.csv:3:3: \"b\" names the frame \"buss\", which is no row | did you mean \"bus\"?",
    ),
    (
        "path,mass\nbus,\npod/cell,2\n",
        "list.csv:3:1: \"pod/cell\" names the frame \"pod\", which is no row | a frame is a row",
    ),
    (
        "name,parent,mass\na,,7\nb,a,1.00\nc,b,0.25\nd,b,0.7500\n",
        "list.csv:3:5: mass = 1.00 must be the mass of the part itself, but it is the sum of the rows",
    ),
    (
        "name,parent,mass\na,,3.50\nb,a,\nc,b,1\nd,b,2.5\n",
        "list.csv:2:4: mass = 3.50 must be the mass of the part itself, but it is the sum of the rows",
    ),
    (
        "name,parent,mass\nf,,3.2\na,f,3.20\n",
        "list.csv:2:4: mass = 3.2 must be the mass of the part itself, but it is the sum of the rows that stand in it: these would count twice | write a sum into the column subtotal",
    ),
    ("name,parent,mass\nf,,3\na,f,3.2\n", ""),
    (
        "name,mass\na,1\nTotal (all),3\n",
        "list.csv:3:1: name = Total (all) must be the name of a part, and no sum of others",
    ),
    (
        "name,mass\n# a,1\nb,2\n",
        "list.csv:2:1: name = # a must be without # in front, below the headings | remarks, ##, stand above",
    ),
    ("name,mass\n#a,1\nb,2\n", "list.csv:2:1: name = #a must be without # in front"),
    ("name,mass\n\"#8 screw\",1\nb,2\n", ""),
    (
        "path,parent,mass\na,,1\nc,a,2\na/b,c,5\n",
        "list.csv:4:5: parent = c must be \"a\", as the path says, or left out | a name with / is a path",
    ),
    ("path,parent,mass\na,,1\na/b,a,5\n", ""),
    (
        "name,mass,quantity\na,1,\nb,,5\nc,2,\n",
        "list.csv:3:1: name = b must be a row with mass, or one in which others stand | a frame in which nothing stands",
    ),
    ("name,mass\na,1\n---,\n", "list.csv:3:1: name = --- must be a row with mass"),
    ("name,mass,configuration\na,1,\nb,,late\nc,2,early\n", "list.csv:3:1: name = b must be a row with mass"),
    ("name,parent,mass,configuration\na,,1,\nb,a,,\nc,b,2,early\nd,a,3,late\n", ""),
    ("name,parent,mass,Ixx,Iyy,Izz,about\na,,1,2,2,2,datum\ndatum,a,,,,,\n", ""),
    ("name,mass\na,1 250\n", "list.csv:2:3: \"1 250\" is not a number"),
    ("name,mass\na,1\u{a0}250.5 kg\n", "list.csv:2:3: "),
    ("name,mass,growth [%]\na,1,1 5\n", "list.csv:2:5: \"1 5\" is not a number"),
    ("name,mass\nframe,\n", "list.csv: no row has a mass"),
    (
        "name,mass\nb\u{200b}olt,1\n",
        "list.csv:2:1: name = b\u{fffd}olt must be a name of characters that can be seen",
    ),
    (
        "name,mass\n\"a\u{1b}[31mb\",1\n",
        "list.csv:2:1: name = a\u{fffd}[31mb must be a name of characters that can be seen",
    ),
    ("name,mass,\u{1b}[31m\na,1,\n", "list.csv:1:11: unknown key \"\\u{1b}[31m\" in the headings"),
    // Numbers that cannot be
    ("name,mass\na,-1\n", "list.csv:2:3: \"a\" cannot exist: the mass = -1 must be positive and finite"),
    ("name,mass\na,0\n", "list.csv:2:3: \"a\" cannot exist: the mass = 0 must be positive"),
    (
        "name,mass,quantity\na,1,0\n",
        "list.csv:2:5: quantity = 0 must be a whole number, 1 at least | leave out the row",
    ),
    ("name,mass,quantity\na,1,1.5\n", "list.csv:2:5: quantity = 1.5 must be a whole number"),
    ("name,mass,quantity,copies\na,1,2,same\n", "list.csv:2:7: copies = same must be alike or independent"),
    (
        "name,parent,quantity,copies,mass\na,,,,1\nb,a,2,independent,1\nc,b,1,,1.5\n",
        "list.csv:3:7: copies of \"b\" are to have independent errors, but \"c\" stands in it",
    ),
    ("name,mass,x\na,1,2\n", ""),
    (
        "name,mass,x,y,z\na,1,2,,3\n",
        "list.csv:2:5: x = 2 must be given with y, which is empty in this row | write 0 if it is zero",
    ),
    (
        "name,at x,at y,mass\na,,2,1\n",
        "list.csv:2:4: at y = 2 must be given with at x, which is empty in this row",
    ),
    ("name,mass,x\na,,2\n", "list.csv:2:4: x = 2 must be left out of a row without mass, or given with it"),
    // Errors
    (
        "name,mass\na,1 ± -0.1\n",
        "list.csv:2:3: mass = 1 ± -0.1 must be with an error that is zero or positive",
    ),
    (
        "name,mass,mass sd\na,1,-0.1\n",
        "list.csv:2:5: mass sd = -0.1 must be with an error that is zero or positive",
    ),
    (
        "name,mass,mass sd\na,1 ± 0.1,0.1\n",
        "list.csv:2:11: mass sd = 0.1 must be left out where the number has its error in its own cell",
    ),
    (
        "name,mass [g],mass sd\na,1,0.1\n",
        "list.csv:2:5: mass sd = 0.1 must be given with its unit, as the number that it is the error of is | write the unit into the heading, or 0.1 %",
    ),
    (
        "name,mass\na,1 kg ± 0.1\n",
        "list.csv:2:3: mass = 1 kg ± 0.1 must be a number and an error in one unit | write 1 kg ± 0.1 kg",
    ),
    (
        "name,mass,x\na,1,0 ± 5 %\n",
        "list.csv:2:5: x = 0 ± 5 % must be an amount, as a fraction of zero is none",
    ),
    ("name,mass,mass sd\na,,1\n", "list.csv:2:4: mass sd = 1 must be left out of a row without mass"),
    // Tensors
    ("name,mass,Ixx\na,1,1\n", "list.csv:2:5: Ixx = 1 must be given with a column iyy"),
    (
        "name,mass,Ixx,Iyy,Izz\na,1,1,1,\n",
        "list.csv:2:5: Ixx = 1 must be given with Izz, which is empty in this row",
    ),
    ("name,mass,Ixx,Iyy,Izz,Ixy\na,1,,,,1\n", "list.csv:2:8: Ixy = 1 must be given with Ixx, Iyy and Izz"),
    ("name,mass,Ixx,Iyy,Izz\na,1,1,1,3\n", "list.csv:2:5: \"a\" cannot exist:"),
    (
        "name,mass,x,y,z,Ixx,Iyy,Izz\na,1,1,0,0,1,1,1\n",
        "list.csv:2:11: is the tensor about the part's centre of mass, or about which other point?",
    ),
    (
        "name,mass,Ixx,Iyy,Izz,about\na,1,1,1,1,datum\n",
        "list.csv:2:11: \"a\" names the frame \"datum\", which is no row",
    ),
    (
        "name,mass,Ixx,Iyy,Izz,about\na,1,1,1,1,\"1 mm, 2, 3\"\n",
        "list.csv:2:11: about = 1 mm, 2, 3 must be three lengths, each with its unit",
    ),
    (
        "name,mass,Ixx,Iyy,Izz,Ixy,products\na,1,1,1,1,0.1,tensor element\n",
        "list.csv:2:15: products = tensor element must be one of tensor elements, positive integrals | did you mean \"tensor elements\"?",
    ),
    ("name,mass,Ixx,Iyy,Izz,Ixy\na,1,1,1,1,5\n", "list.csv:2:11:"),
    // Rotations
    ("name,mass,qw,qx,qy,qz\na,1,0,0,0,0\n", "list.csv:2:5: "),
    (
        "name,mass,qw,yaw\na,1,1,1\n",
        "list.csv:2:5: qw = 1 must be left out where the rotation is given by another column",
    ),
    ("name,mass,rotate\na,1,\"axis = [0, 0, 0], angle = '9 deg'\"\n", "list.csv:2:5: "),
    ("name,mass,rotate\na,1,about z\n", "list.csv:2:5: "),
    (
        "name,mass,rotate\na,1,\"axes = [0, 0, 1]\"\n",
        "list.csv:2:5: unknown key \"axes\" in rotate | did you mean axis?",
    ),
    // Growth, groups, configurations
    (
        "# growth = { E = 0.5 }\nname,parent,mass,maturity\nf,,,E\na,f,1,\n",
        "list.csv:3:5: maturity = E must be left out of a row without mass | a frame has no mass of its own: give it to the rows in it",
    ),
    ("name,parent,mass,growth\nf,,,0.2\na,f,1,\n", "list.csv:2:5: growth = 0.2 must be left out of a row"),
    (
        "# [[group]]\n# name = \"g\"\n# mass = 1\nname,parent,mass,group\nf,,,g\na,f,1 ± 0.1,g\n",
        "list.csv:5:5: group = g must be left out of a row without mass",
    ),
    (
        "# [[group]]\n# name = \"g\"\n# position = 1\nname,parent,mass,at x,group\nf,,,1 ± 0.2,g\na,f,1 ± 0.1,0,g\n",
        "",
    ),
    (
        "# growth = { E = 0.1 }\nname,mass,maturity,growth\na,1,Q,0.2\nb,1,E,\n",
        "list.csv:3:5: maturity = Q must be a code of the table of growth allowances, or left out | add the code",
    ),
    (
        "# [[group]]\n# name = \"wheels\"\n# mass = 1\nname,mass\na,1\n",
        "list.csv: group = \"wheels\" must be the group of a row, or of a tank | it has no effect",
    ),
    (
        "# ignore = [\"colour\"]\nname,mass,note\na,1,\n",
        "list.csv: ignore = \"colour\" must be the heading of a column, or the name of a sheet | it has no effect",
    ),
    (
        "# [cad]\n# products = \"tensor elements\"\nname,mass\na,1\n",
        "list.csv: cad = \"[cad]\" must be given with a column cad or file | it has no effect",
    ),
    (
        "name,mass,quantity,copies\na,1 ± 0.1,10001,independent\n",
        "list.csv:2:11: 10001 copies of \"a\" are to have independent errors, where 10000 at most can be drawn | say that",
    ),
    ("name,mass,quantity,copies\na,1,10001,independent\n", ""),
    ("name,mass,quantity,copies\na,1 ± 0.1,10000,independent\n", ""),
    ("name,mass\na,1e308\nb,1.5e308\n", "list.csv:3:3: the sum of all parts is no body: "),
    ("name,mass,x,y,z\na,1,1e200,0,0\nb,1,0,-2e200,0\n", "list.csv:3:7: the sum of all parts is no body: "),
    ("name,mass,growth\na,1,-0.1\n", "list.csv:2:5: growth = -0.1 must be zero or positive"),
    (
        "# growth = { C = 0.1 }\nname,mass,maturity,growth\na,1,C,0.2\n",
        "list.csv:3:7: growth = 0.2 must be that of its maturity code, 10 %, or left out",
    ),
    (
        "# growth = { C1 = 0.1 }\nname,mass,maturity\na,1,C2\n",
        "list.csv:3:5: \"a\" has the maturity code \"C2\", for which there is no growth allowance | add the code",
    ),
    (
        "# growth = { C = \"-1 %\" }\nname,mass\na,1\n",
        "list.csv:1:18: growth = \"-1 %\" must be zero or positive",
    ),
    (
        "name,mass,group\na,1,wheels\n",
        "list.csv:2:5: \"a\" is in the group \"wheels\", which is not declared",
    ),
    (
        "# [[group]]\n# name = \"wheels\"\n# mass = 1\nname,mass,group\na,1,wheel\n",
        "list.csv:5:5: \"a\" is in the group \"wheel\", which is not declared | did you mean \"wheels\"?",
    ),
    (
        "# [[group]]\n# name = \"g\"\n# mass = 1.5\nname,mass\na,1\n",
        "list.csv:3:10: mass = 1.5 must be from 0 to 1",
    ),
    (
        "# [[group]]\n# name = \"g\"\nname,mass\na,1\n",
        "list.csv:1:3: the key correlation is missing in [[group]]",
    ),
    ("# [[group]]\n# mass = 1\nname,mass\na,1\n", "list.csv:1:3: the key name is missing in [[group]]"),
    (
        "# configurations = [\"stowed\"]\nname,mass,configuration\na,1,stowd\n",
        "list.csv:3:5: configuration = stowd must be of stowed | did you mean stowed?",
    ),
    (
        "name,mass,configuration\na,1,\"a,,b\"\n",
        "list.csv:2:5: configuration = a,,b must be names of configurations",
    ),
    ("name,mass,subtotal,allowable\na,1,,-2\n", "list.csv:2:6: allowable = -2 must be positive"),
    // The head
    (
        "# titel = \"x\"\nname,mass\na,1\n",
        "list.csv:1:3: unknown key \"titel\" in the file | did you mean title?",
    ),
    ("# a list of parts\nname,mass\na,1\n", "list.csv:1:5: "),
    (
        "\"# title = \"\"x\"\"\",\nname,mass\na,1\n",
        "list.csv:1:1: expected a line that begins with #, found \"\\\"#\"",
    ),
    ("# coverage_factor = 0\nname,mass\na,1\n", "list.csv:1:21: coverage_factor = 0 must be positive"),
    (
        "# products = \"integrals\"\nname,mass\na,1\n",
        "list.csv:1:14: products = \"integrals\" must be one of tensor elements, positive integrals",
    ),
    ("# [result]\n# draws = 0\nname,mass\na,1\n", "list.csv:2:11: draws = 0 must be from 1 to 10000000"),
    (
        "# [result]\n# basis = \"worst\"\nname,mass\na,1\n",
        "list.csv:2:11: basis = \"worst\" must be one of basic, predicted",
    ),
    ("# [limts]\nname,mass\na,1\n", "list.csv:1:4: unknown key \"limts\" in the file"),
    (
        "# ignore = [\"a\", \"a\"]\nname,mass\na,1\n",
        "list.csv:1:18: ignore = \"a\" must be a name that does not stand there already",
    ),
    // Forms
    ("name,mass,shape,radius\na,1,spere,1\n", "list.csv:2:5: shape = \"spere\" must be one of"),
    (
        "name,mass,shape,radius,length\na,1,sphere,1,2\n",
        "list.csv:2:14: unknown key \"length\" in [[body.part]] of shape \"sphere\"",
    ),
    (
        "name,mass,shape\na,1,sphere\n",
        "list.csv:2:5: the key radius is missing in [[body.part]] of shape \"sphere\"",
    ),
    (
        "name,shape,radius,material\na,sphere,1,wod\n",
        "list.csv:2:12: material = \"wod\" must be a known material",
    ),
    ("name,mass,shape,radius\na,1,sphere,-1\n", "list.csv:2:12: radius = -1.0 must be positive"),
    ("name,mass,radius\na,1,2\n", "list.csv:2:5: radius = 2 must be left out of a part without a shape"),
    (
        "name,mass,shape,radius,Ixx,Iyy,Izz\na,1,sphere,1,1,1,1\n",
        "list.csv:2:14: Ixx = 1 must be left out where the part's form says it",
    ),
    (
        "name,mass,shape,radius,mesh\na,1,sphere,1,b.stl\n",
        "list.csv:2:14: mesh = b.stl must be left out where another column says what the part is",
    ),
    (
        "name,mass,mesh\na,1,lost.stl\n",
        "list.csv:2:5: cannot read \"lost.stl\": there is no such file | paths are relative",
    ),
    ("name,file\na,lost.toml\n", "list.csv:2:3: cannot read \"lost.toml\": there is no such file"),
    ("name,file\na,lost.txt\n", "list.csv:2:3: cannot read"),
    ("name,file,mass\na,open.txt,1\n", "list.csv:2:12: mass = 1 must be left out where a file says it"),
    (
        "name,file,x\na,open.txt,1\n",
        "list.csv:2:12: x = 1 must be left out where a file says where the centre of mass is",
    ),
    ("name,file\na,open.txt\n", "open.txt:"),
    ("name,mesh,mass\na,open.txt,1\n", "list.csv:2:3: file = \"open.txt\" must be a mesh file"),
    ("name,mesh,mass\na,bad.stl,1\n", "bad.stl"),
];

#[test]
fn each_mistake_is_named_where_it_is() {
    let folder = Folder::new("refusals");
    folder.write("open.txt", "Mass = 2.50 kilograms\nno more\n");
    folder.write("bad.stl", "solid x\nfacet nonsense\n");
    let mut wrong = Vec::new();
    for (list, expected) in LISTS {
        let found = match folder.read("list.csv", list) {
            Ok(_) => String::new(),
            Err(error) => error,
        };
        if !found.starts_with(expected) || expected.is_empty() != found.is_empty() {
            wrong.push(format!("{list}\n  found    {found}\n  expected {expected}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn no_hint_is_empty() {
    for (list, _) in LISTS {
        if let Err(error) = super::csv(list) {
            assert_ne!(error.hint().as_deref(), Some(""), "{list}");
        }
    }
    let draws = super::budget("name,mass\na,1 ± 0.1\n").draws(Basis::Basic, 1, 5).unwrap_err();
    assert!(draws.hint().is_some_and(|hint| !hint.is_empty()));
    let wide = super::budget("# coverage_factor = 1e-300\nname,mass\na,1 ± 0.1\n");
    assert!(wide.draws(Basis::Basic, 1, 10).unwrap_err().hint().is_some_and(|hint| !hint.is_empty()));
}

#[test]
fn a_list_has_so_many_configurations_at_most() {
    let folder = Folder::new("many");
    let list = |count: usize| {
        let rows: String = (0..count).map(|k| format!("a,1,number {k}\n")).collect();
        folder.read("list.csv", format!("name,mass,configuration\n{rows}"))
    };
    assert_eq!(list(100).unwrap().configurations.len(), 100);
    let error = list(101).unwrap_err();
    assert!(
        error.starts_with("list.csv:102:1: polhode does not read more than 100 configurations"),
        "{error}"
    );
}

#[test]
fn an_error_in_a_file_says_where_it_is_named() {
    let folder = Folder::new("named");
    folder.write("bad.stl", "solid x\nfacet nonsense\n");
    folder.write("open.txt", "Mass = 2.50 kilograms\nno more\n");
    for (list, end) in [
        ("name,mass,mesh\na,1,bad.stl\n", "(named in list.csv:2:5)"),
        ("name,cad\na,open.txt\n", "(named in list.csv:2:3)"),
    ] {
        let error = folder.read("list.csv", list).unwrap_err();
        assert!(error.contains(end), "{error}");
    }
}

#[test]
fn other_files_are_named_for_what_they_are() {
    let folder = Folder::new("kinds");
    let compound = folder.read("old.xls", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1 and more").unwrap_err();
    assert!(compound.starts_with("old.xls: polhode does not read workbooks of this kind: XLS"), "{compound}");
    let latin = folder.read("latin.csv", b"name,mass\nst\xfctze,1\n").unwrap_err();
    assert!(latin.starts_with("latin.csv:2:3: the file is not UTF-8 text"), "{latin}");
    let wide = folder.read("wide.csv", b"\xff\xfen\0a\0m\0e\0").unwrap_err();
    assert!(wide.starts_with("wide.csv: the file is text in UTF-16"), "{wide}");
}
