//! Question → room → answer: the protocol.
