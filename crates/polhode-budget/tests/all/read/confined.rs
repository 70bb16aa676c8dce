//! A parts list opens files only in its own folder, and in those that the user allows.

use std::fs;

use polhode_budget::read::{Access, BudgetFile, read, read_in};
use polhode_source::files::Memory;

use super::Folder;

const TETRAHEDRON: &str =
    "OFF\n4 4 0\n0 0 0\n0.3 0 0\n0 0.4 0\n0 0 0.5\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
const SCENARIO: &str = "[[body.part]]\nshape = \"box\"\nsize = [1.1, 2, 3]\nmass = 1.7\n";
const REPORT: &str = "Mass = 2.5 kg\n";

#[test]
fn files_lie_in_the_folder_of_the_list() {
    let folder = Folder::new("confined");
    for inner in ["list", "list/inner", "elsewhere"] {
        fs::create_dir_all(folder.0.join(inner)).unwrap();
        folder.write(&format!("{inner}/part.off"), TETRAHEDRON);
        folder.write(&format!("{inner}/body.toml"), SCENARIO);
        folder.write(&format!("{inner}/report.txt"), REPORT);
    }
    let list = |column: &str, name: &str| {
        let extra = if column == "mesh" { (",density,unit", ",2700,m") } else { ("", "") };
        let text = format!("name,{column}{}\na,{name}{}\n", extra.0, extra.1);
        folder.write("list/parts.csv", text)
    };
    for (column, file) in [("mesh", "part.off"), ("scenario", "body.toml")] {
        for inside in [file.to_owned(), format!("inner/{file}"), format!("inner/../{file}")] {
            let path = list(column, &inside);
            assert!(read(&path).is_ok(), "{inside}: {:?}", read(&path).err().map(|e| folder.message(&e)));
        }
    }
    let absolute = |file: &str| folder.0.join("elsewhere").join(file).display().to_string();
    for (column, file) in [("mesh", "part.off"), ("scenario", "body.toml"), ("cad", "report.txt")] {
        for outside in
            [format!("../elsewhere/{file}"), absolute(file), format!("inner/../../elsewhere/{file}")]
        {
            let path = list(column, &outside);
            let error = folder.message(&read(&path).unwrap_err());
            assert!(
                error.contains("parts.csv:2:3") && error.contains("in the folder of the"),
                "{outside}: {error}"
            );
            assert!(error.contains("--root DIR"), "{error}");
        }
        let path = list(column, &format!("../elsewhere/{file}"));
        let roots = [folder.0.join("elsewhere")];
        // Other errors of the file do not matter here.
        let read = read_in(Access { roots: &roots, ..Access::BESIDE }, &path)
            .map_err(|error| folder.message(&error));
        assert!(!read.is_err_and(|error| error.contains("in the folder of the")));
    }
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(folder.0.join("elsewhere/part.off"), folder.0.join("list/link.off"))
            .unwrap();
        let error = folder.message(&read(&list("mesh", "link.off")).unwrap_err());
        assert!(error.contains("in the folder of the"), "{error}");
    }
}

#[test]
fn a_list_in_memory_is_the_one_on_the_disk() {
    let folder = Folder::new("in-memory");
    let list = "name,file,density,unit\na,part.off,2700,m\nb,body.toml,,\n";
    folder.write("part.off", TETRAHEDRON);
    folder.write("body.toml", SCENARIO);
    let on_disk = read(&folder.write("parts.csv", list)).unwrap();
    let memory =
        Memory::from([("in/parts.csv", list), ("in/part.off", TETRAHEDRON), ("in/body.toml", SCENARIO)]);
    let access = Access { files: &memory, roots: &[] };
    let in_memory = read_in(access, "in/parts.csv".as_ref()).unwrap();
    let body =
        |file: &BudgetFile| file.configurations[0].budget.mass_properties(file.questions.basis).unwrap();
    assert_eq!(body(&in_memory), body(&on_disk));
    let missing = Memory::from([("in/parts.csv", list), ("part.off", TETRAHEDRON)]);
    assert!(read_in(Access { files: &missing, roots: &[] }, "in/parts.csv".as_ref()).is_err());
}

/// The scenario that a list refers to is confined too. A plan that the user names may refer to any
/// list.
#[test]
fn what_it_names_is_confined_too() {
    let folder = Folder::new("confined-inner");
    fs::create_dir_all(folder.0.join("list")).unwrap();
    folder.write("part.off", TETRAHEDRON);
    let mesh = "[[body.part]]\nshape = \"mesh\"\nfile = \"../part.off\"\nunit = \"m\"\ndensity = 2700\n";
    folder.write("list/body.toml", mesh);
    let list = folder.write("list/parts.csv", "name,scenario\na,body.toml\n");
    let error = folder.message(&read(&list).unwrap_err());
    assert!(error.contains("in the folder of the data file"), "{error}");
    fs::create_dir_all(folder.0.join("plans")).unwrap();
    folder.write("list/parts.csv", "name,mass\na,1.5 kg\n");
    let plan = folder.write("plans/plan.toml", "parts = \"../list/parts.csv\"\n");
    assert!(read(&plan).is_ok());
    folder.write("list/parts.csv", "name,mesh,density,unit\na,../part.off,2700,m\n");
    assert!(folder.message(&read(&plan).unwrap_err()).contains("in the folder of the"));
}
