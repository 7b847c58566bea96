//! Numbers in buffers.
//!
//! The `gltf` crate's own readers trust component types and panic on views outside their buffer, so the bytes are
//! taken here with every bound checked.

use gltf::json::accessor::{Accessor, ComponentType, Type, sparse::Sparse};
use gltf::json::validation::Checked;
use gltf::json::{Index, Root, buffer};

use super::problem::Problem;

/// The most elements of one accessor; three million corners are far more than any piece of furniture has.
const MOST_ELEMENTS: usize = 3_000_000;

/// Reads accessors of a document.
#[derive(Clone, Copy, Debug)]
pub(super) struct Numbers<'a> {
    /// The document.
    pub(super) document: &'a Root,
    /// The bytes of each buffer.
    pub(super) buffers: &'a [Vec<u8>],
}

/// Where the elements of one kind lie.
struct Layout {
    component: ComponentType,
    components: usize,
    is_normalized: bool,
}

impl Numbers<'_> {
    /// All elements of an accessor as vectors; normalised integers become shares of one.
    pub(super) fn vectors<const N: usize>(&self, index: Index<Accessor>) -> Result<Vec<[f32; N]>, Problem> {
        let flat = self.flat(index, N)?;
        let vectors: Vec<[f32; N]> =
            flat.chunks_exact(N).map(|chunk| std::array::from_fn(|axis| chunk[axis] as f32)).collect();
        match vectors.iter().flatten().all(|value| value.is_finite()) {
            true => Ok(vectors),
            false => {
                Err(Problem::new(format!("accessor {} holds numbers that are not finite", index.value())))
            }
        }
    }

    /// All elements of an accessor as whole numbers.
    pub(super) fn indices(&self, index: Index<Accessor>) -> Result<Vec<u32>, Problem> {
        let flat = self.flat(index, 1)?;
        if flat.iter().any(|value| value.fract() != 0.0 || *value < 0.0) {
            return Err(Problem::new(format!(
                "accessor {} holds indices that are no whole numbers",
                index.value()
            )));
        }
        Ok(flat.into_iter().map(|value| value as u32).collect())
    }

    /// All components one after the other. Every component type is exact in 64 bits.
    fn flat(&self, index: Index<Accessor>, components: usize) -> Result<Vec<f64>, Problem> {
        let name = format!("accessor {}", index.value());
        let wrong = |what: &str| Problem::new(format!("{name} {what}"));
        let accessor = self.document.get(index).ok_or_else(|| wrong("does not exist"))?;
        let (Checked::Valid(component), Checked::Valid(kind)) = (accessor.component_type, accessor.type_)
        else {
            return Err(wrong("has an unknown type"));
        };
        if multiplicity(kind) != components {
            return Err(wrong(&format!("has {} components, {components} are needed", multiplicity(kind))));
        }
        let count = usize::try_from(accessor.count.0).unwrap_or(usize::MAX);
        if count > MOST_ELEMENTS {
            return Err(wrong(&format!("has {count} elements, over {MOST_ELEMENTS}")));
        }
        let layout = Layout { component: component.0, components, is_normalized: accessor.normalized };
        let offset = accessor.byte_offset.map_or(0, |offset| offset.0);
        let outside = || wrong("reaches over the end of its buffer");
        let mut values = match accessor.buffer_view {
            Some(view) => self.elements(view, offset, count, &layout).ok_or_else(outside)?,
            None => vec![0.0; count * components],
        };
        if let Some(sparse) = &accessor.sparse {
            self.substitute(&mut values, sparse, &layout)
                .ok_or_else(|| wrong("has sparse values out of bounds"))?;
        }
        Ok(values)
    }

    /// The elements of a view, or `None` if they reach over its end.
    fn elements(
        &self,
        view: Index<buffer::View>,
        offset: u64,
        count: usize,
        layout: &Layout,
    ) -> Option<Vec<f64>> {
        let view = self.document.get(view)?;
        let bytes = self.view_bytes(view)?;
        let bytes = bytes.get(usize::try_from(offset).ok()?..)?;
        let size = layout.component.size();
        let length = size * layout.components;
        let stride = view.byte_stride.map_or(length, |stride| stride.0.max(length));
        if count > 0 && (count - 1).checked_mul(stride)?.checked_add(length)? > bytes.len() {
            return None;
        }
        let mut values = Vec::with_capacity(count * layout.components);
        for element in 0..count {
            let start = element * stride;
            let components = bytes[start..start + length].chunks_exact(size);
            values.extend(components.map(|component| number(component, layout)));
        }
        Some(values)
    }

    /// The bytes of a view, or `None` if it reaches over its buffer.
    pub(super) fn view_bytes(&self, view: &buffer::View) -> Option<&[u8]> {
        let buffer = self.buffers.get(view.buffer.value())?;
        let start = usize::try_from(view.byte_offset.map_or(0, |offset| offset.0)).ok()?;
        let end = start.checked_add(usize::try_from(view.byte_length.0).ok()?)?;
        buffer.get(start..end)
    }

    fn substitute(&self, values: &mut [f64], sparse: &Sparse, layout: &Layout) -> Option<()> {
        let count = usize::try_from(sparse.count.0).ok().filter(|&count| count <= MOST_ELEMENTS)?;
        let Checked::Valid(component) = sparse.indices.component_type else { return None };
        let places = Layout { component: component.0, components: 1, is_normalized: false };
        let places =
            self.elements(sparse.indices.buffer_view, sparse.indices.byte_offset.0, count, &places)?;
        let new = self.elements(sparse.values.buffer_view, sparse.values.byte_offset.0, count, layout)?;
        for (place, element) in places.iter().zip(new.chunks_exact(layout.components)) {
            let start = (*place as usize).checked_mul(layout.components)?;
            values.get_mut(start..start.checked_add(layout.components)?)?.copy_from_slice(element);
        }
        Some(())
    }
}

fn multiplicity(kind: Type) -> usize {
    match kind {
        Type::Scalar => 1,
        Type::Vec2 => 2,
        Type::Vec3 => 3,
        Type::Vec4 | Type::Mat2 => 4,
        Type::Mat3 => 9,
        Type::Mat4 => 16,
    }
}

/// One component; signed shares reach −1 at both lowest integers, as the format says.
fn number(bytes: &[u8], layout: &Layout) -> f64 {
    let share = |value: f64, most: f64| if layout.is_normalized { (value / most).max(-1.0) } else { value };
    match (layout.component, bytes) {
        (ComponentType::I8, &[a]) => share(f64::from(i8::from_le_bytes([a])), f64::from(i8::MAX)),
        (ComponentType::U8, &[a]) => share(f64::from(a), f64::from(u8::MAX)),
        (ComponentType::I16, &[a, b]) => share(f64::from(i16::from_le_bytes([a, b])), f64::from(i16::MAX)),
        (ComponentType::U16, &[a, b]) => share(f64::from(u16::from_le_bytes([a, b])), f64::from(u16::MAX)),
        (ComponentType::U32, &[a, b, c, d]) => f64::from(u32::from_le_bytes([a, b, c, d])),
        (ComponentType::F32, &[a, b, c, d]) => f64::from(f32::from_le_bytes([a, b, c, d])),
        _ => f64::NAN,
    }
}
