//! Rows of numbers: molecules, particles, voxels, times.

use std::path::Path;

use polhode::body::mass_properties_of_particles;
use polhode_formats::molecule::{self, Isotopes, MoleculeFormat};
use polhode_formats::particles::{self, ParticleOptions};
use polhode_formats::voxel::{self, VoxelOptions};

use super::physical::{assert_physical, assert_written_is_read};

/// More voxels than this are not summed.
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
    if let Ok(times) = polhode_formats::times::parse(text, path) {
        let printed: String = times.iter().map(|time| format!("{time:?} s\n")).collect();
        assert!(times.iter().all(|time| time.is_finite()));
        assert_eq!(Ok(&times), polhode_formats::times::parse(&printed, path).as_ref());
    }
}
