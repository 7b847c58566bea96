//! The geometry of an object as faces in space.

use serde::Deserialize;
use serde_json::Value;

/// The places of a file by their numbers.
pub(super) type Vertices = Vec<[f64; 3]>;

/// A geometry; its boundaries are nested as its type says.
#[derive(Debug, Deserialize)]
pub(super) struct Geometry {
    #[serde(rename = "type", default)]
    kind: String,
    /// A number in version 1.0, a text since.
    lod: Option<Value>,
    #[serde(default)]
    boundaries: Value,
    semantics: Option<Semantics>,
}

#[derive(Debug, Deserialize)]
struct Semantics {
    #[serde(default)]
    surfaces: Vec<Surface>,
    #[serde(default)]
    values: Value,
}

#[derive(Debug, Deserialize)]
struct Surface {
    #[serde(rename = "type", default)]
    kind: String,
}

/// A face: its outer ring, then holes.
#[derive(Clone, Debug)]
pub(super) struct Face {
    pub(super) rings: Vec<Vec<[f64; 3]>>,
    /// Whether the file says that it is the ground of its building.
    pub(super) is_ground: bool,
}

impl Geometry {
    /// The level of detail; the highest where it is not said.
    pub(super) fn level(&self) -> f64 {
        match &self.lod {
            Some(Value::Number(number)) => number.as_f64().unwrap_or(f64::MAX),
            Some(Value::String(text)) => {
                text.parse().ok().filter(|level: &f64| level.is_finite()).unwrap_or(f64::MAX)
            }
            _ => f64::MAX,
        }
    }

    /// Whether it is of surfaces that enclose nothing.
    pub(super) fn is_of_surfaces(&self) -> bool {
        matches!(self.kind.as_str(), "MultiSurface" | "CompositeSurface")
    }

    /// Its faces; of solids the outer shells. Faces with vertices that are not there are left out.
    pub(super) fn faces(&self, vertices: &Vertices) -> Vec<Face> {
        let values = self.semantics.as_ref().map_or(&Value::Null, |semantics| &semantics.values);
        let mut faces = Vec::new();
        match self.kind.as_str() {
            "MultiSurface" | "CompositeSurface" => {
                self.add_shell(&self.boundaries, values, vertices, &mut faces)
            }
            "Solid" => self.add_solid(&self.boundaries, values, vertices, &mut faces),
            "MultiSolid" | "CompositeSolid" => {
                for (index, solid) in list(&self.boundaries).iter().enumerate() {
                    self.add_solid(solid, &values[index], vertices, &mut faces);
                }
            }
            _ => {}
        }
        faces
    }

    fn add_solid(&self, solid: &Value, values: &Value, vertices: &Vertices, faces: &mut Vec<Face>) {
        self.add_shell(&solid[0], &values[0], vertices, faces);
    }

    fn add_shell(&self, shell: &Value, values: &Value, vertices: &Vertices, faces: &mut Vec<Face>) {
        for (index, face) in list(shell).iter().enumerate() {
            let rings: Option<Vec<_>> = list(face).iter().map(|ring| ring_of(ring, vertices)).collect();
            let surface = values[index].as_u64().and_then(|number| {
                let surfaces = &self.semantics.as_ref()?.surfaces;
                surfaces.get(usize::try_from(number).ok()?)
            });
            let is_ground = surface.is_some_and(|surface| surface.kind == "GroundSurface");
            faces.extend(rings.filter(|rings| !rings.is_empty()).map(|rings| Face { rings, is_ground }));
        }
    }
}

fn ring_of(ring: &Value, vertices: &Vertices) -> Option<Vec<[f64; 3]>> {
    let vertex = |number: &Value| vertices.get(usize::try_from(number.as_u64()?).ok()?).copied();
    ring.as_array()?.iter().map(vertex).collect()
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}
