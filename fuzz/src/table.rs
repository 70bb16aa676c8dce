//! Rows of numbers: molecules, particles, voxels, times, parts lists.

use std::path::Path;

use polhode::body::mass_properties_of_particles;
use polhode_budget::read as budget;
use polhode_shape::molecule;
use polhode_shape::molecule::{Isotopes, MoleculeFormat};
use polhode_shape::particles;
use polhode_shape::particles::ParticleOptions;
use polhode_shape::voxel;
use polhode_shape::voxel::VoxelOptions;
use polhode_source::files::Memory;

use super::physical::{assert_physical, assert_written_is_read};

/// Largest number of voxels to be summed.
const MOST_VOXELS: usize = 20_000;

pub fn xyz(data: &[u8]) {
    molecule(data, MoleculeFormat::Xyz);
}

pub fn mol(data: &[u8]) {
    molecule(data, MoleculeFormat::Sdf);
}

pub fn pdb(data: &[u8]) {
    molecule(data, MoleculeFormat::Pdb);
}

fn molecule(data: &[u8], format: MoleculeFormat) {
    let read = || molecule::parse(data, format, Path::new("a.mol"));
    let Ok(molecules) = read() else { return };
    assert_eq!(Ok(&molecules), read().as_ref());
    for molecule in &molecules {
        let body = molecule.mass_properties(Isotopes::Abundant).unwrap();
        assert_physical(&body);
        let average = molecule.mass_properties(Isotopes::Average);
        assert!(average.is_ok_and(|average| (average.mass() / body.mass() - 1.0).abs() < 1.0));
        let constants = molecule.rotational_constants(Isotopes::Abundant).unwrap();
        for hertz in constants.iter().flat_map(polhode::observe::RotationalConstants::hertz).flatten() {
            assert!(hertz > 0.0, "{hertz:e} Hz");
        }
        assert!(!molecule.formula().is_empty());
        molecule.findings_with(Isotopes::Average).clear();
    }
}

pub fn particles(data: &[u8]) {
    let told = ParticleOptions { mass_unit: Some(0.001), length_unit: Some(0.01), total_mass: None };
    let shared = ParticleOptions { total_mass: Some(3.0), ..told };
    for options in [ParticleOptions::default(), told, shared] {
        let read = || particles::read(data, &options);
        let Ok(file) = read() else { continue };
        assert_eq!(Ok(&file), read().as_ref());
        if let Ok(body) = mass_properties_of_particles(&file.particles) {
            assert_physical(&body);
            assert_written_is_read(&body);
            let total = file.particles.iter().map(polhode::body::Particle::mass).sum::<f64>();
            assert!((body.mass() - total).abs() <= 1e-9 * total);
        }
    }
}

pub fn voxel(data: &[u8]) {
    let Ok(mut voxels) = voxel::read(data) else { return };
    let count = voxels.counts().iter().product::<usize>();
    let options = VoxelOptions { spacing: Some([0.1, 0.2, 0.3]), ..VoxelOptions::default() };
    for options in
        [VoxelOptions::default(), VoxelOptions { unit: Some(0.01), ..VoxelOptions::default() }, options]
    {
        let Ok(grid) = voxels.grid(&options) else { continue };
        if count <= MOST_VOXELS
            && let Ok(Ok(body)) = voxels.mass_properties(&grid, 1.5)
        {
            assert_physical(&body.properties);
        }
    }
    assert!(voxels.values().at(usize::MAX).is_ok_and(f64::is_nan));
}

pub fn times(data: &[u8]) {
    let Ok(text) = str::from_utf8(data) else { return };
    let path = Path::new("times.txt");
    if let Ok(times) = polhode_source::times::parse(text, path) {
        let printed: String = times.iter().map(|time| format!("{time:?} s\n")).collect();
        assert!(times.iter().all(|time| time.is_finite()));
        assert_eq!(Ok(&times), polhode_source::times::parse(&printed, path).as_ref());
    }
}

