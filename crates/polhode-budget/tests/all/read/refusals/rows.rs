//! Refusals: headings, cells, trees, numbers and their errors, tensors, rotations.

/// List, and the start of the message; after the bar, the start of the hint.
pub(super) const ROWS: &[(&str, &str)] = &[
    // Headings
    ("", "list.csv: the file has no column with the heading \"name\", or \"path\""),
    ("mass\n1\n", "list.csv:1:1: the file has no column with the heading \"name\""),
    ("nmae,mass\na,1\n", "list.csv:1:1: unknown key \"nmae\" in the headings | did you mean name?"),
    (
        "name,maas [g]\na,1\n",
        "list.csv:1:6: unknown key \"maas [g]\" in the headings | did you mean mass? or add # ignore = [\"maas [g]\"]",
    ),
    (
        "name,mass,colour\na,1,red\n",
        "list.csv:1:11: unknown key \"colour\" in the headings | columns are name, mass",
    ),
    ("name,mass [mm]\na,1\n", "list.csv:1:6: \"mm\" is a length where a mass belongs | write a unit of mass"),
    ("name,mass [gg]\na,1\n", "list.csv:1:6: unknown unit \"gg\""),
    (
        "name,mass,Mass [g]\na,1,1\n",
        "list.csv:1:11: the heading = Mass [g] must be a column that is not given twice: it equals \"mass\"",
    ),
    ("name,path,mass\na,a,1\n", "list.csv:1:6: the heading = path must be a column that is not given twice"),
    ("name,mass,parent [kg]\na,1,\n", "list.csv:1:11: the heading = parent [kg] must be without a unit"),
    ("name,mass,quantity sd\na,1,1\n", "list.csv:1:11: unknown key \"quantity sd\""),
    ("name,mass,rotate x\na,1,1\n", "list.csv:1:11: unknown key \"rotate x\""),
    // Cells
    ("name,mass\na,1,2\n", "list.csv:2:5: a cell outside the columns = 2 must be under a heading"),
    ("name,mass\n\"a,1\n", "list.csv:2:1: expected a closing quote, found the end of the file"),
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
        "list.csv:2:3: is this a decimal mark or a thousands separator? The file has only 1,250 | write # decimal",
    ),
    (
        "# decimal = \"comma\"\nname;mass\na;1.250,5\n",
        "list.csv:3:3: mass = 1.250,5 must be a number with a decimal comma",
    ),
    // Names and trees
    ("name,mass\n,1\n", "list.csv:2:2: the file has no name in row 2 | write a sum in the column subtotal"),
    (
        "name,mass\na,1\nb,2\nTotal:,3\n",
        "list.csv:4:1: name = Total: must be the name of a part, not of a sum | write a sum",
    ),
    ("name,mass\na,1\na,2\n", "list.csv:3:1: rows 1 and 2 have the same name, \"a\""),
    (
        "name,parent,mass\na,,1\nb,,2\nc,b,3\n",
        "list.csv:3:1: \"a\" and \"b\" both have no parent: only one row can be the root | make one the parent",
    ),
    (
        "name,parent,mass\na,,1\nb,c,2\nc,d,2\nd,b,2\n",
        "list.csv:5:3: parents form a cycle: \"b\" in \"c\" in \"d\" in \"b\"",
    ),
    (
        "name,parent,mass\nbus,,1\nb,buss,2\n",
        "list.csv:3:3: \"b\" refers to the frame \"buss\", which is not a row | did you mean \"bus\"?",
    ),
    (
        "path,mass\nbus,\npod/cell,2\n",
        "list.csv:3:1: \"pod/cell\" refers to the frame \"pod\", which is not a row | add a row with this name",
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
        "list.csv:2:4: mass = 3.2 must be the mass of the part itself, but it is the sum of the rows inside it, which would be counted twice | write a sum in the column subtotal",
    ),
    ("name,parent,mass\nf,,3\na,f,3.2\n", ""),
    (
        "name,mass\na,1\nTotal (all),3\n",
        "list.csv:3:1: name = Total (all) must be the name of a part, not of a sum",
    ),
    (
        "name,mass\n# a,1\nb,2\n",
        "list.csv:2:1: name = # a must be without # in front, below the headings | remarks (##) belong above",
    ),
    ("name,mass\n#a,1\nb,2\n", "list.csv:2:1: name = #a must be without # in front"),
    ("name,mass\n\"#8 screw\",1\nb,2\n", ""),
    (
        "path,parent,mass\na,,1\nc,a,2\na/b,c,5\n",
        "list.csv:4:5: parent = c must be \"a\", as in the path, or left out | a name with / is a path",
    ),
    ("path,parent,mass\na,,1\na/b,a,5\n", ""),
    (
        "name,mass,quantity\na,1,\nb,,5\nc,2,\n",
        "list.csv:3:1: name = b must be a row with mass, or the parent of other rows | an empty frame has no effect",
    ),
    ("name,mass\na,1\n---,\n", "list.csv:3:1: name = --- must be a row with mass"),
    ("name,mass,configuration\na,1,\nb,,late\nc,2,early\n", "list.csv:3:1: name = b must be a row with mass"),
    ("name,parent,mass,configuration\na,,1,\nb,a,,\nc,b,2,early\nd,a,3,late\n", ""),
    ("name,parent,mass,Ixx,Iyy,Izz,about\na,,1,2,2,2,datum\ndatum,a,,,,,\n", ""),
    ("name,mass\na,1 250\n", "list.csv:2:3: \"1 250\" is not a number"),
    ("name,mass\na,1\u{a0}250.5 kg\n", "list.csv:2:3: "),
    ("name,mass,growth [%]\na,1,1 5\n", "list.csv:2:5: \"1 5\" is not a number"),
    ("name,mass\nframe,\n", "list.csv: no row has a mass"),
    ("name,mass\nb\u{200b}olt,1\n", "list.csv:2:1: name = b\u{fffd}olt must be a name of visible characters"),
    (
        "name,mass\n\"a\u{1b}[31mb\",1\n",
        "list.csv:2:1: name = a\u{fffd}[31mb must be a name of visible characters",
    ),
    ("name,mass,\u{1b}[31m\na,1,\n", "list.csv:1:11: unknown key \"\\u{1b}[31m\" in the headings"),
    // Numbers out of range
    ("name,mass\na,-1\n", "list.csv:2:3: \"a\" cannot exist: the mass = -1 must be positive and finite"),
    ("name,mass\na,0\n", "list.csv:2:3: \"a\" cannot exist: the mass = 0 must be positive"),
    (
        "name,mass,quantity\na,1,0\n",
        "list.csv:2:5: quantity = 0 must be an integer, at least 1 | delete the row",
    ),
    ("name,mass,quantity\na,1,1.5\n", "list.csv:2:5: quantity = 1.5 must be an integer"),
    ("name,mass,quantity,copies\na,1,2,same\n", "list.csv:2:7: copies = same must be alike or independent"),
    (
        "name,parent,quantity,copies,mass\na,,,,1\nb,a,2,independent,1\nc,b,1,,1.5\n",
        "list.csv:3:7: copies of \"b\" have independent errors, but \"c\" is inside it",
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
    ("name,mass\nbus,1\nbus/,2\n", "list.csv:3:1: name = bus/ must be a name, or names separated by /"),
    ("name,mass\nbus,1\nbus//a,2\n", "list.csv:3:1: name = bus//a must be a name, or names"),
    ("name,mass\n/bus,1\n", "list.csv:2:1: name = /bus must be a name, or names"),
    (
        "name,mass,shape,size\na,1,box,10 mm × 20 × 3 cm\n",
        "list.csv:2:9: size = 10 mm × 20 × 3 cm must be lengths with one unit at the end, or each with its own",
    ),
    (
        "name,mass,shape,size [mm]\na,1,box,10 cm × 20 × 3\n",
        "list.csv:2:9: size [mm] = 10 cm × 20 × 3 must be lengths with one unit at the end",
    ),
    ("name,mass,shape,size\na,1,box,10 mm × 20 cm × 3 m\n", ""),
    ("name,mass,shape,size [mm]\na,1,box,10 × 20 × 3 cm\n", ""),
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
        "list.csv:2:11: mass sd = 0.1 must be left out, because the number already has an error",
    ),
    (
        "name,mass [g],mass sd\na,1,0.1\n",
        "list.csv:2:5: mass sd = 0.1 must be given with a unit, like its number | write the unit in the heading, or 0.1 %",
    ),
    (
        "name,mass\na,1 kg ± 0.1\n",
        "list.csv:2:3: mass = 1 kg ± 0.1 must be a number and an error in one unit | write 1 kg ± 0.1 kg",
    ),
    (
        "name,mass,x\na,1,0 ± 5 %\n",
        "list.csv:2:5: x = 0 ± 5 % must be an absolute value: a percentage of zero is zero",
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
        "list.csv:2:11: is the tensor about the part's centre of mass or about another point?",
    ),
    (
        "name,mass,Ixx,Iyy,Izz,about\na,1,1,1,1,datum\n",
        "list.csv:2:11: \"a\" refers to the frame \"datum\", which is not a row",
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
];
