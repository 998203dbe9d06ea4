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

fn print_file(out: &mut impl Write, path: &str) -> io::Result<()> {
    writeln!(out, "file {path}")?;
    match panic::catch_unwind(|| tobj::load_obj(path, &AS_WRITTEN)) {
        Err(_) => writeln!(out, "refused: it panicked"),
        Ok(Err(error)) => writeln!(out, "refused: {error}"),
        Ok(Ok((models, _materials))) => models.iter().try_for_each(|model| print_mesh(out, &model.mesh)),
    }
}

fn main() -> io::Result<()> {
    panic::set_hook(Box::new(|_| {})); // told of in the file's place
    let mut out = BufWriter::new(io::stdout().lock());
    writeln!(out, "keeps positions texcoords normals")?;
    for path in std::env::args().skip(1) {
        print_file(&mut out, &path)?;
    }
    out.flush()
}