/// Checks a parts list, a workbook, or a sheet from which a workbook is built here.
///
/// Mutations of a compressed workbook would only fail its checksum, so sheets are mutated instead.
pub fn budget(data: &[u8]) {
    let workbook;
    let (path, data) = if data.starts_with(b"<") {
        workbook = packed(data);
        ("/nowhere/a.xlsx", &workbook[..])
    } else {
        ("/nowhere/a.csv", data)
    };
    let nothing = Memory::default();
    let alone = budget::Access { files: &nothing, roots: &[] };
    let read = || budget::from_bytes(alone, Path::new(path), data);
    let file = match read() {
        Ok(file) => file,
        Err(error) => {
            assert!(!error.to_string().is_empty());
            assert!(error.hint().is_none_or(|hint| !hint.is_empty()));
            return;
        }
    };
    assert_eq!(Ok(&file), read().as_ref());
    assert!(!file.configurations.is_empty() && !file.sources().is_empty());
    for one in &file.configurations {
        if let Ok(body) = one.budget.mass_properties(file.questions.basis) {
            assert_physical(&body);
        }
        if let Ok(estimate) = one.budget.estimate(file.questions.basis) {
            assert!((0..10).all(|k| !(estimate.covariance[k][k] < 0.0)), "{:?}", estimate.covariance);
        }
        let Some(prescribed) = &file.prescribed else { continue };
        let sequence = prescribed.sequence(one.name.as_deref(), file.questions.basis);
        let until = prescribed.over_time.as_ref().map_or(1.0, |all| all.until);
        if let Some(Ok(rows)) = sequence.map(|sequence| sequence.rows([0.0, until], 3)) {
            rows.iter().for_each(|row| assert_physical(&row.properties));
        }
        if let Ok(draws) = one.budget.draws(file.questions.basis, 1, 10) {
            draws.bodies.iter().for_each(assert_physical);
        }
    }
}

/// Returns a workbook with this sheet, as an archive of uncompressed entries.
fn packed(sheet: &[u8]) -> Vec<u8> {
    let entries: [(&str, &[u8]); 5] = [
        ("_rels/.rels", b"<R><Relationship Type=\"x/officeDocument\" Target=\"w.xml\"/></R>"),
        ("_rels/w.xml.rels", b"<R><Relationship Id=\"a\" Type=\"x/worksheet\" Target=\"a.xml\"/><Relationship Type=\"x/styles\" Target=\"t.xml\"/></R>"),
        ("w.xml", b"<workbook xmlns:r=\"x\"><sheets><sheet name=\"parts\" r:id=\"a\"/></sheets></workbook>"),
        ("t.xml", b"<s><cellXfs><xf numFmtId=\"0\"/><xf numFmtId=\"14\"/><xf numFmtId=\"10\"/><xf numFmtId=\"2\"/></cellXfs></s>"),
        ("a.xml", sheet),
    ];
    let (mut archive, mut directory) = (Vec::new(), Vec::new());
    for (name, bytes) in entries {
        let (offset, size) = (archive.len() as u32, (bytes.len() as u32).to_le_bytes());
        let mut header = vec![20, 0, 0, 0, 0, 0, 0, 0, 0x21, 0];
        header.extend(checksum(bytes).to_le_bytes());
        header.extend([size, size].concat());
        header.extend((name.len() as u32).to_le_bytes());
        archive.extend(b"PK\x03\x04");
        archive.extend(&header);
        archive.extend([name.as_bytes(), bytes].concat());
        directory.extend(b"PK\x01\x02\x14\0");
        directory.extend(&header);
        directory.extend([0; 10]);
        directory.extend(offset.to_le_bytes());
        directory.extend(name.as_bytes());
    }
    let (start, length) = (archive.len() as u32, directory.len() as u32);
    archive.extend(directory);
    archive.extend(b"PK\x05\x06\0\0\0\0\x05\0\x05\0");
    archive.extend([length.to_le_bytes(), start.to_le_bytes()].concat());
    archive.extend([0, 0]);
    archive
}

/// Returns the CRC-32 checksum.
fn checksum(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |sum, byte| {
        (0..8).fold(
            sum ^ u32::from(*byte),
            |sum, _| if sum & 1 == 1 { sum >> 1 ^ 0xedb8_8320 } else { sum >> 1 },
        )
    })
}
