//! Refusals: growth, groups and configurations, the head, forms.

/// List, and the start of the message; after the bar, the start of the hint.
pub(super) const BESIDES: &[(&str, &str)] = &[
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
        "list.csv:2:10: group = \"wheels\" must be the group of a row, or of a tank | it has no effect",
    ),
    (
        "# ignore = [\"colour\"]\nname,mass,note\na,1,\n",
        "list.csv:1:13: ignore = \"colour\" must be the heading of a column, or the name of a sheet | it has no effect",
    ),
    (
        "# [cad]\n# products = \"tensor elements\"\nname,mass\na,1\n",
        "list.csv:1:3: cad = \"[cad]\" must be given with a column cad or file | it has no effect",
    ),
    (
        "name,mass,quantity,copies\na,1 ± 0.1,10001,independent\n",
        "list.csv:2:11: 10001 copies of \"a\" have independent errors, but at most 10000 can be drawn | set copies to alike",
    ),
    ("name,mass,quantity,copies\na,1,10001,independent\n", ""),
    ("name,mass,quantity,copies\na,1 ± 0.1,10000,independent\n", ""),
    ("name,mass\na,1e308\nb,1.5e308\n", "list.csv:3:3: the sum of all parts is not a physical body: "),
    (
        "name,mass,x,y,z\na,1,1e200,0,0\nb,1,0,-2e200,0\n",
        "list.csv:3:7: the sum of all parts is not a physical body: ",
    ),
    ("name,mass,growth\na,1,-0.1\n", "list.csv:2:5: growth = -0.1 must be zero or positive"),
    (
        "# growth = { C = 0.1 }\nname,mass,maturity,growth\na,1,C,0.2\n",
        "list.csv:3:7: growth = 0.2 must be that of its maturity code, 10 %, or left out",
    ),
    (
        "# growth = { C1 = 0.1 }\nname,mass,maturity\na,1,C2\n",
        "list.csv:3:5: \"a\" has the maturity code \"C2\", which has no growth allowance | add the code",
    ),
    (
        "name,mass,growth\na,1,15\n",
        "list.csv:2:5: growth = 15 must be in percent, because it is above 1 | 15 % is 0.15",
    ),
    ("name,mass,growth\na,1,150 %\n", ""),
    ("name,mass,growth [%]\na,1,150\n", ""),
    ("# growth = { E = 25 }\nname,mass,maturity\na,1,E\n", "list.csv:1:18: growth = 25 must be in percent"),
    ("# growth = { E = \"125 %\" }\nname,mass,maturity\na,1,E\n", ""),
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
        "list.csv:3:5: configuration = stowd must be one of stowed | did you mean stowed?",
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
    ("# [result]\n# draws = 0\nname,mass\na,1\n", "list.csv:2:11: draws = 0 must be from 10 to 10000000"),
    (
        "# [result]\n# basis = \"worst\"\nname,mass\na,1\n",
        "list.csv:2:11: basis = \"worst\" must be one of basic, predicted",
    ),
    (
        "# coverage_factor = 1e-300\nname,mass\na,1 ± 0.1\n",
        "list.csv:3:3: mass = 1 ± 0.1 must be with a standard deviation of 1e100 at most, in SI: it is 1e299 | the value after ± is divided by coverage_factor, 1e-300",
    ),
    (
        "name,mass,x,y,z\na,1,2 ± 1e101,0,0\n",
        "list.csv:2:5: x = 2 ± 1e101 must be with a standard deviation of 1e100 at most, in SI: it is 1e101 | check its exponent",
    ),
    (
        "name,mass,mass sd\na,1e-90,1e20\n",
        "list.csv:2:9: mass sd = 1e20 must be with a standard deviation of 1e10 at most, in SI: it is 1e20",
    ),
    ("# [limts]\nname,mass\na,1\n", "list.csv:1:4: unknown key \"limts\" in the file"),
    ("# ignore = [\"a\", \"a\"]\nname,mass\na,1\n", "list.csv:1:18: ignore = \"a\" must be listed only once"),
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
        "list.csv:2:14: Ixx = 1 must be left out, because the shape of the part gives it",
    ),
    (
        "name,mass,shape,radius,mesh\na,1,sphere,1,b.stl\n",
        "list.csv:2:14: mesh = b.stl must be left out, because another column defines the part",
    ),
    (
        "name,mass,mesh\na,1,lost.stl\n",
        "list.csv:2:5: cannot read \"lost.stl\": the file does not exist | paths are relative",
    ),
    ("name,file\na,lost.toml\n", "list.csv:2:3: cannot read \"lost.toml\": the file does not exist"),
    ("name,file\na,lost.txt\n", "list.csv:2:3: cannot read"),
    ("name,file,mass\na,open.txt,1\n", "list.csv:2:12: mass = 1 must be left out, because the file gives it"),
    (
        "name,file,x\na,open.txt,1\n",
        "list.csv:2:12: x = 1 must be left out, because the file gives the centre of mass",
    ),
    ("name,file\na,open.txt\n", "open.txt:"),
    ("name,mesh,mass\na,open.txt,1\n", "list.csv:2:3: file = \"open.txt\" must be a mesh file"),
    ("name,mesh,mass\na,bad.stl,1\n", "bad.stl"),
];
