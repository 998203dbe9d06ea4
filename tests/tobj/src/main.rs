//! Prints what the crate tobj reads of each OBJ file named, in the form that glint_dump_obj has: see README.md.

use std::io::{self, BufWriter, Write};
use std::panic;

/// As the file has it: polygons stay whole, each attribute keeps its own indices. Points and lines, which have no
/// surface, are left out.
const AS_WRITTEN: tobj::LoadOptions =
    tobj::LoadOptions { single_index: false, triangulate: false, ignore_points: true, ignore_lines: true };

/// The bit patterns of element `index` of a list of elements of `size` numbers.
fn bits(numbers: &[f32], size: usize, index: u32) -> String {
    let begin = index as usize * size;
    let element = &numbers[begin..begin + size];
    element.iter().map(|number| format!("{:08x}", number.to_bits())).collect()
}

/// What a face has at its corner: position/texture coordinate/normal.
fn corner(mesh: &tobj::Mesh, i: usize) -> String {
    let optional = |indices: &[u32], numbers: &[f32], size| {
        indices.get(i).map_or(String::new(), |&index| bits(numbers, size, index))
    };
    let position = bits(&mesh.positions, 3, mesh.indices[i]);
    let texcoord = optional(&mesh.texcoord_indices, &mesh.texcoords, 2);
    let normal = optional(&mesh.normal_indices, &mesh.normals, 3);
    format!("{position}/{texcoord}/{normal}")
}

fn print_mesh(out: &mut impl Write, mesh: &tobj::Mesh) -> io::Result<()> {
    let triangles = vec![3; mesh.indices.len() / 3];
    let arities = if mesh.face_arities.is_empty() { &triangles } else { &mesh.face_arities };
    let mut begin = 0;
    for arity in arities {
        let end = begin + *arity as usize;
        write!(out, "f")?;
        for i in begin..end {
            write!(out, " {}", corner(mesh, i))?;
        }
        writeln!(out)?;
        begin = end;
    }
    Ok(())
}

/// What a surface looks like, in the terms that Glint keeps: core/mesh/read_mtl.hpp says how they come from MTL's.
fn print_looks(out: &mut impl Write, material: &tobj::Material) -> io::Result<()> {
    let transparency = || material.unknown_param.get("Tr").and_then(|text| text.parse::<f32>().ok());
    let color = material.diffuse.unwrap_or([1.0; 3]);
    let highlight = material.specular.unwrap_or([0.0; 3]);
    let specular = highlight.iter().cloned().fold(0.0, f32::max);
    let highlight_color = if specular > 0.0 { highlight.map(|channel| channel / specular) } else { [1.0; 3] };
    let dissolve = material.dissolve.unwrap_or_else(|| 1.0 - transparency().unwrap_or(0.0));
    let ior = material.optical_density.unwrap_or(1.0);
    let ior = if ior >= 0.01 { ior } else { 1.0 };
    let single = |number: f32| bits(&[number], 1, 0);
    writeln!(
        out,
        "looks {} {} {} {} {} {} {}",
        bits(&color, 3, 0),
        single(specular),
        bits(&highlight_color, 3, 0),
        single(material.shininess.unwrap_or(1.0)),
        single(1.0 - dissolve),
        single(ior),
        if material.diffuse_texture.is_some() { "textured" } else { "plain" }
    )
}

/// The models one after another, each with its material; one that has none has no name.
fn print_models(out: &mut impl Write, models: &[tobj::Model], materials: &[tobj::Material]) -> io::Result<()> {
    for model in models {
        let material = model.mesh.material_id.map(|id| &materials[id]);
        writeln!(out, "material {}", material.map_or("", |material| &material.name))?;
        if let Some(material) = material {
            print_looks(out, material)?;
        }
        print_mesh(out, &model.mesh)?;
    }
    Ok(())
}

fn print_file(out: &mut impl Write, path: &str) -> io::Result<()> {
    writeln!(out, "file {path}")?;
    match panic::catch_unwind(|| tobj::load_obj(path, &AS_WRITTEN)) {
        Err(_) => writeln!(out, "refused: it panicked"),
        Ok(Err(error)) => writeln!(out, "refused: {error}"),
        // Where a library cannot be read, tobj still has the models, without materials.
        Ok(Ok((models, materials))) => print_models(out, &models, &materials.unwrap_or_default()),
    }
}

fn main() -> io::Result<()> {
    panic::set_hook(Box::new(|_| {})); // told of in the file's place
    let mut out = BufWriter::new(io::stdout().lock());
    writeln!(out, "keeps positions texcoords normals materials")?;
    for path in std::env::args().skip(1) {
        print_file(&mut out, &path)?;
    }
    out.flush()
}
