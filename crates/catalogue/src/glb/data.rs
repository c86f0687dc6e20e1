//! Numbers in the binary chunk. Nothing is read, and no memory is taken, before all of it is known to be there.

use super::document::{Accessor, GlbDocument};
use crate::faults::{Fault, broken};
use scenelang_layout::Vec3;

const UNSIGNED_BYTE: u32 = 5121;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
const FLOAT: u32 = 5126;

/// The document with its numbers.
pub(super) struct Data<'d> {
    pub document: &'d GlbDocument,
    pub binary: &'d [u8],
}

impl<'d> Data<'d> {
    /// Three floats each.
    pub fn vectors(&self, index: usize) -> Result<Vec<Vec3>, Fault> {
        let accessor = self.accessor(index)?;
        if (accessor.component_type, accessor.kind.as_str()) != (FLOAT, "VEC3") {
            return Err(broken("its vertices are not given as three floats each"));
        }
        let number = |item: &[u8], i: usize| {
            f64::from(f32::from_le_bytes([item[4 * i], item[4 * i + 1], item[4 * i + 2], item[4 * i + 3]]))
        };
        Ok(self.items(accessor, 12)?.map(|item| Vec3::new(number(item, 0), number(item, 1), number(item, 2))).collect())
    }

    /// Corners of triangles.
    pub fn indices(&self, index: usize) -> Result<Vec<u32>, Fault> {
        let accessor = self.accessor(index)?;
        let width = match accessor.component_type {
            UNSIGNED_BYTE => 1,
            UNSIGNED_SHORT => 2,
            UNSIGNED_INT => 4,
            _ => return Err(broken("its triangles are not given as whole numbers")),
        };
        let number = |item: &[u8]| item.iter().rev().fold(0_u32, |n, byte| n << 8 | u32::from(*byte));
        Ok(self.items(accessor, width)?.map(number).collect())
    }

    fn accessor(&self, index: usize) -> Result<&'d Accessor, Fault> {
        let accessor = self.document.accessors.get(index);
        let accessor = accessor.ok_or_else(|| broken(format!("there is no accessor {index}")))?;
        if accessor.sparse.is_some() {
            return Err(broken("it has sparse accessors, which are not supported"));
        }
        Ok(accessor)
    }

    /// The items of an accessor, each of `width` bytes.
    fn items(&self, accessor: &Accessor, width: usize) -> Result<impl Iterator<Item = &'d [u8]> + use<'d>, Fault> {
        let view = accessor.buffer_view.and_then(|v| self.document.buffer_views.get(v));
        let view = view.ok_or_else(|| broken("it refers to numbers that are in no buffer"))?;
        let buffer = self.document.buffers.get(view.buffer).map_or(0, |b| b.byte_length);
        let whole = view.byte_offset.checked_add(view.byte_length).filter(|end| *end <= buffer);
        let whole = whole.and_then(|end| self.binary.get(view.byte_offset as usize..end as usize));
        let whole = whole.ok_or_else(|| broken("it refers to bytes beyond its buffer"))?;
        let stride = view.byte_stride.map_or(width, |s| usize::try_from(s).unwrap_or(0));
        if stride < width {
            return Err(broken(format!("its numbers are {stride} bytes apart, but {width} bytes long")));
        }
        let short = || broken(format!("it declares {} numbers, but there are fewer", accessor.count));
        let offset = usize::try_from(accessor.byte_offset).map_err(|_| short())?;
        let count = usize::try_from(accessor.count).map_err(|_| short())?;
        let end = match count {
            0 => Some(offset),
            _ => (count - 1).checked_mul(stride).and_then(|n| n.checked_add(width)?.checked_add(offset)),
        };
        let taken = end.and_then(|end| whole.get(offset..end)).ok_or_else(short)?;
        Ok((0..count).map(move |i| &taken[i * stride..i * stride + width]))
    }
}
