//! Tests of the program `groundbeam`, in one test program: a file per subject, and what they share.

mod beginning;
mod check;
mod combinations;
mod command_line;
mod common;
mod documents;
mod page;
mod page_requests;
mod pdf;
mod pieces;
mod proven;
mod replay;
mod serve;
mod served;
mod solve;
mod study;
mod terminal;
mod units;
mod verify;
