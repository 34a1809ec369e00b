//! Bytes ↔ unchecked records; no geometry here.
